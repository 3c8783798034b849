#include "apps/cli/bake_output.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "apps/cli/interrupt.h"
#include "apps/cli/mesh_input.h"
#include "io/block_writer.h"
#include "io/output_target.h"
#include "io/stream_writer.h"

namespace honeycomb::Cli {
namespace {

template <class Unfinished>
Result<std::unique_ptr<Io::UnfinishedFrames>> asFrames(Result<std::unique_ptr<Unfinished>> opened) {
  if (!opened) return tl::unexpected(opened.error());
  return std::unique_ptr<Io::UnfinishedFrames>(std::move(*opened));
}

Result<std::unique_ptr<Io::UnfinishedFrames>> openUnfinished(const std::string& path, const BakeFormat& format,
                                                             const Io::UnfinishedOptions& options) {
  if (format.sequence) return asFrames(Io::UnfinishedSequence::open(path, *format.sequence, options));
  return asFrames(Io::UnfinishedFile::open(path, format.layout, options));
}

void noteWhatWasFound(const Io::UnfinishedFrames& frames, const std::string& path, std::int32_t all,
                      const Io::UnfinishedOptions& options, const Session& session) {
  if (frames.found() == Io::Found::other)
    printNote(session, fmt::format("{}: what is there of another bake is dropped", path));
  const std::int64_t whole = all - std::ssize(frames.missing());
  if (frames.found() == Io::Found::same && !options.restart)
    printNote(session, fmt::format("{}: goes on behind {} of {}", path, grouped(whole), counted(all, "frame")));
}

/// A writer of this rank's; collective, since files are opened by all ranks together.
Result<std::unique_ptr<Io::FrameWriter>> openWriter(const std::string& path, const BakeFormat& format, Ranks& ranks) {
  const Result<Io::OutputTarget> target = Io::outputTarget(path);
  const std::filesystem::path file = target && !format.sequence ? target->file : std::filesystem::path(path);
  auto journal = ranks.open(Io::besideOutput(file, "journal"), path);
  if (format.sequence) {
    if (!journal) return tl::unexpected(journal.error());
    return std::make_unique<Io::SequenceWriter>(path, *format.sequence, std::move(*journal));
  }
  auto frames = ranks.open(Io::besideOutput(file, "part"), path);
  if (!journal) return tl::unexpected(journal.error());
  if (!frames) return tl::unexpected(frames.error());
  return std::make_unique<Io::BlockWriter>(path, format.layout, std::move(*frames), std::move(*journal));
}

}  // namespace

bool anyOrder(const std::string& path) {
  const Result<Io::OutputTarget> target = Io::outputTarget(path);
  return !target || !target->direct;
}

Result<BakeOutput> BakeOutput::open(const std::string& path, const BakeFormat& format,
                                    const Io::UnfinishedOptions& options, Ranks& ranks, const Session& session) {
  BakeOutput output;
  output.path_ = path;
  const std::int32_t all = format.sequence ? format.sequence->info.frameCount : format.layout->info().frameCount;
  if (format.layout && ranks.size() == 1 && !anyOrder(path)) {
    output.missing_.resize(static_cast<std::size_t>(all));
    std::iota(output.missing_.begin(), output.missing_.end(), 0);
    return Io::StreamWriter::create(path, format.layout).map([&](Io::StreamWriter writer) {
      output.writer_ = std::make_unique<Io::StreamWriter>(std::move(writer));
      return std::move(output);
    });
  }
  Result<void> opened;
  if (ranks.rank() == 0) {
    auto unfinished = openUnfinished(path, format, options);
    if (!unfinished) opened = tl::unexpected(unfinished.error());
    if (unfinished) {
      noteWhatWasFound(**unfinished, path, all, options, session);
      output.missing_ = (*unfinished)->missing();
      output.unfinished_ = std::move(*unfinished);
    }
  }
  if (opened = ranks.agree(opened, 0); !opened) return tl::unexpected(opened.error());
  if (const auto shared = ranks.share(output.missing_); !shared) return tl::unexpected(shared.error());
  auto writer = openWriter(path, format, ranks);
  if (writer) output.writer_ = std::move(*writer);
  opened = ranks.agree(writer.map([](const auto&) {}), 0);
  if (!opened) return tl::unexpected(opened.error());
  return output;
}

Result<void> BakeOutput::close(Ranks& ranks) {
  return ranks.agree(writer_->close(), 0);
}

Result<void> BakeOutput::finish() {
  return unfinished_ ? unfinished_->finish() : Result<void>{};
}

Error BakeOutput::giveUp(Error error) {
  if (!unfinished_) return error;
  const std::int32_t whole = unfinished_->wholeFrames();
  const bool useful = whole > 0 && (error.code == ErrorCode::unwritable || interruptSignal() != 0);
  if (!useful) {
    unfinished_->discard();
    return error;
  }
  error = inFile(path_, std::move(error));
  error.message += fmt::format(" ({} whole; the same command goes on with the others)",
                               whole == 1 ? "1 frame is" : fmt::format("{} frames are", grouped(whole)));
  return error;
}

}  // namespace honeycomb::Cli
