#include "io/frame_journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <array>
#include <optional>
#include <span>
#include <utility>

#include "far/base/index.h"
#include "io/system_error.h"

namespace honeycomb::Io {
namespace {

constexpr std::array<char, 8> kJournalMagic{'H', 'O', 'N', 'E', 'Y', 'J', '1', '\n'};
constexpr std::size_t kMostNameBytes = 200;  // 255 are allowed in all

struct JournalHeader {
  std::array<char, 8> magic = kJournalMagic;
  std::uint64_t asked = 0;
  std::int32_t frames = 0;
  std::int32_t nothing = 0;
};
static_assert(sizeof(JournalHeader) == 24);

std::int64_t entryOffset(std::int32_t frame) {
  return static_cast<std::int64_t>(sizeof(JournalHeader) + at(frame) * sizeof(std::uint64_t));
}

// Bytes read, less than asked for at the end of the file only; -1 with errno set.
ssize_t readAt(int fd, std::int64_t offset, std::span<std::byte> bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::pread(fd, bytes.data() + done, bytes.size() - done, offset + static_cast<std::int64_t>(done));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return -1;
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  return static_cast<ssize_t>(done);
}

// Some file systems have no locks; there the user has to know.
bool locksOthersOut(int fd) {
  return ::flock(fd, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

// The run before may have removed it between our opening and our lock.
bool isStillThere(int fd, const std::filesystem::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(fd, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

}  // namespace

std::filesystem::path besideOutput(const std::filesystem::path& target, const std::string& kind) {
  return target.parent_path() / fmt::format(".{}.{}", target.filename().string().substr(0, kMostNameBytes), kind);
}

FrameJournal::FrameJournal(std::filesystem::path path, std::string name, FileDescriptor file)
    : path_(std::move(path)), name_(std::move(name)), file_(std::move(file)) {}

Result<FrameJournal> FrameJournal::open(const std::filesystem::path& file, std::string name, std::uint64_t asked,
                                        std::int32_t frameCount) {
  FileDescriptor opened;
  do {
    opened = FileDescriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    if (!opened.valid()) return failSystem(ErrorCode::unwritable, name, errno);
    if (!locksOthersOut(opened.get()))
      return fail(ErrorCode::unwritable,
                  fmt::format("{}: is being written by another run; wait for it or give another output", name));
  } while (!isStillThere(opened.get(), file));
  FrameJournal journal(file, std::move(name), std::move(opened));
  if (Result<void> read = journal.read(asked, frameCount); !read) return tl::unexpected<Error>(read.error());
  return journal;
}

Result<void> FrameJournal::read(std::uint64_t asked, std::int32_t frameCount) {
  asked_ = asked;
  entries_.assign(at(frameCount), 0);
  JournalHeader header;
  header.magic = {};
  const ssize_t size = readAt(file_.get(), 0, std::as_writable_bytes(std::span(&header, 1)));
  if (size < 0) return failSystem(ErrorCode::unwritable, name_, errno);
  if (header.magic != kJournalMagic) return {};  // new, or killed as it was begun
  const bool same = header.asked == asked && header.frames == frameCount;
  found_ = same ? Found::same : Found::other;
  if (!same) return {};
  return current().map([this](std::vector<std::uint64_t> entries) { entries_ = std::move(entries); });
}

Result<std::vector<std::uint64_t>> FrameJournal::current() const {
  std::vector<std::uint64_t> entries(entries_.size(), 0);
  if (readAt(file_.get(), entryOffset(0), std::as_writable_bytes(std::span(entries))) < 0)
    return failSystem(ErrorCode::unwritable, name_, errno);
  return entries;
}

Result<void> FrameJournal::begin(const std::vector<std::uint64_t>& entries) {
  entries_ = entries;
  JournalHeader header;
  header.asked = asked_;
  header.frames = static_cast<std::int32_t>(entries.size());
  // Entries that are kept are never away, not even for a moment.
  const bool written = (found_ == Found::same || ::ftruncate(file_.get(), 0) == 0) &&
                       writeAllAt(file_.get(), entryOffset(0), std::as_bytes(std::span(entries))) &&
                       writeAllAt(file_.get(), 0, std::as_bytes(std::span(&header, 1)));
  if (!written) return failSystem(ErrorCode::unwritable, name_, errno);
  return {};
}

void FrameJournal::remove() const {
  ::unlink(path_.c_str());
}

Result<void> FrameJournal::enter(BlockFile& file, std::int32_t frame, std::uint64_t checksum) {
  return file.writeAt(entryOffset(frame), std::as_bytes(std::span(&checksum, 1)));
}

}  // namespace honeycomb::Io
