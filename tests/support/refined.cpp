#include "tests/support/refined.h"

#include <stdexcept>

#include "far/schemes/akleman.h"
#include "osd/cpu_evaluator.h"
#include "tests/support/must.h"

namespace honeycomb::Test {
namespace {

Far::BoundaryRule boundaryRule(ReferenceBoundary boundary) {
  switch (boundary) {
    case ReferenceBoundary::eq16:
      return Far::BoundaryRule::eq16;
    case ReferenceBoundary::drop:
      return Far::BoundaryRule::drop;
    default:
      return Far::BoundaryRule::brick;
  }
}

std::string nameOf(ReferenceBoundary boundary) {
  switch (boundary) {
    case ReferenceBoundary::eq16:
      return "eq16";
    case ReferenceBoundary::drop:
      return "drop";
    default:
      return "brick";
  }
}

SchemeCase makeCase(const std::string& name, const Far::Tension& tension, ReferenceOptions reference) {
  Far::AklemanOptions options;
  options.tension = tension;
  options.edgeParameter = reference.edgeParameter;
  options.boundary = boundaryRule(reference.boundary);
  options.boundaryWeight = reference.boundaryWeight;
  return {name + " t=" + std::to_string(reference.edgeParameter) + " " + nameOf(reference.boundary),
          must(Far::akleman(options)), std::move(reference)};
}

template <class Real>
Osd::Points<Real> readPoints(const std::vector<Real>& numbers) {
  return {numbers, {0, 3, 3}};
}

template <class Real>
Osd::PointsOut<Real> writePoints(std::vector<Real>& numbers) {
  return {numbers, {0, 3, 3}};
}

}  // namespace

SchemeCase schemeCase(NamedTension tension, ReferenceBoundary boundary, double edgeParameter, double boundaryWeight) {
  if (tension == NamedTension::sqrt3) {
    return makeCase("sqrt3", {.rule = Far::Tension::Rule::sqrt3},
                    {sqrt3Tension, edgeParameter, boundary, boundaryWeight});
  }
  return makeCase("paper", {.rule = Far::Tension::Rule::paper},
                  {paperTension, edgeParameter, boundary, boundaryWeight});
}

SchemeCase schemeCase(double tension, ReferenceBoundary boundary, double edgeParameter, double boundaryWeight) {
  return makeCase(std::to_string(tension), {.rule = Far::Tension::Rule::constant, .value = tension},
                  {[tension](std::size_t) { return tension; }, edgeParameter, boundary, boundaryWeight});
}

SchemeCase goldenScheme(const std::string& folder) {
  if (folder == "akleman-sqrt3") return schemeCase(NamedTension::sqrt3);
  if (folder == "akleman-a0.6-t0.25") return schemeCase(0.6, ReferenceBoundary::brick, 0.25);
  if (folder == "akleman-eq16") return schemeCase(NamedTension::paper, ReferenceBoundary::eq16);
  if (folder == "akleman-drop") return schemeCase(NamedTension::paper, ReferenceBoundary::drop);
  if (folder == "akleman" || folder == "akleman-brick-corners") return schemeCase(NamedTension::paper);
  throw std::runtime_error("no scheme for the golden folder " + folder);
}

Far::Polygons toPolygons(const PolyMesh& mesh, const std::vector<std::size_t>& cornerTags) {
  Far::Polygons polygons;
  polygons.vertexCount = static_cast<std::int32_t>(mesh.points.size());
  for (const Loop& loop : mesh.faces) polygons.addFace({loop.begin(), loop.end()});
  polygons.corners.assign(cornerTags.begin(), cornerTags.end());
  return polygons;
}

Far::Topology toTopology(const PolyMesh& mesh, const std::vector<std::size_t>& cornerTags) {
  return must(Far::Topology::create(toPolygons(mesh, cornerTags)));
}

Far::Refinement refined(const PolyMesh& mesh, const Far::Scheme& scheme, std::int32_t levels,
                        const std::vector<std::size_t>& cornerTags, bool limits) {
  return must(Far::refine(toTopology(mesh, cornerTags), scheme, levels, {.limits = limits, .memoryLimit = 0}));
}

template <class Real>
std::vector<Real> pack(const std::vector<Vec3>& points) {
  std::vector<Real> numbers;
  numbers.reserve(3 * points.size());
  for (const Vec3& p : points) {
    for (const double x : p) numbers.push_back(static_cast<Real>(x));
  }
  return numbers;
}

template <class Real>
std::vector<Vec3> unpack(const std::vector<Real>& numbers) {
  std::vector<Vec3> points(numbers.size() / 3);
  for (std::size_t i = 0; i < numbers.size(); ++i) points[i / 3][i % 3] = static_cast<double>(numbers[i]);
  return points;
}

template <class Real>
std::vector<Vec3> levelPoints(const Far::Refinement& refinement, std::int32_t level, const std::vector<Vec3>& control) {
  if (level == 0) return control;
  std::vector<Real> out(3 * static_cast<std::size_t>(refinement.level(level).pointCount()));
  const std::vector<Real> in = pack<Real>(control);
  Osd::SerialEvaluator evaluator;
  must(evaluator.evaluate(refinement, level, readPoints(in), writePoints(out)));
  return unpack(out);
}

PolyMesh toMesh(const Far::Topology& topology, std::vector<Vec3> points) {
  points.resize(static_cast<std::size_t>(topology.vertexCount()));  // without central control vertices
  PolyMesh mesh{std::move(points), {}};
  const auto offsets = topology.faceOffsets();
  for (std::int32_t f = 0; f < topology.faceCount(); ++f) {
    Loop loop;
    for (std::int32_t h = at(offsets, f); h < at(offsets, f + 1); ++h) {
      loop.push_back(static_cast<std::size_t>(topology.vert(h)));
    }
    mesh.faces.push_back(std::move(loop));
  }
  return mesh;
}

PolyMesh levelMesh(const Far::Refinement& refinement, std::int32_t level, const std::vector<Vec3>& control) {
  return toMesh(refinement.level(level).topology, levelPoints<double>(refinement, level, control));
}

ReferenceMesh referenceLevel(const PolyMesh& mesh, const std::vector<std::size_t>& cornerTags,
                             const ReferenceOptions& options, std::int32_t level) {
  ReferenceMesh result = referenceStart(mesh, cornerTags);
  for (; level > 0; --level) result = referenceZip(result, options);
  return result;
}

template <class Real>
Limits faceLimits(const Far::Refinement& refinement, const std::vector<Vec3>& points) {
  const std::vector<Real> in = pack<Real>(points);
  std::vector<Real> positions(3 * static_cast<std::size_t>(refinement.last().topology.faceCount()));
  std::vector<Real> normals(positions.size());
  Osd::SerialEvaluator evaluator;
  must(evaluator.faceLimits(refinement.limits(), readPoints(in), writePoints(positions), writePoints(normals)));
  return {unpack(positions), unpack(normals)};
}

template <class Real>
Limits vertexLimits(const Far::Refinement& refinement, const std::vector<Vec3>& points) {
  const std::vector<Real> in = pack<Real>(points);
  std::vector<Real> positions(3 * static_cast<std::size_t>(refinement.last().topology.vertexCount()));
  std::vector<Real> normals(positions.size());
  Osd::SerialEvaluator evaluator;
  must(evaluator.vertexLimits(refinement.limits(), readPoints(in), writePoints(positions), writePoints(normals)));
  return {unpack(positions), unpack(normals)};
}

template std::vector<float> pack(const std::vector<Vec3>&);
template std::vector<double> pack(const std::vector<Vec3>&);
template std::vector<Vec3> unpack(const std::vector<float>&);
template std::vector<Vec3> unpack(const std::vector<double>&);
template std::vector<Vec3> levelPoints<float>(const Far::Refinement&, std::int32_t, const std::vector<Vec3>&);
template std::vector<Vec3> levelPoints<double>(const Far::Refinement&, std::int32_t, const std::vector<Vec3>&);
template Limits faceLimits<float>(const Far::Refinement&, const std::vector<Vec3>&);
template Limits faceLimits<double>(const Far::Refinement&, const std::vector<Vec3>&);
template Limits vertexLimits<float>(const Far::Refinement&, const std::vector<Vec3>&);
template Limits vertexLimits<double>(const Far::Refinement&, const std::vector<Vec3>&);

}  // namespace honeycomb::Test
