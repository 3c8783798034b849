#include "io/mdd.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <string>

#include "far/base/index.h"
#include "io/frame_checks.h"
#include "io/mapped_file.h"

namespace honeycomb::Io {
namespace {

constexpr std::size_t kMddHeaderBytes = 8;   // the two counts
constexpr std::int32_t kMddFramesKept = 16;  // behind the frame last read; threads read a few frames at once

std::uint32_t bigEndian(const std::byte* bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8U | std::to_integer<std::uint32_t>(bytes[i]);
  return value;
}

float bigEndianFloat(const std::byte* bytes) {
  return std::bit_cast<float>(bigEndian(bytes));
}

tl::unexpected<Error> failMdd(std::string_view name, std::string_view what, std::int64_t element = -1) {
  return fail(ErrorCode::invalidFile, fmt::format("{}: {}", name, what), element);
}

// The times of all frames; fewer bytes than their number promises is an error.
Result<std::vector<float>> readTimes(std::string_view name, std::span<const std::byte> bytes, std::int32_t frames) {
  if ((bytes.size() - kMddHeaderBytes) / sizeof(float) < at(frames))
    return failMdd(name, fmt::format("is cut off within the times of its {} frames, or is no MDD point cache; export "
                                     "it again or copy it whole",
                                     frames));
  std::vector<float> times;
  for (std::int32_t f = 0; f < frames; ++f) {
    times.push_back(bigEndianFloat(bytes.data() + kMddHeaderBytes + 4 * at(f)));
    if (!std::isfinite(times.back()))
      return failMdd(
          name, fmt::format("the time of frame {} (counted from 0) is {}; export the cache again", f, times.back()), f);
  }
  return times;
}

Result<FrameInfo> readMddHeader(std::string_view name, std::span<const std::byte> bytes) {
  if (bytes.empty()) return failMdd(name, "is empty; give an MDD point cache");
  if (bytes.size() < kMddHeaderBytes) return failMdd(name, "ends within the header; export the cache again");
  FrameInfo info;
  info.frameCount = static_cast<std::int32_t>(bigEndian(bytes.data()));
  info.pointCount = static_cast<std::int32_t>(bigEndian(bytes.data() + 4));
  if (info.frameCount < 1 || info.pointCount < 1)
    return failMdd(name, fmt::format("has {} frames of {} points, or is no MDD point cache; give one of a mesh that "
                                     "moves",
                                     info.frameCount, info.pointCount));
  const Result<std::vector<float>> times = readTimes(name, bytes, info.frameCount);
  if (!times) return tl::unexpected<Error>(times.error());
  info.start = times->front();
  info.rate = times->size() > 1 ? (*times)[1] - (*times)[0] : 0;
  info.framesPerSecond = info.rate > 0 ? 1 / info.rate : 0;
  return info;
}

}  // namespace

struct MddReader::Mapping {
  MappedFile file;
  std::string name;
  FrameInfo info;

  std::size_t floats() const { return 3 * at(info.pointCount); }
  std::size_t frameBegin(std::int32_t f) const {
    return kMddHeaderBytes + 4 * at(info.frameCount) + at(f) * 4 * floats();
  }
};

MddReader::MddReader(std::unique_ptr<Mapping> mapping) : mapping_(std::move(mapping)) {}
MddReader::MddReader(MddReader&&) noexcept = default;
MddReader& MddReader::operator=(MddReader&&) noexcept = default;
MddReader::~MddReader() = default;

Result<MddReader> MddReader::open(const std::filesystem::path& path) {
  Result<MappedFile> file = MappedFile::open(path);
  if (!file) return tl::unexpected<Error>(file.error());
  const Result<FrameInfo> info = readMddHeader(path.string(), file->bytes());
  if (!info) return tl::unexpected<Error>(info.error());
  file->expectSequentialReads();
  auto mapping = std::make_unique<Mapping>(Mapping{std::move(*file), path.string(), *info});
  const std::size_t bytes = mapping->file.bytes().size() - mapping->frameBegin(0);
  if (const Result<void> whole = checkWhole(mapping->name, mapping->info, bytes); !whole)
    return tl::unexpected<Error>(whole.error());
  return MddReader(std::move(mapping));
}

const FrameInfo& MddReader::info() const {
  return mapping_->info;
}

Result<std::span<const float>> MddReader::frame(std::int32_t f, std::vector<float>& storage) const {
  const Mapping& m = *mapping_;
  if (const Result<void> there = checkFrame(m.name, f, m.info); !there) return tl::unexpected<Error>(there.error());
  if (f > kMddFramesKept) m.file.release(m.frameBegin(f - kMddFramesKept - 1), m.frameBegin(f - kMddFramesKept));
  const std::byte* first = m.file.bytes().data() + m.frameBegin(f);
  storage.resize(m.floats());
  for (std::size_t i = 0; i < storage.size(); ++i) storage[i] = bigEndianFloat(first + 4 * i);
  if (const Result<void> finite = checkFinite(m.name, f, storage); !finite)
    return tl::unexpected<Error>(finite.error());
  return storage;
}

}  // namespace honeycomb::Io
