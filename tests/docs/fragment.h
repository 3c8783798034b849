#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "far/conversions/conversions.h"
#include "far/schemes/akleman.h"
#include "far/schemes/half_box.h"
#include "far/schemes/zhang_wang.h"
#include "far/tables/patch_table.h"
#include "far/tables/refinement.h"
#include "far/tables/stencil_table.h"
#include "far/tables/tile_table.h"
#include "osd/cpu_evaluator.h"
#include "osd/tile_evaluator.h"

using namespace honeycomb;

/// What the C++ fragments of the pages take for granted: the reader's mesh, here a cube, and room for its level 4.
class Documentation : public testing::Test {
 protected:
  Documentation() {
    polygons.vertexCount = 8;
    for (const auto& face :
         {std::vector{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}}) {
      polygons.addFace(face);
    }
    for (const float z : {0.0f, 1.0f}) {
      for (const float y : {0.0f, 1.0f}) control.insert(control.end(), {0, y, z, 1, y, z});
    }
  }

  /// A fragment that writes points writes all of them.
  void TearDown() override {
    const auto unwritten = std::count_if(refined.begin(), refined.end(), [](float x) { return std::isnan(x); });
    EXPECT_TRUE(unwritten == 0 || unwritten == static_cast<std::ptrdiff_t>(refined.size()))
        << unwritten << " of " << refined.size() << " coordinates";
  }

  static constexpr std::size_t kVertices = 648;  // 2 * 12 * 3^3

  Far::Polygons polygons;
  std::vector<float> control;  // x y z of its 8 vertices
  std::vector<float> refined = std::vector<float>(kVertices * 3, std::numeric_limits<float>::quiet_NaN());
};
