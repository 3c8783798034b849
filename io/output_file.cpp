#include "io/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <cstdint>
#include <cstdio>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "io/file_descriptor.h"
#include "io/system_error.h"

namespace honeycomb::Io {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
constexpr int kMaxLinks = 40;               // as Linux follows
constexpr int kMaxAttempts = 64;            // at a name nobody else uses
constexpr std::size_t kMaxNameBytes = 200;  // of the target's name in the temporary name; 255 are allowed in all

// Where the bytes of a path end up: beside `file`, to be renamed, or (direct) in an open file of this process.
struct Destination {
  fs::path file;
  bool direct = false;
};

bool isOpenFileLink(const fs::path& link) {
  const std::string& name = link.native();
  return name.starts_with("/proc/") || name.starts_with("/dev/fd/");
}

// Follows symbolic links, also to a file that is not there yet. Nothing where they run in circles.
std::optional<Destination> followLinks(fs::path path) {
  std::error_code error;
  for (int links = 0; links <= kMaxLinks; ++links) {
    if (!fs::is_symlink(fs::symlink_status(path, error))) return Destination{std::move(path), false};
    if (isOpenFileLink(path)) return Destination{std::move(path), true};
    fs::path next = fs::read_symlink(path, error);
    if (error) return std::nullopt;
    path = path.parent_path() / next;  // an absolute `next` replaces the whole
  }
  return std::nullopt;
}

fs::path temporaryName(const fs::path& target) {
  std::random_device random;
  const std::uint64_t unique = (std::uint64_t{random()} << 32) | random();
  const std::string name = target.filename().string().substr(0, kMaxNameBytes);
  return target.parent_path() / fmt::format(".{}.{:016x}.part", name, unique);
}

// fsync means nothing to pipes and devices, and not all file systems know it for folders.
bool syncToDisk(int fd) {
  return ::fsync(fd) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

void syncFolder(const fs::path& target) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.valid()) ::fsync(opened.get());
}

}  // namespace

struct OutputFile::State {
  explicit State(fs::path userPath) : path(std::move(userPath)) { buffer.reserve(kBufferBytes); }
  ~State() {
    if (!temporary.empty()) ::unlink(temporary.c_str());
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  Result<void> openDirect(const fs::path& file);
  Result<void> openBeside(const fs::path& file, const struct stat* existing);
  Result<void> writeAll(std::span<const std::byte> bytes);
  Result<void> flush();
  Result<void> putInPlace();
  tl::unexpected<Error> failed(int number) {
    failure = failSystem(ErrorCode::unwritable, path, number).value();
    return tl::unexpected<Error>(*failure);
  }

  fs::path path;  // as the user gave it, for messages
  fs::path target;
  fs::path temporary;  // empty when written directly and when nothing is left to remove
  FileDescriptor file;
  std::vector<std::byte> buffer;
  std::optional<Error> failure;
};

// Appending keeps what an open regular file already holds: `(echo; program) > file` through /dev/stdout.
Result<void> OutputFile::State::openDirect(const fs::path& name) {
  file = FileDescriptor(::open(name.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY));
  if (!file.valid()) return failed(errno);
  return {};
}

Result<void> OutputFile::State::openBeside(const fs::path& name, const struct stat* existing) {
  if (!name.has_filename()) return failed(EISDIR);
  // A rename would replace a write-protected file without asking.
  if (existing != nullptr && ::faccessat(AT_FDCWD, name.c_str(), W_OK, AT_EACCESS) != 0) return failed(errno);
  target = name;
  for (int attempt = 0; attempt < kMaxAttempts && !file.valid(); ++attempt) {
    fs::path candidate = temporaryName(target);
    file = FileDescriptor(::open(candidate.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.valid()) temporary = std::move(candidate);
    if (!file.valid() && errno != EEXIST) return failed(errno);
  }
  if (!file.valid()) return failed(EEXIST);
  if (existing != nullptr && ::fchmod(file.get(), existing->st_mode & 0777U) != 0) return failed(errno);
  return {};
}

Result<void> OutputFile::State::writeAll(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return failed(errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

Result<void> OutputFile::State::flush() {
  Result<void> written = writeAll(buffer);
  buffer.clear();
  return written;
}

Result<void> OutputFile::State::putInPlace() {
  if (!syncToDisk(file.get())) return failed(errno);
  if (!file.close()) return failed(errno);
  if (temporary.empty()) return {};
  if (::rename(temporary.c_str(), target.c_str()) != 0) return failed(errno);
  temporary.clear();
  syncFolder(target);
  return {};
}

OutputFile::OutputFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;
OutputFile::~OutputFile() = default;

Result<OutputFile> OutputFile::create(const fs::path& path) {
  auto state = std::make_unique<State>(path);
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && (errno != ENOENT || path.empty())) return state->failed(errno);
  if (exists && S_ISDIR(status.st_mode)) return state->failed(EISDIR);
  std::optional<Destination> destination = followLinks(path);
  if (!destination) return state->failed(ELOOP);
  const bool direct = destination->direct || (exists && !S_ISREG(status.st_mode));
  const Result<void> opened =
      direct ? state->openDirect(path) : state->openBeside(destination->file, exists ? &status : nullptr);
  if (!opened) return tl::unexpected<Error>(opened.error());
  return OutputFile(std::move(state));
}

Result<void> OutputFile::write(std::span<const std::byte> bytes) {
  if (state_->failure) return tl::unexpected<Error>(*state_->failure);
  if (!state_->file.valid()) return state_->failed(EBADF);
  if (state_->buffer.size() + bytes.size() > kBufferBytes) {
    if (Result<void> flushed = state_->flush(); !flushed) return flushed;
    if (bytes.size() >= kBufferBytes) return state_->writeAll(bytes);
  }
  state_->buffer.insert(state_->buffer.end(), bytes.begin(), bytes.end());
  return {};
}

Result<void> OutputFile::write(std::string_view text) {
  return write(std::as_bytes(std::span(text)));
}

Result<void> OutputFile::commit() {
  if (state_->failure) return tl::unexpected<Error>(*state_->failure);
  if (!state_->file.valid()) return state_->failed(EBADF);
  if (Result<void> flushed = state_->flush(); !flushed) return flushed;
  return state_->putInPlace();
}

}  // namespace honeycomb::Io
