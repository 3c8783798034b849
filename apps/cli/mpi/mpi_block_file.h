#pragma once

#define OMPI_SKIP_MPICXX
#include <fcntl.h>
#include <mpi.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <mutex>
#include <string>

#include "io/block_file.h"
#include "io/file_descriptor.h"
#include "io/system_error.h"

namespace honeycomb::Cli {

/// An error of MPI's about a file, in the system's words where the system had one.
inline tl::unexpected<Error> failMpi(const std::filesystem::path& name, int code, int systemError) {
  if (systemError != 0) return Io::failSystem(ErrorCode::unwritable, name, systemError);
  std::string text(MPI_MAX_ERROR_STRING, '\0');
  int length = 0;
  MPI_Error_string(code, text.data(), &length);
  text.resize(static_cast<std::size_t>(length));
  return fail(ErrorCode::unwritable, name.string() + ": cannot be written: " + text + "; try again");
}

/// A file that all ranks have open, through MPI-IO: each writes where it likes, without the others. MPI is called by
/// one thread at a time, whence the mutex.
class MpiBlockFile : public Io::BlockFile {
 public:
  /// `path` is the file's, `name` stands for it in messages.
  MpiBlockFile(MPI_File file, std::filesystem::path path, std::filesystem::path name, std::mutex& calls)
      : file_(file), path_(std::move(path)), name_(std::move(name)), calls_(calls) {}

  Result<void> writeAt(std::int64_t offset, std::span<const std::byte> bytes) override {
    const std::lock_guard lock(calls_);
    while (!bytes.empty()) {
      const std::span<const std::byte> piece = bytes.first(std::min(bytes.size(), kMostBytes));
      const int count = static_cast<int>(piece.size());
      MPI_Status status;
      errno = 0;
      const int code = MPI_File_write_at(file_, offset, piece.data(), count, MPI_BYTE, &status);
      int written = 0;
      if (code == MPI_SUCCESS) MPI_Get_count(&status, MPI_BYTE, &written);
      if (written != count) return failMpi(name_, code, errno);
      bytes = bytes.subspan(piece.size());
      offset += count;
    }
    return {};
  }
  // MPI_File_sync is collective: it would have a rank wait for the slowest. The system knows the file by its name, and
  // brings to the disk what this machine has written of it.
  Result<void> sync() override {
    const Io::FileDescriptor opened(::open(path_.c_str(), O_WRONLY | O_CLOEXEC));
    if (opened.valid() && ::fsync(opened.get()) == 0) return {};
    return Io::failSystem(ErrorCode::unwritable, name_, errno);
  }
  Result<void> close() override {
    const std::lock_guard lock(calls_);
    errno = 0;
    const int synced = MPI_File_sync(file_);
    const int systemError = errno;
    const int closed = MPI_File_close(&file_);
    if (synced != MPI_SUCCESS) return failMpi(name_, synced, systemError);
    if (closed != MPI_SUCCESS) return failMpi(name_, closed, errno);
    return {};
  }

 private:
  static constexpr std::size_t kMostBytes = std::size_t{1} << 30U;  // MPI counts in int

  MPI_File file_;
  std::filesystem::path path_, name_;
  std::mutex& calls_;
};

}  // namespace honeycomb::Cli
