#include "io/table_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/io/table_files.h"
#include "tests/support/creased.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"

namespace honeycomb::Io::Test {
namespace {

using honeycomb::Test::must;
using honeycomb::Test::PolyMesh;
using testing::HasSubstr;
using Instructions = Osd::CpuEvaluator::Instructions;

Far::Refinement tableRefinement(const PolyMesh& mesh, std::int32_t levels, bool limits = false) {
  return honeycomb::Test::refined(mesh, honeycomb::Test::schemeCase(honeycomb::Test::NamedTension::paper).scheme,
                                  levels, {}, limits);
}

/// Every evaluator gives the same bits with a file as with what it was made of.
void expectSameBits(const Far::Refinement& refinement, const Far::TileTable* tiles) {
  const TableFile file = must(readTable(tableBytes(refinement, tiles)));
  must(file.check());
  const Far::LevelTables levels = must(file.levels());
  const std::vector<float> expected = pointsBy(Osd::SerialEvaluator(), refinement);
  EXPECT_EQ(pointsBy(Osd::SerialEvaluator(), levels), expected);
  EXPECT_EQ(pointsBy(Osd::SimdEvaluator(), levels), expected);
  EXPECT_EQ(pointsBy(Osd::TbbEvaluator(), levels), expected);
  ASSERT_EQ(file.hasLimits(), refinement.limits().faces.sourceCount > 0);
  if (file.hasLimits()) {
    EXPECT_EQ(limitNormals(levels, expected), limitNormals(refinement, expected));
  }
  ASSERT_EQ(file.hasTiles(), tiles != nullptr);
  if (tiles == nullptr) return;
  for (const Instructions instructions : {Instructions::plain, Instructions::vectors}) {
    EXPECT_EQ(pointsByTiles(levels, *must(file.tiles()), instructions),
              pointsByTiles(refinement, *tiles, instructions));
  }
}

/// Files of a refinement level by level, and with tiles of each kind of normals.
void expectSameBitsByTiles(const Far::Refinement& refinement) {
  expectSameBits(refinement, nullptr);
  for (const auto normals : {Far::TileNormalKind::fast, Far::TileNormalKind::exact}) {
    const bool fours = normals == Far::TileNormalKind::exact;
    const Far::TileTable tiles =
        must(Far::buildTileTable(refinement, {.scratchPoints = 300,
                                              .order = fours ? Far::TileOrder::levels : Far::TileOrder::tiles,
                                              .normals = normals,
                                              .places = fours ? Far::TilePlaces::fours : Far::TilePlaces::faces}));
    expectSameBits(refinement, &tiles);
  }
}

TEST(TableFile, GivesTheSameBitsUnderEveryScheme) {
  for (const auto& scheme : honeycomb::Test::listedSchemes()) {
    SCOPED_TRACE(scheme.name);
    const Far::Topology control = honeycomb::Test::toTopology(honeycomb::Test::torus(5, 4));
    expectSameBitsByTiles(honeycomb::Test::refinedBy(scheme, control, 2, true));
  }
}

TEST(TableFile, GivesTheSameBitsForOpenMeshes) {
  const Far::Refinement refinement = tableRefinement(honeycomb::Test::grid(6, 5), 3, true);
  expectSameBitsByTiles(refinement);
}

TEST(TableFile, GivesTheSameBitsForLargeFaces) {
  expectSameBitsByTiles(tableRefinement(honeycomb::Test::prism(300), 2, true));
}

TEST(TableFile, GivesTheSameBitsForCreases) {
  for (const auto& mesh : honeycomb::Test::creasedMeshes(1.5)) {
    SCOPED_TRACE(mesh.name);
    const Far::Topology control = honeycomb::Test::creased(mesh.mesh, mesh.creases);
    const std::vector<Far::Scheme> chain(3, honeycomb::Test::schemeCase(honeycomb::Test::NamedTension::paper).scheme);
    expectSameBits(honeycomb::Test::refinedBy(control, chain, true), nullptr);
  }
}

/// The table of a single tile as it was made before TileBorn was known: all normals have frames and corners.
Far::TileTable withFramesAlone(Far::TileTable tiles) {
  Far::TileNormals& normals = tiles.normals;
  for (std::size_t s = 0; s < tiles.steps.size(); ++s) {
    const Far::TileStep& step = tiles.steps[s];
    const Far::TileBorn& born = normals.born[s];
    if (born.firstNormal < 0) continue;
    normals.frames.push_back(
        {step.width, step.count, static_cast<std::int32_t>(normals.indices.size()), born.firstWeight});
    const auto index = tiles.indices.begin() + step.firstIndex;
    normals.indices.append(index, index + std::ptrdiff_t{step.count} * step.width);
  }
  normals.tiles[0].framesCount = static_cast<std::int32_t>(normals.frames.size());
  normals.born = {};
  return tiles;
}

TEST(TableFile, MayHaveFramesOfAllNormals) {
  const Far::Refinement refinement = tableRefinement(honeycomb::Test::cube(), 3);
  const Far::TileTable tiles = must(Far::buildTileTable(refinement, {.normals = Far::TileNormalKind::fast}));
  ASSERT_EQ(tiles.tiles.size(), 1U);
  const Far::TileTable before = withFramesAlone(tiles);
  ASSERT_GT(before.normals.frames.size(), tiles.normals.frames.size());
  const TableFile file = must(readTable(tableBytes(refinement, &before)));
  must(file.check());
  for (const Instructions instructions : {Instructions::plain, Instructions::vectors}) {
    EXPECT_EQ(pointsByTiles(must(file.levels()), *must(file.tiles()), instructions),
              pointsByTiles(refinement, tiles, instructions));
  }
}

TEST(TableFile, MayHaveExactNormalsWithoutRings) {
  const Far::Refinement refinement = tableRefinement(honeycomb::Test::torus(9, 6), 3, true);
  const Far::TileTable tiles =
      must(Far::buildTileTable(refinement, {.normals = Far::TileNormalKind::exact, .places = Far::TilePlaces::fours}));
  ASSERT_FALSE(tiles.limits.rings.empty());
  Far::TileTable before = must(Far::buildTileTable(refinement, {.normals = Far::TileNormalKind::exact}));
  ASSERT_TRUE(before.limits.rings.empty());
  before.limits.ringTiles = {};
  const TableFile file = must(readTable(tableBytes(refinement, &before)));
  must(file.check());
  for (const Instructions instructions : {Instructions::plain, Instructions::vectors}) {
    EXPECT_EQ(pointsByTiles(must(file.levels()), *must(file.tiles()), instructions),
              pointsByTiles(refinement, tiles, instructions));
  }
}

TEST(TableFile, IsUsedWhereItStands) {
  const Far::Refinement refinement = tableRefinement(honeycomb::Test::cube(), 2);
  const TableFile file = must(readTable(tableBytes(refinement)));
  const auto* indices = reinterpret_cast<const std::byte*>(must(file.levels()).table(2).indices.data());
  const auto section = std::ranges::find(file.sections(), "level 2 indices", &TableSection::name);
  ASSERT_NE(section, file.sections().end());
  EXPECT_EQ(indices, section->bytes.data());
  EXPECT_EQ(section->offset % 64, 0U);
}

TEST(TableFile, OutlivesWhoOpenedIt) {
  const Far::Refinement refinement = tableRefinement(honeycomb::Test::cube(), 2);
  const TemporaryFolder folder;
  must(writeTableFile(folder / "a.hct", {refinement, nullptr, infoOf(refinement)}));
  std::optional<TableFile> first = must(TableFile::open(folder / "a.hct"));
  const TableFile copy = *first;
  first.reset();
  EXPECT_EQ(pointsBy(Osd::SerialEvaluator(), must(copy.levels())), pointsBy(Osd::SerialEvaluator(), refinement));
}

TEST(TableFile, HasTheMeshOfTheLastLevel) {
  const Far::Refinement refinement = tableRefinement(honeycomb::Test::grid(4, 3), 2);
  const TableFile file = must(readTable(tableBytes(refinement)));
  const TableMesh mesh = must(file.mesh());
  const Far::Topology& last = refinement.last().topology;
  EXPECT_EQ(mesh.vertexCount, last.vertexCount());
  EXPECT_TRUE(std::ranges::equal(mesh.faceOffsets, last.faceOffsets()));
  EXPECT_TRUE(std::ranges::equal(mesh.faceVertices, last.vert()));
  EXPECT_TRUE(std::ranges::equal(mesh.triangles, refinement.triangles(2)));
  EXPECT_TRUE(std::ranges::equal(mesh.lines, refinement.lines(2)));
  const std::vector<Far::Origin> origins = refinement.faceOrigins(2);
  ASSERT_EQ(mesh.faceOrigins.size(), origins.size());
  for (std::size_t f = 0; f < origins.size(); ++f) {
    const std::int32_t element = origins[f].element;
    EXPECT_EQ(mesh.faceOrigins[f], origins[f].vertex ? -1 - element : refinement.level(0).topology.inputFace(element));
  }
}

TEST(TableFile, LeavesIndexBuffersOutThatNobodyWants) {
  const Far::Refinement refinement = tableRefinement(honeycomb::Test::cube(), 1);
  const TemporaryFolder folder;
  must(writeTableFile(folder / "a.hct", {refinement, nullptr, infoOf(refinement), false, false}));
  const TableMesh mesh = must(must(TableFile::open(folder / "a.hct")).mesh());
  EXPECT_TRUE(mesh.triangles.empty());
  EXPECT_TRUE(mesh.lines.empty());
  EXPECT_FALSE(mesh.faceVertices.empty());
}

TEST(TableFile, SaysWhatItWasMadeOf) {
  const Far::Refinement refinement = tableRefinement(honeycomb::Test::cube(), 2);
  const TableInfo expected = infoOf(refinement);
  const TableFile file = must(readTable(tableBytes(refinement)));
  EXPECT_EQ(file.info().meshHash, expected.meshHash);
  EXPECT_EQ(file.info().steps, expected.steps);
  EXPECT_EQ(file.info().primvars, expected.primvars);
  EXPECT_EQ(file.info().inputFaces, 6);
  EXPECT_EQ(file.levelCount(), 2);
  EXPECT_EQ(file.controlPoints(), 8);
  EXPECT_EQ(file.vertexCount(), refinement.last().topology.vertexCount());
}

TEST(TableFile, IsTheSameBytesEachTime) {
  const Far::Refinement refinement = tableRefinement(honeycomb::Test::torus(6, 5), 2, true);
  const Far::TileTable tiles = must(Far::buildTileTable(refinement, {.scratchPoints = 100}));
  EXPECT_EQ(tableBytes(refinement, &tiles), tableBytes(refinement, &tiles));
}

TEST(TableFile, RefusesARefinementThatItCantTellOf) {
  const TemporaryFolder folder;
  const Far::Refinement refinement = tableRefinement(honeycomb::Test::cube(), 2);
  TableInfo info = infoOf(refinement);
  info.steps.pop_back();
  EXPECT_THAT(writeTableFile(folder / "a.hct", {refinement, nullptr, info}).error().message,
              HasSubstr("1 steps are described and there are 2"));
  EXPECT_EQ(folder.entries(), 0);
}

TEST(MeshHash, TellsMeshesApart) {
  const Far::Polygons cube = honeycomb::Test::toPolygons(honeycomb::Test::cube());
  Far::Polygons turned = cube, creased = cube, tagged = cube;
  std::rotate(turned.indices.begin(), turned.indices.begin() + 1, turned.indices.begin() + 4);
  creased.creases = {{0, 1, 2}};
  tagged.corners = {0};
  EXPECT_EQ(meshHash(cube), meshHash(honeycomb::Test::toPolygons(honeycomb::Test::cube())));
  for (const Far::Polygons& other : {turned, creased, tagged}) EXPECT_NE(meshHash(cube), meshHash(other));
}

TEST(TableDifferences, NameSectionAndFirstElement) {
  const Far::Refinement refinement = tableRefinement(honeycomb::Test::cube(), 2);
  const Bytes bytes = tableBytes(refinement);
  const TableFile first = must(readTable(bytes));
  EXPECT_TRUE(differences(first, must(readTable(bytes))).empty());

  Bytes other = bytes;
  const auto section = std::ranges::find(first.sections(), "level 1 indices", &TableSection::name);
  other[section->offset + 9] ^= std::byte{1};
  const auto found = differences(first, must(readTable(other)));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].section, "level 1 indices");
  EXPECT_EQ(found[0].element, 2);

  const Far::Refinement limited = tableRefinement(honeycomb::Test::cube(), 2, true);
  const auto missing = differences(first, must(readTable(tableBytes(limited))));
  ASSERT_FALSE(missing.empty());
  EXPECT_FALSE(missing.back().inFirst);
  EXPECT_TRUE(missing.back().inSecond);
}

}  // namespace
}  // namespace honeycomb::Io::Test
