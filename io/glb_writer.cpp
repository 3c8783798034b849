#include "io/glb_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "io/block_file.h"
#include "io/glb_document.h"
#include "io/mapped_file.h"
#include "io/mesh_content.h"
#include "io/stream_writer.h"
#include "io/written_frames.h"

namespace honeycomb::Io {
namespace {

/// The file's vertices of a frame of the mesh.
void gather(std::span<const std::int32_t> vertices, std::span<const float> points, std::span<float> result) {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) result[3 * i + k] = points[3 * at(vertices[i]) + k];
}

class GlbLayout : public FrameLayout {
 public:
  GlbLayout(const FrameInfo& info, const GlbDocument& document, std::vector<float> base)
      : FrameLayout(info, document.header(knownBounds(info, base)), std::ssize(base) * std::int64_t{sizeof(float)}),
        document_(document),
        base_(std::move(base)) {}

  std::span<const std::byte> encode(std::int32_t f, std::span<const float> points,
                                    std::vector<std::byte>& storage) const override {
    storage.resize(base_.size() * sizeof(float));
    const std::span<float> frame(reinterpret_cast<float*>(storage.data()), base_.size());
    gather(document_.vertices(), points, frame);
    for (std::size_t i = 0; i < frame.size() && f > 0; ++i) frame[i] -= base_[i];
    return storage;
  }
  bool completes() const override { return info().frameCount > 1; }
  /// The boxes round the targets, which glTF wants in its JSON.
  Result<void> complete(const std::filesystem::path& file) const override {
    if (!completes()) return {};
    const Result<MappedFile> mapped = MappedFile::open(file);
    if (!mapped) return tl::unexpected<Error>(mapped.error());
    std::vector<GlbBounds> bounds(at(info().frameCount));
    Parallel::forEach(
        0, info().frameCount,
        [&](std::int64_t f) {
          std::vector<float> frame(base_.size());
          const std::int64_t begin = frameOffset(static_cast<std::int32_t>(f));
          std::memcpy(frame.data(), mapped->bytes().data() + begin, at(frameBytes()));
          bounds[at(f)] = boundsOf(frame);
          mapped->release(at(begin), at(begin + frameBytes()));
        },
        1);
    const std::string json = document_.json(bounds);
    return openBlockFile(file, file).and_then([&](const std::unique_ptr<BlockFile>& opened) {
      return opened->writeAt(GlbDocument::kJsonOffset, std::as_bytes(std::span(json)));
    });
  }

 private:
  static std::vector<GlbBounds> knownBounds(const FrameInfo& info, std::span<const float> base) {
    std::vector<GlbBounds> bounds(at(info.frameCount));
    bounds.front() = boundsOf(base);
    return bounds;
  }

  GlbDocument document_;
  std::vector<float> base_;
};

/// What is asked of a mesh besides, to be cut into triangles.
Result<void> checkFaces(std::string_view name, const ObjContent<float>& content) {
  for (std::size_t f = 0; f + 1 < content.faceOffsets.size(); ++f)
    if (content.faceOffsets[f + 1] - content.faceOffsets[f] < 3)
      return fail(ErrorCode::invalidMesh, fmt::format("{}: face {} has fewer than three sides; leave it out", name, f),
                  static_cast<std::int64_t>(f));
  if (content.positions.empty() || content.faceOffsets.size() < 2)
    return fail(ErrorCode::invalidOption, fmt::format("{}: glTF has no empty meshes; give one with faces", name));
  return {};
}

/// Before any of it is in memory: frames x points x 12 bytes, and a weight for each target in each frame.
Result<void> checkBytes(std::string_view name, std::int64_t points, std::int64_t frames) {
  const double bytes = 12.0 * static_cast<double>(points) * static_cast<double>(frames) +
                       4.0 * static_cast<double>(frames) * static_cast<double>(frames);
  if (bytes <= static_cast<double>(kMostGlbBytes)) return {};
  return fail(ErrorCode::tooLarge,
              fmt::format("{}: {} frames of {} points are {:.1f} GB, and glTF readers take 2.1 GB; bake to .pc2 with "
                          "--mesh, or fewer --frames",
                          name, frames, points, bytes / 1e9));
}

Result<void> checkTimes(std::string_view name, const FrameInfo& info) {
  const double last = info.start + double{info.rate} * (info.frameCount - 1);
  if (info.frameCount == 1 || (info.rate > 0 && info.start >= 0 && std::isfinite(last))) return {};
  return fail(ErrorCode::invalidOption, fmt::format("{}: frames that begin at {} s and follow after {} s have no times "
                                                    "in glTF; give a positive number of frames a second",
                                                    name, info.start, info.rate));
}

/// Double precision goes to single; what doesn't fit becomes infinite, which is found later.
template <class Real>
std::vector<float> singles(std::span<const Real> values) {
  std::vector<float> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) result[i] = static_cast<float>(values[i]);
  return result;
}

}  // namespace

Result<std::shared_ptr<const FrameLayout>> glbLayout(std::string_view name, const ObjContent<float>& content,
                                                     const FrameInfo& info) {
  const std::int64_t points = std::ssize(content.positions) / 3;
  const Result<void> sound = checkContent(std::filesystem::path(name), content)
                                 .and_then([&] { return checkFaces(name, content); })
                                 .and_then([&] { return checkCounts(name, "a glTF animation", info); })
                                 .and_then([&] { return checkTimes(name, info); })
                                 .and_then([&] { return checkBytes(name, points, info.frameCount); });
  if (!sound) return tl::unexpected<Error>(sound.error());
  if (info.pointCount != points)
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: frames of {} points don't fit a mesh of {}; give the mesh they are of", name,
                            info.pointCount, points));
  const GlbDocument document(content, info);
  if (const auto all = checkBytes(name, std::ssize(document.vertices()), info.frameCount); !all)
    return tl::unexpected<Error>(all.error());
  std::vector<float> base(3 * document.vertices().size());
  gather(document.vertices(), content.positions, base);
  return std::make_shared<const GlbLayout>(info, document, std::move(base));
}

template <class Real>
Result<void> writeGlb(const std::filesystem::path& path, const ObjContent<Real>& content) {
  const std::vector<float> positions = singles(content.positions), normals = singles(content.normals),
                           colours = singles(content.colours), texcoords = singles(content.texcoords);
  const ObjContent<float> single{positions, normals,   content.faceOffsets,    content.faceVertices,
                                 colours,   texcoords, content.cornerTexcoords};
  const FrameInfo info{static_cast<std::int32_t>(positions.size() / 3), 1, 0, 1, 0};
  const auto layout = glbLayout(path.string(), single, info);
  if (!layout) return tl::unexpected<Error>(layout.error());
  Result<StreamWriter> writer = StreamWriter::create(path, *layout);
  if (!writer) return tl::unexpected<Error>(writer.error());
  return writer->write(positions).and_then([&] { return writer->finish(); });
}

template Result<void> writeGlb(const std::filesystem::path&, const ObjContent<float>&);
template Result<void> writeGlb(const std::filesystem::path&, const ObjContent<double>&);

}  // namespace honeycomb::Io
