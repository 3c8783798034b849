#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "far/base/index.h"
#include "far/tables/tile_table.h"
#include "fixture.h"
#include "osd/cpu_evaluator.h"
#include "osd/normal_evaluator.h"
#include "osd/vulkan/session.h"
#include "runs.h"
#include "tests/support/must.h"
#include "tests/support/random_tables.h"
#include "tests/support/refined.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"

/// Tiles on the device beside the serial evaluator, level after level.
namespace honeycomb::VulkanTests {

namespace Meshes = honeycomb::Test;
using Meshes::must;
using Meshes::schemeCase;
using Osd::BufferDescriptor;
using Osd::TileScratch;

/// Control and refined points: packed, padded, behind an offset, fewer and more values than a position has.
struct Layouts {
  BufferDescriptor control;
  BufferDescriptor refined;
};
inline const std::vector<Layouts> kPositions = {{{0, 3, 3}, {0, 3, 3}}, {{0, 3, 3}, {2, 3, 4}}, {{0, 4, 4}, {0, 4, 4}}};
inline const std::vector<Layouts> kPrimvars = {{{1, 2, 3}, {3, 2, 2}}, {{0, 1, 1}, {0, 1, 2}}, {{2, 4, 5}, {1, 4, 4}},
                                               {{0, 3, 3}, {1, 3, 3}}, {{0, 3, 3}, {3, 3, 3}}, {{0, 3, 3}, {6, 3, 3}},
                                               {{3, 3, 3}, {0, 3, 3}}, {{2, 3, 3}, {0, 3, 3}}, {{4, 4, 4}, {4, 4, 4}},
                                               {{2, 4, 4}, {8, 4, 4}}, {{0, 7, 7}, {4, 7, 8}}};

/// Normals: packed, padded behind an offset.
inline const std::vector<BufferDescriptor> kNormals = {{0, 3, 3}, {1, 3, 4}};

/// How a refinement is cut into tiles, and what is wanted of them.
struct TileRun {
  std::int32_t scratchPoints = 500;
  TileScratch scratch = TileScratch::buffer;
  Layouts layouts = kPositions[0];
  std::int32_t level = 0;
  Far::TilePlaces places = Far::TilePlaces::faces;
  Far::TileNormalKind kind = Far::TileNormalKind::none;  ///< that the tiles are built with
  std::optional<BufferDescriptor> normals = std::nullopt;
};

inline Far::Refinement aklemanOf(const Meshes::PolyMesh& mesh, std::int32_t levels, bool limits = false) {
  return Meshes::refined(mesh, schemeCase(Meshes::NamedTension::paper).scheme, levels, {}, limits);
}

class TilesTest : public VulkanTest {
 protected:
  // One evaluator, whose pipelines serve many meshes.
  void SetUp() override {
    VulkanTest::SetUp();
    if (context) evaluator.emplace(makeEvaluator());
  }
  void TearDown() override {
    evaluator.reset();
    VulkanTest::TearDown();
  }

  static std::vector<float> controlOf(const Far::Refinement& refinement, const Layouts& layouts, std::uint32_t frame) {
    return Meshes::randomNumbers(layouts.control.extent(refinement.level(0).pointCount()), frame);
  }
  static std::vector<float> chained(const Far::Refinement& refinement, std::int32_t level, const Layouts& layouts,
                                    const std::vector<float>& control) {
    std::vector<float> points(at(layouts.refined.extent(refinement.level(level).pointCount())));
    Osd::SerialEvaluator serial;
    must(serial.evaluate<float>(refinement, level, {control, layouts.control}, {points, layouts.refined}));
    return points;
  }

