#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>

#include "far/base/result.h"

namespace honeycomb::Io {

/// Where the bytes of an output end up.
struct OutputTarget {
  std::filesystem::path file;  ///< what `path` means once symbolic links are followed: to be renamed over
  bool direct = false;         ///< a device, a pipe or an open file of this process: written as it is, at its end
  std::optional<mode_t> mode;  ///< permissions of a file that is there, which its successor keeps
};

/// Follows symbolic links, also to a file that is not there yet. Errors: unwritable, naming `path`: a folder, a name
/// without a file, links in circles, a write-protected file (which a rename would replace without asking).
Result<OutputTarget> outputTarget(const std::filesystem::path& path);

/// Writes what the system still holds of a file to the disk. False, with errno set, where that failed; pipes and
/// devices, for which it means nothing, never fail.
bool syncToDisk(int fd);

/// The same for the entry of `file` in its folder, as far as the file system knows of that.
void syncFolderOf(const std::filesystem::path& file);

}  // namespace honeycomb::Io
