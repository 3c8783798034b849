#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "far/base/result.h"
#include "io/block_file.h"
#include "io/file_descriptor.h"

namespace honeycomb::Io {

/// What a run of frames found of an earlier one that did not come to its end.
enum class Found { nothing, same, other };

/// Where `kind` of an output is kept until it is whole: ".NAME.kind" beside it.
std::filesystem::path besideOutput(const std::filesystem::path& target, const std::string& kind);

/// Which frames of an output are whole, on disk beside it, so that a run that was killed goes on where it stood:
///     | "HONEYJ1\n" 8 | what was asked 8 | frames 4 | 0 4 | a checksum of each frame 8, 0: it isn't there |
/// in the machine's byte order. A frame's checksum is written after the frame, and compared when the run goes on: that
/// needs no order of writes on the disk, so power may fail too. What it costs then is what has been written since the
/// last PeriodicSync.
class FrameJournal {
 public:
  /// Creates or opens it and locks out others that would write the same output. `asked` tells one task from another
  /// (a checksum of all it depends on); an earlier run's entries are taken over where that and the number of frames
  /// agree. `name` stands for the output in messages. Errors: unwritable, also while another run has it.
  static Result<FrameJournal> open(const std::filesystem::path& file, std::string name, std::uint64_t asked,
                                   std::int32_t frameCount);

  Found found() const { return found_; }
  /// The checksums as they were when it was opened, all 0 unless found() is same.
  const std::vector<std::uint64_t>& entries() const { return entries_; }
  /// The checksums as they are now, whoever wrote them. Errors: unwritable.
  Result<std::vector<std::uint64_t>> current() const;
  /// Begins with these entries: an earlier run's are forgotten. Errors: unwritable.
  Result<void> begin(const std::vector<std::uint64_t>& entries);
  /// Removes it from the disk.
  void remove() const;

  const std::filesystem::path& file() const { return path_; }
  /// Enters a frame through `file`, which is the journal opened by whoever wrote the frame. Thread-safe.
  static Result<void> enter(BlockFile& file, std::int32_t frame, std::uint64_t checksum);

 private:
  FrameJournal(std::filesystem::path path, std::string name, FileDescriptor file);
  Result<void> read(std::uint64_t asked, std::int32_t frameCount);

  std::filesystem::path path_;
  std::string name_;
  FileDescriptor file_;
  std::uint64_t asked_ = 0;
  std::vector<std::uint64_t> entries_;
  Found found_ = Found::nothing;
};

}  // namespace honeycomb::Io
