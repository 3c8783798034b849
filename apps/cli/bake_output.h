#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "apps/cli/bake_formats.h"
#include "apps/cli/console.h"
#include "apps/cli/ranks.h"
#include "far/base/result.h"
#include "io/frame_writer.h"
#include "io/unfinished_frames.h"

namespace honeycomb::Cli {

/// Where a bake's frames go, on all of its ranks: rank 0 has what is unfinished, every rank a writer.
class BakeOutput {
 public:
  /// Collective. `path` is opened where it stood if what was `asked` is the same, else anew, which a note says. Errors:
  /// those of Io::UnfinishedFrames and, for what can only be written in order, Io::StreamWriter.
  static Result<BakeOutput> open(const std::string& path, const BakeFormat& format,
                                 const Io::UnfinishedOptions& options, Ranks& ranks, const Session& session);

  /// Frames still to write, ascending: the same on every rank.
  const std::vector<std::int32_t>& missing() const { return missing_; }
  Io::FrameWriter& writer() { return *writer_; }
  /// Collective, once no rank writes any more: puts all on the disk. Errors: unwritable.
  Result<void> close(Ranks& ranks);
  /// Rank 0's: puts the output under its name. Errors: unwritable.
  Result<void> finish();
  /// Rank 0's, after an error: keeps what another run can use, which the error it returns says, or removes it.
  Error giveUp(Error error);

 private:
  std::string path_;
  std::unique_ptr<Io::UnfinishedFrames> unfinished_;  // rank 0; null where frames go out in order
  std::unique_ptr<Io::FrameWriter> writer_;
  std::vector<std::int32_t> missing_;
};

/// Can the output be written in any order, and go on where it stood? Not pipes and devices.
bool anyOrder(const std::string& path);

}  // namespace honeycomb::Cli
