#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "far/base/result.h"
#include "io/frame_journal.h"
#include "io/frame_layout.h"
#include "io/output_target.h"

namespace honeycomb::Io {

/// How an output of frames begins.
struct UnfinishedOptions {
  std::uint64_t asked = 0;  ///< a checksum of all that the frames depend on, for FrameJournal
  bool restart = false;     ///< frames of an earlier run are dropped even where they could be used
};

/// An output of frames on its way: what it has lies beside its name, with a FrameJournal that says which frames are
/// whole, until finish(). Where the program is killed, or this destroyed, that stays, and the next run with the same
/// `asked` has only the missing frames to write. One process has it; the frames may be written by others too.
class UnfinishedFrames {
 public:
  virtual ~UnfinishedFrames() = default;

  /// What was there of an earlier run; `other`: of another task, which is dropped.
  Found found() const { return journal_.found(); }
  /// The frames to write, ascending.
  const std::vector<std::int32_t>& missing() const { return missing_; }
  /// How many frames are whole by now.
  std::int32_t wholeFrames() const;
  /// The journal, to be opened by those who write frames (FrameWriters enter them).
  const std::filesystem::path& journal() const { return journal_.file(); }

  /// Puts the output under its name. Errors: unwritable, also where frames are missing still.
  virtual Result<void> finish() = 0;
  /// Removes all there is of it.
  virtual void discard();

 protected:
  UnfinishedFrames(FrameJournal journal, std::string name) : journal_(std::move(journal)), name_(std::move(name)) {}
  UnfinishedFrames(const UnfinishedFrames&) = delete;
  UnfinishedFrames& operator=(const UnfinishedFrames&) = delete;

  /// Begins the journal: `entries` are those of frames that are there.
  Result<void> begin(const std::vector<std::uint64_t>& entries);
  Result<void> checkWhole() const;
  const std::string& name() const { return name_; }
  /// The journal as it is now; all 0 where it can't be read.
  std::vector<std::uint64_t> currentEntries() const;
  void removeJournal() const { journal_.remove(); }
  const std::vector<std::uint64_t>& earlier() const { return journal_.entries(); }

 private:
  FrameJournal journal_;
  std::string name_;
  std::vector<std::int32_t> missing_;
};

/// One file of a FrameLayout, beside its name as ".NAME.part".
class UnfinishedFile : public UnfinishedFrames {
 public:
  /// Opens what is there or begins anew; frames of an earlier run are read and compared with their checksums. Errors:
  /// unwritable; what outputTarget() refuses; invalidOption for what can't be written in any order, such as a pipe.
  static Result<std::unique_ptr<UnfinishedFile>> open(const std::filesystem::path& path,
                                                      std::shared_ptr<const FrameLayout> layout,
                                                      const UnfinishedOptions& options);
  /// Where the frames are until they are all there.
  const std::filesystem::path& partialFile() const { return part_; }

  Result<void> finish() override;
  void discard() override;

 private:
  UnfinishedFile(FrameJournal journal, std::string name, std::filesystem::path part, OutputTarget target,
                 std::shared_ptr<const FrameLayout> layout);
  Result<void> start(bool restart);
  std::vector<std::uint64_t> wholeEntries() const;

  std::filesystem::path part_;
  OutputTarget target_;
  std::shared_ptr<const FrameLayout> layout_;
};

}  // namespace honeycomb::Io
