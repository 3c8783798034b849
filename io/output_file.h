#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <set>
#include <span>
#include <string_view>

#include "far/base/result.h"

namespace honeycomb::Io {

/// A file that is written beside its final name (as ".NAME.RANDOM.part") and renamed into place when whole, so that
/// neither a crash, a full disk nor an error ever leaves half a file under the name the user gave. Buffered.
///
/// A new file has the permissions the process's umask leaves; a file that is replaced keeps its own. A symbolic link is
/// written through: it stays, and what it points at is replaced. What can't be replaced - a device, a pipe, an open
/// file such as /dev/stdout - is written directly, at its end.
class OutputFile {
 public:
  /// Errors: unwritable, naming `path` and the system's reason; also for a directory and for a write-protected file.
  static Result<OutputFile> create(const std::filesystem::path& path);
  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) noexcept;
  /// Removes the temporary file unless commit() succeeded.
  ~OutputFile();

  /// Appends. Errors: unwritable (disk full and the like); once one occurred, every later call returns it too.
  Result<void> write(std::span<const std::byte> bytes);
  /// The same of text.
  Result<void> write(std::string_view text);
  /// Flushes to disk and renames; nothing can be written afterwards. Errors: unwritable.
  Result<void> commit();

 private:
  struct State;
  explicit OutputFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Removes from `folder` what programs that were killed have left of OutputFiles for files of these names in it. None
/// of them may be being written.
void removeAbandoned(const std::filesystem::path& folder, const std::set<std::filesystem::path>& names);

}  // namespace honeycomb::Io
