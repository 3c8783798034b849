#include "apps/cli/primvars.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "apps/cli/central_points.h"
#include "far/base/index.h"
#include "far/tables/face_varying.h"
#include "osd/cpu_evaluator.h"

namespace honeycomb::Cli {
namespace {

template <class Real>
std::vector<Real> converted(const std::vector<double>& values) {
  std::vector<Real> numbers(values.size());
  std::transform(values.begin(), values.end(), numbers.begin(), [](double x) { return static_cast<Real>(x); });
  return numbers;
}

/// Three numbers a vertex through the tables: of the vertices of the last level.
template <class Real>
Result<std::vector<Real>> refineVertexValues(const MeshInput& input, std::vector<Real> values, bool centralPoints,
                                             SurfaceEvaluator& evaluator) {
  if (centralPoints) appendOffsetPoints(input.mesh.polygons, std::array{0.0}, values);
  Surface<Real> surface;
  const Result<void> done = evaluator.evaluate(std::span<const Real>(values), surface);
  if (!done) return tl::unexpected(done.error());
  surface.points.resize(surface.vertices().size());
  return std::move(surface.points);
}

template <class Real>
void takePairs(const std::vector<Real>& triples, std::vector<Real>& pairs) {
  pairs.resize(triples.size() / 3 * 2);
  for (std::size_t v = 0; v < triples.size() / 3; ++v) std::copy_n(&triples[3 * v], 2, &pairs[2 * v]);
}

template <class Real>
Result<void> refineTexcoords(const MeshInput& input, const Far::Refinement& refinement, bool centralPoints,
                             SurfaceEvaluator& evaluator, Primvars<Real>& primvars) {
  if (input.mesh.cornerTexcoords.empty()) return {};
  const std::optional<std::vector<double>> values = texcoordsOfVertices(input.mesh);
  if (!values) return refineFaceVarying(input.mesh, refinement, primvars);
  const auto refined = refineVertexValues(input, converted<Real>(*values), centralPoints, evaluator);
  if (!refined) return tl::unexpected(refined.error());
  takePairs(*refined, primvars.texcoords);
  const auto vert = refinement.last().topology.vert();
  primvars.cornerTexcoords.assign(vert.begin(), vert.end());
  return {};
}

}  // namespace

std::optional<std::vector<double>> texcoordsOfVertices(const Io::Mesh& mesh) {
  std::vector<double> values(mesh.positions.size());
  std::vector<std::uint8_t> known(at(mesh.polygons.vertexCount));
  for (std::size_t c = 0; c < mesh.cornerTexcoords.size(); ++c) {
    if (mesh.cornerTexcoords[c] < 0) return std::nullopt;
    const auto uv = mesh.texcoords.begin() + 2 * std::ptrdiff_t{mesh.cornerTexcoords[c]};
    const std::size_t v = at(mesh.polygons.indices[c]);
    const auto value = values.begin() + 3 * static_cast<std::ptrdiff_t>(v);
    if (known[v] == 0) std::copy_n(uv, 2, value);
    known[v] = 1;
    if (!std::equal(uv, uv + 2, value)) return std::nullopt;
  }
  return values;
}

// The values are static and few against a frame's points: the CPU refines them, with the bits of any backend.
template <class Real>
Result<void> refineFaceVarying(const Io::Mesh& mesh, const Far::Refinement& refinement, Primvars<Real>& primvars) {
  constexpr Osd::BufferDescriptor kPairs{0, 2, 2};
  std::vector<double> values = mesh.texcoords;
  std::vector<std::int32_t> corners = mesh.cornerTexcoords;
  std::replace(corners.begin(), corners.end(), -1, static_cast<std::int32_t>(values.size() / 2));
  values.insert(values.end(), {0, 0});  // of corners that have none
  const Result<Far::FaceVarying> varying = Far::FaceVarying::build(refinement, {2, values, corners});
  if (!varying) return tl::unexpected(varying.error());
  std::vector<Real> uv = converted<Real>(values);
  Osd::TbbEvaluator evaluator;
  for (std::int32_t k = 1; k <= varying->levelCount(); ++k) {
    std::vector<Real> refined(2 * at(varying->level(k).valueCount));
    Result<void> done = evaluator.evaluate<Real>(varying->level(k).table, {uv, kPairs}, {refined, kPairs});
    if (!done) return done;
    uv = std::move(refined);
  }
  primvars.texcoords = std::move(uv);
  primvars.cornerTexcoords = varying->last().corners;
  return {};
}
template Result<void> refineFaceVarying(const Io::Mesh&, const Far::Refinement&, Primvars<float>&);
template Result<void> refineFaceVarying(const Io::Mesh&, const Far::Refinement&, Primvars<double>&);

template <class Real>
Result<Primvars<Real>> refinePrimvars(const MeshInput& input, const Far::Refinement& refinement, bool centralPoints,
                                      SurfaceEvaluator& evaluator) {
  Primvars<Real> primvars;
  if (!input.mesh.colours.empty()) {
    auto colours = refineVertexValues(input, converted<Real>(input.mesh.colours), centralPoints, evaluator);
    if (!colours) return tl::unexpected(colours.error());
    primvars.colours = std::move(*colours);
  }
  const auto done = refineTexcoords(input, refinement, centralPoints, evaluator, primvars);
  if (!done) return tl::unexpected(done.error());
  return primvars;
}
template Result<Primvars<float>> refinePrimvars(const MeshInput&, const Far::Refinement&, bool, SurfaceEvaluator&);
template Result<Primvars<double>> refinePrimvars(const MeshInput&, const Far::Refinement&, bool, SurfaceEvaluator&);

}  // namespace honeycomb::Cli
