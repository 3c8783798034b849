#include "tests/support/golden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "tests/support/golden_chain.h"
#include "tests/support/manifold_check.h"
#include "tests/support/mesh_compare.h"
#include "tests/support/refined.h"

namespace honeycomb::Test {
namespace {

/// Refined meshes, of all schemes or of those that the tests have an implementation of their own for.
std::vector<std::string> goldenMeshes(const std::string& prefix = "") {
  std::vector<std::string> names;
  for (const ManifestLine& line : readManifest()) {
    const bool refined = line.file.find("_L") != std::string::npos && line.file.ends_with(".obj");
    if (refined && line.file.starts_with(prefix) && isRefinedByScheme(splitGoldenName(line.file).folder)) {
      names.push_back(line.file);
    }
  }
  return names;
}

std::vector<std::string> goldenLimits() {
  std::vector<std::string> names;
  for (const ManifestLine& line : readManifest()) {
    if (line.file.ends_with("_limits.csv")) names.push_back(line.file);
  }
  return names;
}

std::string testName(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param.substr(0, info.param.rfind('.'));
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

/// The corner tags of akleman-brick-corners: vertices of valence 2, which are in one face only.
std::vector<std::size_t> cornerTags(const std::string& folder, const PolyMesh& mesh) {
  std::vector<int> faces(mesh.points.size(), 0);
  for (const Loop& loop : mesh.faces) {
    for (const std::size_t v : loop) ++faces[v];
  }
  std::vector<std::size_t> tags;
  for (std::size_t v = 0; v < faces.size() && folder == "akleman-brick-corners"; ++v) {
    if (faces[v] == 1) tags.push_back(v);
  }
  return tags;
}

struct GoldenCase {
  explicit GoldenCase(const std::string& file)
      : name(splitGoldenName(file)),
        control(readGoldenMesh(name.shape + ".obj")),
        tags(cornerTags(name.folder, control)),
        topology(toTopology(control, tags)),
        chain(goldenChain(name.folder, topology, name.level)) {}

  Far::Refinement refinement(bool limits = false) const {
    Far::RefineOptions options;
    options.limits = limits;
    Result<Far::Refinement> refined = Far::refine(topology, chain, options);
    if (!refined) throw std::runtime_error(refined.error().message);
    return std::move(*refined);
  }
  /// Conversions come before level 1 of the scheme.
  std::int32_t level() const { return static_cast<std::int32_t>(chain.size()); }

  GoldenMeshName name;
  PolyMesh control;
  std::vector<std::size_t> tags;
  Far::Topology topology;
  std::vector<Far::Scheme> chain;
};

class GoldenMesh : public testing::TestWithParam<std::string> {};

TEST_P(GoldenMesh, IsWhatTheTablesGive) {
  const GoldenCase golden(GetParam());
  const PolyMesh expected = readGoldenMesh(GetParam());
  const Far::Refinement refinement = golden.refinement();
  const MeshMatch match = matchMeshes(expected, levelMesh(refinement, golden.level(), golden.control.points), 1e-12);
  ASSERT_TRUE(match.same) << match.why;

  const auto single = levelPoints<float>(refinement, golden.level(), golden.control.points);
  double size = 0;
  for (const Vec3& p : golden.control.points) size = std::max(size, length(p));
  for (std::size_t v = 0; v < expected.points.size(); ++v) {
    ASSERT_LT(distance(expected.points[v], single[match.vertexMap[v]]), 1e-6 * size) << "golden vertex " << v;
  }
}

class AklemanMesh : public testing::TestWithParam<std::string> {};

TEST_P(AklemanMesh, IsWhatTheTestsOwnImplementationGives) {
  const GoldenCase golden(GetParam());
  const ReferenceMesh reference =
      referenceLevel(golden.control, golden.tags, goldenScheme(golden.name.folder).reference, golden.name.level);
  const MeshMatch match = matchMeshes(readGoldenMesh(GetParam()), reference.mesh, 1e-12);
  EXPECT_TRUE(match.same) << match.why;
}

TEST_P(GoldenMesh, HasTheCountsOfTheManifest) {
  const auto manifest = readManifest();
  const auto line = std::find_if(manifest.begin(), manifest.end(), [](const auto& l) { return l.file == GetParam(); });
  if (line->vertices.empty()) GTEST_SKIP() << "the manifest has no counts of converted meshes";
  const GoldenCase golden(GetParam());
  const Far::Refinement refinement = golden.refinement();
  const Far::Topology& topology = refinement.last().topology;
  EXPECT_EQ(topology.vertexCount(), std::stoi(line->vertices));
  EXPECT_EQ(topology.edgeCount(), std::stoi(line->edges));
  EXPECT_EQ(topology.faceCount(), std::stoi(line->faces));
  EXPECT_EQ(topology.eulerCharacteristic(), std::stoi(line->euler));
  EXPECT_EQ(topology.boundaryEdgeCount(), std::stoi(line->boundaryEdges));
}

INSTANTIATE_TEST_SUITE_P(Scheme, GoldenMesh, testing::ValuesIn(goldenMeshes()), testName);
INSTANTIATE_TEST_SUITE_P(Scheme, AklemanMesh, testing::ValuesIn(goldenMeshes("akleman")), testName);

class GoldenLimit : public testing::TestWithParam<std::string> {};

TEST_P(GoldenLimit, IsWhatTheLimitTableGives) {
  const GoldenCase golden(GetParam());
  const std::string meshFile = GetParam().substr(0, GetParam().rfind("_limits")) + ".obj";
  const PolyMesh expected = readGoldenMesh(meshFile);
  const Far::Refinement refinement = golden.refinement(true);
  const std::vector<Vec3> points = levelPoints<double>(refinement, golden.level(), golden.control.points);
  const MeshMatch match = matchMeshes(expected, toMesh(refinement.last().topology, points), 1e-12);
  ASSERT_TRUE(match.same) << match.why;

  const Limits limits = faceLimits<double>(refinement, points);
  const auto rows = readGoldenCsv(GetParam());
  ASSERT_EQ(rows.size(), expected.faces.size());
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), 7U);
    const std::size_t face = match.faceMap[std::stoul(row[0])];
    const Vec3 position{std::stod(row[1]), std::stod(row[2]), std::stod(row[3])};
    const Vec3 normal{std::stod(row[4]), std::stod(row[5]), std::stod(row[6])};
    EXPECT_LT(distance(limits.positions[face], position), 1e-9) << "golden face " << row[0];
    EXPECT_LT(distance(limits.normals[face], normal), 1e-9) << "golden face " << row[0];
  }
}

INSTANTIATE_TEST_SUITE_P(Scheme, GoldenLimit, testing::ValuesIn(goldenLimits()), testName);

}  // namespace
}  // namespace honeycomb::Test
