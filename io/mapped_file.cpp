#include "io/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <new>
#include <optional>

#include "io/file_descriptor.h"
#include "io/system_error.h"

namespace honeycomb::Io {
namespace {

constexpr std::size_t kReadBytes = std::size_t{1} << 20;

// Nothing, with errno set, when the system refuses.
std::optional<std::vector<std::byte>> readAll(const FileDescriptor& file) {
  std::vector<std::byte> bytes;
  for (std::size_t used = 0;;) {
    if (bytes.size() - used < kReadBytes) bytes.resize(used + used / 2 + kReadBytes);
    const ssize_t got = ::read(file.get(), bytes.data() + used, bytes.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    if (got == 0) {
      bytes.resize(used);
      return bytes;
    }
    used += static_cast<std::size_t>(got);
  }
}

}  // namespace

void MappedFile::Unmap::operator()(std::byte* address) const {
  ::munmap(address, size);
}

Result<MappedFile> MappedFile::open(const std::filesystem::path& path) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (!file.valid() || ::fstat(file.get(), &status) != 0) return failSystem(ErrorCode::unreadable, path, errno);
  if (S_ISDIR(status.st_mode)) return failSystem(ErrorCode::unreadable, path, EISDIR);
  const bool regular = S_ISREG(status.st_mode);
  if (!regular && !S_ISFIFO(status.st_mode)) {
    return fail(ErrorCode::unreadable, path.string() + ": is neither a file nor a pipe; name a file");
  }

  MappedFile result;
  const auto size = static_cast<std::size_t>(status.st_size);
  if (regular && size == 0) return result;
  void* address = regular ? ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.get(), 0) : MAP_FAILED;
  if (address != MAP_FAILED) {
    result.mapping_ = {static_cast<std::byte*>(address), Unmap{size}};
    result.bytes_ = {result.mapping_.get(), size};
    return result;
  }
  try {
    auto bytes = readAll(file);
    if (!bytes) return failSystem(ErrorCode::unreadable, path, errno);
    result.copy_ = std::move(*bytes);
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::outOfMemory, path.string() + ": does not fit into memory; store it in a file instead");
  }
  result.bytes_ = result.copy_;
  return result;
}

void MappedFile::expectSequentialReads() const {
  if (mapping_) ::madvise(mapping_.get(), bytes_.size(), MADV_SEQUENTIAL);
}

void MappedFile::release(std::size_t begin, std::size_t end) const {
  if (!mapping_) return;
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const std::size_t first = begin / page * page;
  const std::size_t last = end / page * page;
  if (first < last) ::madvise(mapping_.get() + first, last - first, MADV_DONTNEED);
}

}  // namespace honeycomb::Io
