#include "io/output_target.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>
#include <utility>

#include "io/file_descriptor.h"
#include "io/system_error.h"

namespace honeycomb::Io {
namespace fs = std::filesystem;
namespace {

constexpr int kMaxLinks = 40;  // as Linux follows

bool isOpenFileLink(const fs::path& link) {
  const std::string& name = link.native();
  return name.starts_with("/proc/") || name.starts_with("/dev/fd/");
}

// Nothing where the links run in circles.
std::optional<OutputTarget> followLinks(fs::path path) {
  std::error_code error;
  for (int links = 0; links <= kMaxLinks; ++links) {
    if (!fs::is_symlink(fs::symlink_status(path, error))) return OutputTarget{std::move(path), false, {}};
    if (isOpenFileLink(path)) return OutputTarget{std::move(path), true, {}};
    fs::path next = fs::read_symlink(path, error);
    if (error) return std::nullopt;
    path = path.parent_path() / next;  // an absolute `next` replaces the whole
  }
  return std::nullopt;
}

}  // namespace

Result<OutputTarget> outputTarget(const fs::path& path) {
  const auto refuse = [&path](int number) { return failSystem(ErrorCode::unwritable, path, number); };
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && (errno != ENOENT || path.empty())) return refuse(errno);
  if (exists && S_ISDIR(status.st_mode)) return refuse(EISDIR);
  std::optional<OutputTarget> target = followLinks(path);
  if (!target) return refuse(ELOOP);
  target->direct = target->direct || (exists && !S_ISREG(status.st_mode));
  if (target->direct) return *target;
  if (!target->file.has_filename()) return refuse(EISDIR);
  if (!exists) return *target;
  if (::faccessat(AT_FDCWD, target->file.c_str(), W_OK, AT_EACCESS) != 0) return refuse(errno);
  target->mode = status.st_mode & 0777U;
  return *target;
}

bool syncToDisk(int fd) {
  return ::fsync(fd) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

void syncFolderOf(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.valid()) ::fsync(opened.get());
}

}  // namespace honeycomb::Io
