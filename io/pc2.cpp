#include "io/pc2.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>
#include <string_view>

#include "io/frame_checks.h"
#include "io/mapped_file.h"
#include "io/written_frames.h"

namespace honeycomb::Io {
namespace {

static_assert(std::endian::native == std::endian::little, "frames are used as they stand in the little-endian file");

using namespace std::string_view_literals;
constexpr std::string_view kMagic = "POINTCACHE2\0"sv;
constexpr std::int32_t kVersion = 1;
constexpr std::size_t kHeaderBytes = 32;
constexpr std::int32_t kFramesKept = 16;  // behind the frame last read; threads read a few frames at once

// The header as it stands in the file.
struct Header {
  std::array<char, 12> magic{};
  std::int32_t version = kVersion;
  std::int32_t points = 0;
  float start = 0;
  float rate = 1;
  std::int32_t frames = 0;
};
static_assert(sizeof(Header) == kHeaderBytes);

// At most 24 GiB, far within 64 bits; the bytes of all frames need not be.
std::size_t frameBytes(const FrameInfo& info) {
  return 3 * sizeof(float) * static_cast<std::size_t>(info.pointCount);
}

tl::unexpected<Error> failFile(std::string_view name, std::string_view what, std::int64_t element = -1) {
  return fail(ErrorCode::invalidFile, fmt::format("{}: {}", name, what), element);
}

Result<FrameInfo> readHeader(std::string_view name, std::span<const std::byte> bytes) {
  Header header;
  if (bytes.empty()) return failFile(name, "is empty; give a PC2 point cache");
  if (bytes.size() < kMagic.size() || std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) != 0) {
    return failFile(name, "does not begin with POINTCACHE2; give a PC2 point cache");
  }
  if (bytes.size() < kHeaderBytes) return failFile(name, "ends within the header; export the cache again");
  std::memcpy(&header, bytes.data(), kHeaderBytes);
  if (header.version != kVersion) {
    return failFile(name, fmt::format("is PC2 version {}, only version 1 is known; export it as that", header.version));
  }
  if (header.points < 1) {
    return failFile(name, fmt::format("has {} points; export a cache of a mesh with vertices", header.points));
  }
  if (header.frames < 1) {
    return failFile(name, fmt::format("has {} frames; export at least one frame", header.frames));
  }
  return FrameInfo{header.points, header.frames, header.start, header.rate, 0};
}

}  // namespace

struct Pc2Reader::Mapping {
  MappedFile file;
  std::string name;
  FrameInfo info;

  std::size_t frameBegin(std::int32_t f) const { return kHeaderBytes + static_cast<std::size_t>(f) * frameBytes(info); }
};

Pc2Reader::Pc2Reader(std::unique_ptr<Mapping> mapping) : mapping_(std::move(mapping)) {}
Pc2Reader::Pc2Reader(Pc2Reader&&) noexcept = default;
Pc2Reader& Pc2Reader::operator=(Pc2Reader&&) noexcept = default;
Pc2Reader::~Pc2Reader() = default;

Result<Pc2Reader> Pc2Reader::open(const std::filesystem::path& path) {
  Result<MappedFile> file = MappedFile::open(path);
  if (!file) return tl::unexpected<Error>(file.error());
  const Result<FrameInfo> info = readHeader(path.string(), file->bytes());
  if (!info) return tl::unexpected<Error>(info.error());
  const Result<void> whole = checkWhole(path.string(), *info, file->bytes().size() - kHeaderBytes);
  if (!whole) return tl::unexpected<Error>(whole.error());
  file->expectSequentialReads();
  return Pc2Reader(std::make_unique<Mapping>(Mapping{std::move(*file), path.string(), *info}));
}

const FrameInfo& Pc2Reader::info() const {
  return mapping_->info;
}

Result<std::span<const float>> Pc2Reader::frame(std::int32_t f) const {
  const Mapping& m = *mapping_;
  if (Result<void> there = checkFrame(m.name, f, m.info); !there) return tl::unexpected<Error>(there.error());
  if (f > kFramesKept) m.file.release(m.frameBegin(f - kFramesKept - 1), m.frameBegin(f - kFramesKept));
  const std::byte* first = m.file.bytes().data() + m.frameBegin(f);
  const std::span<const float> points(reinterpret_cast<const float*>(first), frameBytes(m.info) / sizeof(float));
  if (Result<void> finite = checkFinite(m.name, f, points); !finite) return tl::unexpected<Error>(finite.error());
  return points;
}

Result<std::span<const float>> Pc2Reader::frame(std::int32_t f, std::vector<float>& /*storage*/) const {
  return frame(f);
}

namespace {

std::vector<std::byte> pc2Header(const FrameInfo& info) {
  Header header;
  kMagic.copy(header.magic.data(), kMagic.size());
  header.points = info.pointCount;
  header.start = info.start;
  header.rate = info.rate;
  header.frames = info.frameCount;
  const auto bytes = std::as_bytes(std::span(&header, 1));
  return {bytes.begin(), bytes.end()};
}

class Pc2Layout : public FrameLayout {
 public:
  explicit Pc2Layout(const FrameInfo& info)
      : FrameLayout(info, pc2Header(info), static_cast<std::int64_t>(Io::frameBytes(info))) {}
  std::span<const std::byte> encode(std::int32_t /*f*/, std::span<const float> points,
                                    std::vector<std::byte>& /*storage*/) const override {
    return std::as_bytes(points);
  }
};

}  // namespace

Result<std::shared_ptr<const FrameLayout>> pc2Layout(std::string_view name, const FrameInfo& info) {
  if (Result<void> sound = checkCounts(name, "a PC2 cache", info); !sound) return tl::unexpected<Error>(sound.error());
  return std::make_shared<const Pc2Layout>(info);
}

Result<Pc2Writer> Pc2Writer::create(const std::filesystem::path& path, const FrameInfo& info) {
  Result<std::shared_ptr<const FrameLayout>> layout = pc2Layout(path.string(), info);
  if (!layout) return tl::unexpected<Error>(layout.error());
  Result<StreamWriter> writer = StreamWriter::create(path, *layout);
  if (!writer) return tl::unexpected<Error>(writer.error());
  return Pc2Writer(std::move(*writer));
}

}  // namespace honeycomb::Io
