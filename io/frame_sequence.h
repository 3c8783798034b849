#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "io/block_file.h"
#include "io/frame_names.h"
#include "io/frame_source.h"
#include "io/frame_writer.h"
#include "io/periodic_sync.h"
#include "io/unfinished_frames.h"

namespace honeycomb::Io {

/// Frames as a sequence of files.
struct FrameSequence {
  FrameNames names;
  std::int64_t firstNumber = 0;  ///< in the name of frame 0
  FrameInfo info;
  /// Writes one frame, under its name when whole; thread-safe.
  std::function<Result<void>(const std::filesystem::path&, std::span<const float> points)> writeFrame;

  /// The file of frame f, counted from 0.
  std::filesystem::path file(std::int32_t f) const { return names(firstNumber + f); }
};

/// The files of a sequence, each under its name as soon as it is whole: what lies beside them until finish() is the
/// journal alone.
class UnfinishedSequence : public UnfinishedFrames {
 public:
  /// Opens what is there or begins anew; a frame of an earlier run counts if its file is there. `name` is the pattern.
  /// Removes what a killed run left of files it had not finished. Errors: unwritable.
  static Result<std::unique_ptr<UnfinishedSequence>> open(const std::filesystem::path& name, FrameSequence sequence,
                                                          const UnfinishedOptions& options);
  Result<void> finish() override;
  /// Removes the frames it wrote too.
  void discard() override;

 private:
  UnfinishedSequence(FrameJournal journal, std::string name, FrameSequence sequence)
      : UnfinishedFrames(std::move(journal), std::move(name)), sequence_(std::move(sequence)) {}

  FrameSequence sequence_;
};

/// Writes the files of an UnfinishedSequence and enters them in its journal. Thread-safe, any order.
class SequenceWriter : public FrameWriter {
 public:
  SequenceWriter(std::string name, FrameSequence sequence, std::unique_ptr<BlockFile> journal)
      : name_(std::move(name)), sequence_(std::move(sequence)), journal_(std::move(journal)) {}

  Result<void> write(std::int32_t f, std::span<const float> points) override;
  Result<void> close() override { return journal_->close(); }

 private:
  std::string name_;
  FrameSequence sequence_;
  std::unique_ptr<BlockFile> journal_;
  PeriodicSync sync_;  // of the journal: each file is on the disk before it has its name
};

}  // namespace honeycomb::Io
