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
#include "io/output_target.h"
#include "io/system_error.h"

namespace honeycomb::Io {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
constexpr std::string_view kSuffix = ".part";
constexpr int kMaxAttempts = 64;            // at a name nobody else uses
constexpr std::size_t kMaxNameBytes = 200;  // of the target's name in the temporary name; 255 are allowed in all

fs::path temporaryName(const fs::path& target) {
  std::random_device random;
  const std::uint64_t unique = (std::uint64_t{random()} << 32) | random();
  const std::string name = target.filename().string().substr(0, kMaxNameBytes);
  return target.parent_path() / fmt::format(".{}.{:016x}{}", name, unique, kSuffix);
}

// The name that a temporary name was made of; empty where it is none.
std::string_view targetName(std::string_view temporary) {
  constexpr std::size_t kDigits = 16, kAround = 2 + kDigits + kSuffix.size();
  if (temporary.size() <= kAround || !temporary.starts_with('.') || !temporary.ends_with(kSuffix)) return {};
  const std::string_view digits = temporary.substr(temporary.size() - kSuffix.size() - kDigits, kDigits);
  const std::size_t length = temporary.size() - kAround;
  const bool random = digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
  return random && temporary[1 + length] == '.' ? temporary.substr(1, length) : std::string_view{};
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
  Result<void> openBeside(const OutputTarget& destination);
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

Result<void> OutputFile::State::openBeside(const OutputTarget& destination) {
  target = destination.file;
  for (int attempt = 0; attempt < kMaxAttempts && !file.valid(); ++attempt) {
    fs::path candidate = temporaryName(target);
    file = FileDescriptor(::open(candidate.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.valid()) temporary = std::move(candidate);
    if (!file.valid() && errno != EEXIST) return failed(errno);
  }
  if (!file.valid()) return failed(EEXIST);
  if (destination.mode && ::fchmod(file.get(), *destination.mode) != 0) return failed(errno);
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
  syncFolderOf(target);
  return {};
}

OutputFile::OutputFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;
OutputFile::~OutputFile() = default;

Result<OutputFile> OutputFile::create(const fs::path& path) {
  const Result<OutputTarget> target = outputTarget(path);
  if (!target) return tl::unexpected<Error>(target.error());
  auto state = std::make_unique<State>(path);
  const Result<void> opened = target->direct ? state->openDirect(path) : state->openBeside(*target);
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

void removeAbandoned(const fs::path& folder, const std::set<fs::path>& names) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (names.contains(fs::path(targetName(name)))) fs::remove(entry.path(), ignored);
  }
}

}  // namespace honeycomb::Io
