#include "apps/cli/central_points.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

#include "apps/cli/chain.h"
#include "far/base/index.h"
#include "far/base/parallel.h"
#include "io/obj_points.h"

namespace honeycomb::Cli {
namespace {

using Vector = std::array<double, 3>;

bool isCache(const std::string& file) {
  const std::string_view extension = std::string_view(file).substr(file.size() < 4 ? 0 : file.size() - 4);
  return extension == ".pc2" || extension == ".PC2";
}

tl::unexpected<Error> anotherCount(const std::string& file, std::int64_t count, const MeshInput& input) {
  return fail(
      ErrorCode::invalidFile,
      fmt::format("{}: has {} points, but {} has {} faces; give one central control vertex a face, in the order "
                  "of the f lines",
                  file, count, input.file, input.mesh.polygons.faceCount()));
}

/// One number a line; empty lines at the end are passed over.
Result<std::vector<double>> readOffsetFile(const std::string& file, const MeshInput& input) {
  const auto unreadable = [&file] {
    return fail(ErrorCode::unreadable,
                fmt::format("--ccv-offset {}: is neither a number nor a file that can be read", file));
  };
  std::ifstream stream(file);
  if (!stream) return unreadable();
  std::vector<double> offsets;
  std::int64_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    if (line.empty()) continue;
    const std::optional<double> offset = parseNumber(line);
    if (!offset || !std::isfinite(*offset))
      return fail(ErrorCode::invalidFile,
                  fmt::format("{}:{}: give one finite number, the offset of a face", file, number), number);
    offsets.push_back(*offset);
  }
  if (stream.bad()) return unreadable();  // a folder
  if (static_cast<std::int64_t>(offsets.size()) != input.mesh.polygons.faceCount())
    return fail(ErrorCode::invalidFile, fmt::format("{}: has {} offsets, but {} has {} faces; give one a face, in the "
                                                    "order of the f lines",
                                                    file, offsets.size(), input.file, input.mesh.polygons.faceCount()));
  return offsets;
}

/// What both commands have: a number, or one a face.
Result<CentralPoints> readOffset(const SchemeOptions& options, const MeshInput& input) {
  CentralPoints central;
  const std::string text = options.text(kCentralOffsetOption);
  if (const std::optional<double> offset = parseNumber(text)) {
    if (!std::isfinite(*offset))
      return fail(ErrorCode::invalidOption, fmt::format("--ccv-offset {}: give a finite number", *offset));
    central.offsets = {*offset};
    central.given = *offset != 0;
    return central;
  }
  Result<std::vector<double>> offsets = readOffsetFile(text, input);
  if (!offsets) return tl::unexpected(offsets.error());
  central.offsets = std::move(*offsets);
  central.given = true;
  return central;
}

/// Barycentre plus offset times the unit normal T1 x T2, with T1 = sum v_k cos(2 pi k/N), T2 = sum v_k sin(2 pi k/N).
template <class Real>
Vector offsetPoint(std::span<const std::int32_t> face, double offset, const Real* points) {
  Vector centre{}, cosines{}, sines{};
  const auto sides = static_cast<double>(face.size());
  for (std::size_t k = 0; k < face.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / sides;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto x = static_cast<double>(points[3 * at(face[k]) + axis]);
      centre[axis] += x / sides;
      cosines[axis] += x * std::cos(angle);
      sines[axis] += x * std::sin(angle);
    }
  }
  Vector normal{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
    normal[axis] = cosines[b] * sines[c] - cosines[c] * sines[b];
  }
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  if (!(length > 0) || !std::isfinite(length)) return centre;
  for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] += offset * normal[axis] / length;
  return centre;
}

}  // namespace

Result<CentralPoints> readCentralPoints(const SchemeOptions& options, const MeshInput& input) {
  if (!options.given(kCentralFileOption)) return readOffset(options, input);
  CentralPoints central{true, {}, options.text(kCentralFileOption), {}, {}};
  if (isCache(central.file))
    return fail(
        ErrorCode::invalidOption,
        fmt::format("--ccv {}: holds an animation; give the points of one pose as v lines of an OBJ", central.file));
  Result<Io::ObjPoints> points = Io::readObjPoints(central.file);
  if (!points) return tl::unexpected(inFile(central.file, points.error()));
  if (points->count() != input.mesh.polygons.faceCount()) return anotherCount(central.file, points->count(), input);
  central.positions = std::move(points->positions);
  return central;
}

Result<CentralPoints> readCentralCache(const SchemeOptions& options, const MeshInput& input, std::int32_t frameCount) {
  if (!options.given(kCentralFileOption)) return readOffset(options, input);
  CentralPoints central{true, {}, options.text(kCentralFileOption), {}, {}};
  if (!isCache(central.file))
    return fail(ErrorCode::invalidOption,
                fmt::format("--ccv {}: holds one pose, but the mesh moves; give a .pc2 with a point a face and as many "
                            "frames, or use --ccv-offset",
                            central.file));
  Result<Io::Pc2Reader> cache = Io::Pc2Reader::open(central.file);
  if (!cache) return tl::unexpected(inFile(central.file, cache.error()));
  if (cache->info().pointCount != input.mesh.polygons.faceCount())
    return anotherCount(central.file, cache->info().pointCount, input);
  if (cache->info().frameCount != frameCount)
    return fail(ErrorCode::invalidFile,
                fmt::format("{}: has {} frames, but the animation of the mesh has {}; give as many", central.file,
                            cache->info().frameCount, frameCount));
  central.cache = std::move(*cache);
  return central;
}

template <class Real>
void appendOffsetPoints(const Far::Polygons& polygons, std::span<const double> offsets, std::vector<Real>& points) {
  const std::size_t vertices = points.size();
  points.resize(vertices + 3 * at(polygons.faceCount()));
  Parallel::forEach(0, polygons.faceCount(), [&](std::int64_t f) {
    const std::size_t first = at(polygons.faceOffsets[at(f)]);
    const auto face = std::span(polygons.indices).subspan(first, at(polygons.faceOffsets[at(f) + 1]) - first);
    const double offset = offsets[offsets.size() == 1 ? 0 : at(f)];
    const Vector point = offsetPoint(face, offset, points.data());
    for (std::size_t axis = 0; axis < 3; ++axis) points[vertices + 3 * at(f) + axis] = static_cast<Real>(point[axis]);
  });
}
template void appendOffsetPoints(const Far::Polygons&, std::span<const double>, std::vector<float>&);
template void appendOffsetPoints(const Far::Polygons&, std::span<const double>, std::vector<double>&);

}  // namespace honeycomb::Cli
