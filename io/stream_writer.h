#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "far/base/result.h"
#include "io/frame_layout.h"
#include "io/frame_writer.h"
#include "io/output_file.h"

namespace honeycomb::Io {

/// Streams frames into a file one after another. The file appears under its name only at finish(); a writer destroyed
/// before that leaves nothing behind. Belongs to one thread at a time.
class StreamWriter : public FrameWriter {
 public:
  /// Errors: unwritable; invalidOption for a layout that completes(), which can't be streamed.
  static Result<StreamWriter> create(const std::filesystem::path& path, std::shared_ptr<const FrameLayout> layout);

  /// Appends a frame; they come in order. Errors: FrameWriter's; invalidOption for one out of order.
  Result<void> write(std::int32_t f, std::span<const float> points) override;
  /// The next one.
  Result<void> write(std::span<const float> points) { return write(written_, points); }
  /// Flushes and puts the file under its name. Errors: unwritable, also when fewer frames than promised were written.
  Result<void> finish();
  /// finish().
  Result<void> close() override { return finish(); }

 private:
  StreamWriter(OutputFile file, std::string name, std::shared_ptr<const FrameLayout> layout)
      : file_(std::move(file)), name_(std::move(name)), layout_(std::move(layout)) {}

  OutputFile file_;
  std::string name_;
  std::shared_ptr<const FrameLayout> layout_;
  std::vector<std::byte> encoded_;
  std::int32_t written_ = 0;  // frames
};

}  // namespace honeycomb::Io