  // Level after level; `points` are those of the last level.
  static std::vector<float> chainedNormals(const Far::Refinement& refinement, const TileRun& run,
                                           const std::vector<float>& control, std::vector<float> points) {
    const BufferDescriptor& desc = *run.normals;
    std::vector<float> normals(at(desc.extent(refinement.last().pointCount())));
    const Osd::PointsOut<float> out{normals, desc};
    if (run.kind == Far::TileNormalKind::fast) {
      const auto table = must(Far::buildNormalTable(refinement, refinement.levelCount()));
      must(Osd::NormalEvaluator(Osd::CpuEvaluator::Threads::one)
               .evaluate<float>(refinement, table, {control, run.layouts.control}, {points, run.layouts.refined}, out));
    } else {
      const BufferDescriptor positions{run.layouts.refined.offset, 3, run.layouts.refined.stride};
      must(Osd::SerialEvaluator().vertexLimits<float>(refinement.limits(), {points, positions}, {}, out));
    }
    return normals;
  }

  static Osd::VulkanTileOptions optionsOf(const TileRun& run) {
    return {.control = run.layouts.control,
            .refined = run.layouts.refined,
            .level = run.level,
            .scratch = run.scratch,
            .normals = run.normals};
  }

  testing::AssertionResult agree(const Far::Refinement& refinement, const TileRun& run) {
    const Far::TileTable tiles = must(Far::buildTileTable(
        refinement, {.scratchPoints = run.scratchPoints, .normals = run.kind, .places = run.places}));
    auto table = evaluator->uploadTiles(refinement, tiles, optionsOf(run));
    if (!table) return testing::AssertionFailure() << table.error().message;
    Osd::VulkanSession session = must(Osd::VulkanSession::create(*evaluator, std::move(*table)));
    return sameFrames(refinement, session, run);
  }

  // Without tiles, level after level.
  testing::AssertionResult agreeByLevels(const Far::Refinement& refinement, const Layouts& layouts) {
    auto session = must(
        Osd::VulkanSession::create(*evaluator, refinement, {.control = layouts.control, .refined = layouts.refined}));
    return sameFrames(refinement, session, {.layouts = layouts});
  }

  // Two frames of the session beside the serial evaluator.
  static testing::AssertionResult sameFrames(const Far::Refinement& refinement, Osd::VulkanSession& session,
                                             const TileRun& run) {
    const std::int32_t level = run.level == 0 ? refinement.levelCount() : run.level;
    for (const std::uint32_t frame : {1U, 2U}) {
      const std::vector<float> control = controlOf(refinement, run.layouts, frame);
      std::ranges::copy(control, session.control().begin());
      if (const auto ran = session.run(); !ran) return testing::AssertionFailure() << ran.error().message;
      const std::vector<float> points = chained(refinement, level, run.layouts, control);
      if (auto same = sameBits(points, session.refined()); !same) {
        return same << ", frame " << frame << ", level " << level;
      }
      if (!run.normals) continue;
      if (auto same = sameBits(chainedNormals(refinement, run, control, points), session.vertexNormals()); !same) {
        return same << ", normals of frame " << frame;
      }
    }
    return testing::AssertionSuccess();
  }

  // A share of the schemes under sanitizers and validation, which see nothing of what kernels compute.
  static std::size_t schemeStep() {
    const std::size_t schemes = Meshes::listedSchemes().size();
    return Meshes::meshes(schemes) < schemes || validationWanted() ? 7 : 1;
  }

  // From scheme `first` on.
  void agreeUnderEveryScheme(const Meshes::PolyMesh& mesh, TileRun run, std::size_t first) {
    const auto& schemes = Meshes::listedSchemes();
    for (std::size_t i = first % schemeStep(); i < schemes.size(); i += schemeStep()) {
      SCOPED_TRACE(schemes[i].name);
      const bool limits = run.kind == Far::TileNormalKind::exact;
      const Far::Refinement refinement = Meshes::refinedBy(schemes[i], Meshes::toTopology(mesh), 3, limits);
      run.layouts = kPositions[i % kPositions.size()];
      if (run.kind != Far::TileNormalKind::none) run.normals = kNormals[i % kNormals.size()];
      ASSERT_TRUE(agree(refinement, run));
    }
  }

  std::optional<Osd::VulkanEvaluator> evaluator;
};

}  // namespace honeycomb::VulkanTests
