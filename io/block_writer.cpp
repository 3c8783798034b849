#include "io/block_writer.h"

#include <utility>

#include "io/checksum.h"
#include "io/frame_journal.h"
#include "io/written_frames.h"

namespace honeycomb::Io {

std::uint64_t frameChecksum(std::span<const std::byte> bytes) {
  const std::uint64_t sum = checksum(bytes);
  return sum == 0 ? 1 : sum;
}

BlockWriter::BlockWriter(std::string name, std::shared_ptr<const FrameLayout> layout, std::unique_ptr<BlockFile> frames,
                         std::unique_ptr<BlockFile> journal, std::chrono::steady_clock::duration syncEvery)
    : name_(std::move(name)),
      layout_(std::move(layout)),
      frames_(std::move(frames)),
      journal_(std::move(journal)),
      sync_(syncEvery) {}

Result<void> BlockWriter::write(std::int32_t f, std::span<const float> points) {
  if (Result<void> sound = checkWritten(name_, layout_->info(), f, points); !sound) return sound;
  std::vector<std::byte> storage;
  const std::span<const std::byte> bytes = layout_->encode(f, points, storage);
  return frames_->writeAt(layout_->frameOffset(f), bytes)
      .and_then([&] { return FrameJournal::enter(*journal_, f, frameChecksum(bytes)); })
      .and_then([&] {
        return sync_.afterWrite({frames_.get(), journal_.get()});
      });
}

Result<void> BlockWriter::close() {
  Result<void> closed = frames_->close();
  Result<void> entered = journal_->close();  // both, whatever becomes of the first: others may wait for it
  return closed ? entered : closed;
}

}  // namespace honeycomb::Io
