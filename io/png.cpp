#include "io/png.h"

#include <fmt/format.h>
#include <png.h>

#include <new>
#include <vector>

#include "io/output_file.h"

namespace honeycomb::Io {
namespace {

constexpr std::int32_t kMaxSide = 32768;  // pixels; 4 GiB a square picture

// libpng's simplified interface reports errors in the image, without longjmp across our objects.
Result<std::vector<std::byte>> compress(const std::filesystem::path& path, png_image& image,
                                        std::span<const std::uint8_t> rgba) {
  std::vector<std::byte> bytes(PNG_IMAGE_PNG_SIZE_MAX(image));
  png_alloc_size_t size = bytes.size();
  const int done = png_image_write_to_memory(&image, bytes.data(), &size, 0, rgba.data(), 0, nullptr);
  if (done == 0) {
    return fail(ErrorCode::unwritable,
                fmt::format("{}: cannot be written as PNG: {}; try a smaller picture", path.string(), image.message));
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

Result<void> writePng(const std::filesystem::path& path, std::int32_t width, std::int32_t height,
                      std::span<const std::uint8_t> rgba) {
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) {
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: a picture of {} x {} pixels cannot be; give sides of 1 to {}", path.string(), width,
                            height, kMaxSide));
  }
  const std::size_t expected = std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (rgba.size() != expected) {
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: a picture of {} x {} pixels needs {} bytes, not {}; give RGBA", path.string(), width,
                            height, expected, rgba.size()));
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGBA;
  try {
    const Result<std::vector<std::byte>> bytes = compress(path, image, rgba);
    if (!bytes) return tl::unexpected<Error>(bytes.error());
    Result<OutputFile> file = OutputFile::create(path);
    if (!file) return tl::unexpected<Error>(file.error());
    return file->write(*bytes).and_then([&file] { return file->commit(); });
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::outOfMemory,
                fmt::format("{}: the picture does not fit into memory; make it smaller", path.string()));
  }
}

}  // namespace honeycomb::Io
