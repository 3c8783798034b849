#pragma once

#include <cstdint>

#include "far/tables/tile_table.h"

namespace honeycomb::Osd {

/// What becomes of the stages of a step, as shaders/tile.glsl numbers it.
enum class TileStages : std::uint32_t {
  kept,     ///< none is written
  both,     ///< the last is written, those before it are kept
  written,  ///< the only one is written
  also      ///< the last is written and kept, as those before it are
};

/// Which of the branches of shaders/tile.glsl runs a step.
enum class TileCase : std::uint32_t {
  shapes = 0,  ///< of faces: four, by TileStages, for each shape that has a kernel of its own
  anySides = 32,
  dense = 33,  ///< four
  loose = 37,  ///< four
  importedNormals = 41,
  faceNormals = 42,    ///< two: of hexagons, of any face
  vertexNormals = 44,  ///< two: of vertices that read six points, of any
  cornerNormals = 46,  ///< two: of hexagons with one neighbour a corner, of any face
  summedNormals = 48
};

constexpr std::uint32_t caseAfter(TileCase first, std::uint32_t offset) {
  return static_cast<std::uint32_t>(first) + offset;
}

/// The case of a step of faces or rows.
std::uint32_t caseOf(const Far::TileStep& step, TileStages stages);

}  // namespace honeycomb::Osd
