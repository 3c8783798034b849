#include "io/frame_sequence.h"

#include <set>
#include <system_error>

#include "far/base/index.h"
#include "io/block_writer.h"
#include "io/output_file.h"
#include "io/written_frames.h"

namespace honeycomb::Io {
namespace fs = std::filesystem;

Result<std::unique_ptr<UnfinishedSequence>> UnfinishedSequence::open(const fs::path& name, FrameSequence sequence,
                                                                     const UnfinishedOptions& options) {
  Result<FrameJournal> journal =
      FrameJournal::open(besideOutput(name, "journal"), name.string(), options.asked, sequence.info.frameCount);
  if (!journal) return tl::unexpected<Error>(journal.error());
  std::unique_ptr<UnfinishedSequence> files(
      new UnfinishedSequence(std::move(*journal), name.string(), std::move(sequence)));
  std::vector<std::uint64_t> entries = files->earlier();
  std::set<fs::path> targets;
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(entries.size()); ++f) {
    const fs::path file = files->sequence_.file(f);
    std::error_code ignored;
    if (options.restart || !fs::is_regular_file(file, ignored)) entries[at(f)] = 0;
    if (entries[at(f)] == 0) targets.insert(file.filename());
  }
  if (files->found() != Found::nothing) removeAbandoned(name.parent_path(), targets);
  if (Result<void> begun = files->begin(entries); !begun) return tl::unexpected<Error>(begun.error());
  return files;
}

Result<void> UnfinishedSequence::finish() {
  if (Result<void> whole = checkWhole(); !whole) return whole;
  removeJournal();
  return {};
}

void UnfinishedSequence::discard() {
  const std::vector<std::uint64_t> entries = currentEntries();
  std::error_code ignored;
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(entries.size()); ++f)
    if (entries[at(f)] != 0) fs::remove(sequence_.file(f), ignored);
  UnfinishedFrames::discard();
}

Result<void> SequenceWriter::write(std::int32_t f, std::span<const float> points) {
  if (Result<void> sound = checkWritten(name_, sequence_.info, f, points); !sound) return sound;
  return sequence_.writeFrame(sequence_.file(f), points)
      .and_then([&] { return FrameJournal::enter(*journal_, f, frameChecksum(std::as_bytes(points))); })
      .and_then([&] { return sync_.afterWrite({journal_.get()}); });
}

}  // namespace honeycomb::Io
