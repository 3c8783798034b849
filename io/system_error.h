#pragma once

#include <cerrno>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "far/base/result.h"

namespace honeycomb::Io {

/// What a user can do about an error of the system.
inline std::string_view remedyOf(int number) {
  switch (number) {
    case ENOENT:
    case ENOTDIR:
    case ENAMETOOLONG:
    case ELOOP:
      return "check the path";
    case EACCES:
    case EPERM:
      return "check the permissions";
    case EISDIR:
      return "name a file";
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "free some space or choose another place";
    default:
      return "try again or choose another place";
  }
}

/// "PATH: cannot be read: No such file or directory; check the path" from an errno value.
/// `code` is unreadable or unwritable and gives the verb.
inline tl::unexpected<Error> failSystem(ErrorCode code, const std::filesystem::path& path, int number) {
  const std::string_view verb = code == ErrorCode::unreadable ? "read" : "written";
  std::string message = path.string();
  message.append(": cannot be ").append(verb).append(": ").append(std::generic_category().message(number));
  message.append("; ").append(remedyOf(number));
  return fail(code, std::move(message));
}

}  // namespace honeycomb::Io
