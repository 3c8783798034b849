#include "io/stream_writer.h"

#include <fmt/format.h>

#include "io/written_frames.h"

namespace honeycomb::Io {

Result<StreamWriter> StreamWriter::create(const std::filesystem::path& path,
                                          std::shared_ptr<const FrameLayout> layout) {
  if (layout->completes())
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: a file of this kind is completed at its end; give a name in a folder", path.string()));
  Result<OutputFile> file = OutputFile::create(path);
  if (!file) return tl::unexpected<Error>(file.error());
  if (Result<void> written = file->write(layout->header()); !written) return tl::unexpected<Error>(written.error());
  return StreamWriter(std::move(*file), path.string(), std::move(layout));
}

Result<void> StreamWriter::write(std::int32_t f, std::span<const float> points) {
  const FrameInfo& info = layout_->info();
  if (written_ == info.frameCount) {
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: has all its {} frames; create it with the number you write", name_, info.frameCount));
  }
  if (f != written_) {
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: frame {} was given after {} frames; give them in order", name_, f, written_));
  }
  if (Result<void> sound = checkWritten(name_, info, f, points); !sound) return sound;
  if (Result<void> written = file_.write(layout_->encode(f, points, encoded_)); !written) return written;
  ++written_;
  return {};
}

Result<void> StreamWriter::finish() {
  const std::int32_t all = layout_->info().frameCount;
  if (written_ == all) return file_.commit();
  return fail(ErrorCode::unwritable,
              fmt::format("{}: only {} of {} frames were written; write them all before finish", name_, written_, all));
}

}  // namespace honeycomb::Io
