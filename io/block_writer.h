#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "far/base/result.h"
#include "io/block_file.h"
#include "io/frame_layout.h"
#include "io/frame_writer.h"
#include "io/periodic_sync.h"

namespace honeycomb::Io {

/// The checksum of a frame's bytes as a FrameJournal enters it: never 0.
std::uint64_t frameChecksum(std::span<const std::byte> bytes);

/// Writes the frames of an UnfinishedFile, each to its place, and enters them in its journal: both opened by whoever
/// writes, one process of many perhaps. Both go to the disk from time to time, frames first. Thread-safe, any order.
class BlockWriter : public FrameWriter {
 public:
  /// `name` stands for the output in messages.
  BlockWriter(std::string name, std::shared_ptr<const FrameLayout> layout, std::unique_ptr<BlockFile> frames,
              std::unique_ptr<BlockFile> journal, std::chrono::steady_clock::duration syncEvery = kSyncEvery);

  Result<void> write(std::int32_t f, std::span<const float> points) override;
  Result<void> close() override;

 private:
  std::string name_;
  std::shared_ptr<const FrameLayout> layout_;
  std::unique_ptr<BlockFile> frames_;
  std::unique_ptr<BlockFile> journal_;
  PeriodicSync sync_;
};

}  // namespace honeycomb::Io
