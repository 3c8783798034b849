#include "io/unfinished_frames.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <utility>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "io/block_writer.h"
#include "io/mapped_file.h"
#include "io/system_error.h"

namespace honeycomb::Io {
namespace fs = std::filesystem;

std::vector<std::uint64_t> UnfinishedFrames::currentEntries() const {
  return journal_.current().value_or(std::vector<std::uint64_t>(journal_.entries().size(), 0));
}

std::int32_t UnfinishedFrames::wholeFrames() const {
  const std::vector<std::uint64_t> entries = currentEntries();
  return static_cast<std::int32_t>(std::ssize(entries) - std::count(entries.begin(), entries.end(), 0U));
}

Result<void> UnfinishedFrames::begin(const std::vector<std::uint64_t>& entries) {
  missing_.clear();
  for (std::size_t f = 0; f < entries.size(); ++f)
    if (entries[f] == 0) missing_.push_back(static_cast<std::int32_t>(f));
  return journal_.begin(entries).map([this] { syncFolderOf(journal_.file()); });
}

Result<void> UnfinishedFrames::checkWhole() const {
  const std::int32_t whole = wholeFrames(), all = static_cast<std::int32_t>(earlier().size());
  if (whole == all) return {};
  return fail(ErrorCode::unwritable,
              fmt::format("{}: only {} of {} frames were written; write them all before finish", name_, whole, all));
}

void UnfinishedFrames::discard() {
  journal_.remove();
}

UnfinishedFile::UnfinishedFile(FrameJournal journal, std::string name, fs::path part, OutputTarget target,
                               std::shared_ptr<const FrameLayout> layout)
    : UnfinishedFrames(std::move(journal), std::move(name)),
      part_(std::move(part)),
      target_(std::move(target)),
      layout_(std::move(layout)) {}

Result<std::unique_ptr<UnfinishedFile>> UnfinishedFile::open(const fs::path& path,
                                                             std::shared_ptr<const FrameLayout> layout,
                                                             const UnfinishedOptions& options) {
  Result<OutputTarget> target = outputTarget(path);
  if (!target) return tl::unexpected<Error>(target.error());
  if (target->direct)
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: is no file in a folder, so its frames can't be written in any order; give one",
                            path.string()));
  Result<FrameJournal> journal = FrameJournal::open(besideOutput(target->file, "journal"), path.string(), options.asked,
                                                    layout->info().frameCount);
  if (!journal) return tl::unexpected<Error>(journal.error());
  fs::path part = besideOutput(target->file, "part");
  std::unique_ptr<UnfinishedFile> file(
      new UnfinishedFile(std::move(*journal), path.string(), std::move(part), std::move(*target), std::move(layout)));
  if (Result<void> started = file->start(options.restart); !started) {
    // What an earlier run left stays for the next.
    if (file->found() != Found::same) file->discard();
    return tl::unexpected<Error>(started.error());
  }
  return file;
}

Result<void> UnfinishedFile::start(bool restart) {
  const bool anew = restart || found() != Found::same;
  const std::vector<std::uint64_t> entries = anew ? std::vector<std::uint64_t>(earlier().size(), 0) : wholeEntries();
  const int flags = O_WRONLY | O_CREAT | O_CLOEXEC | (anew ? O_TRUNC : 0);
  const FileDescriptor opened(::open(part_.c_str(), flags, 0666));
  if (!opened.valid() || (target_.mode && ::fchmod(opened.get(), *target_.mode) != 0))
    return failSystem(ErrorCode::unwritable, name(), errno);
  return openBlockFile(part_, name())
      .and_then([this](const std::unique_ptr<BlockFile>& file) { return file->writeAt(0, layout_->header()); })
      .and_then([&] { return begin(entries); });
}

// A frame that the disk hasn't, whatever the journal says, is written again.
std::vector<std::uint64_t> UnfinishedFile::wholeEntries() const {
  std::vector<std::uint64_t> entries(earlier().size(), 0);
  const Result<MappedFile> file = MappedFile::open(part_);
  if (!file) return entries;
  Parallel::forEach(
      0, std::ssize(entries),
      [&](std::int64_t f) {
        const std::int64_t begin = layout_->frameOffset(static_cast<std::int32_t>(f)), size = layout_->frameBytes();
        if (earlier()[at(f)] == 0 || std::ssize(file->bytes()) < begin + size) return;
        if (frameChecksum(file->bytes().subspan(at(begin), at(size))) == earlier()[at(f)])
          entries[at(f)] = earlier()[at(f)];
        file->release(at(begin), at(begin + size));
      },
      1);
  return entries;
}

Result<void> UnfinishedFile::finish() {
  if (Result<void> whole = checkWhole(); !whole) return whole;
  if (Result<void> completed = layout_->complete(part_); !completed) return completed;
  FileDescriptor opened(::open(part_.c_str(), O_WRONLY | O_CLOEXEC));
  const bool inPlace = opened.valid() && syncToDisk(opened.get()) && opened.close() &&
                       ::rename(part_.c_str(), target_.file.c_str()) == 0;
  if (!inPlace) return failSystem(ErrorCode::unwritable, name(), errno);
  syncFolderOf(target_.file);
  removeJournal();
  return {};
}

void UnfinishedFile::discard() {
  ::unlink(part_.c_str());
  UnfinishedFrames::discard();
}

}  // namespace honeycomb::Io
