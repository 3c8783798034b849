#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "osd/buffer_descriptor.h"

namespace honeycomb::Osd {

/// Where a workgroup keeps the points of its tile.
enum class TileScratch : std::uint8_t {
  automatic,  ///< what is faster on the kind of device and holds the tiles
  buffer,     ///< a slice of a buffer, for tiles of any size
  shared      ///< shared memory, for tiles that fit it
};

/// How tiles are evaluated, and how the points lie in their buffers.
struct VulkanTileOptions {
  BufferDescriptor control{};  ///< control points, which are read
  BufferDescriptor refined{};  ///< points of the wanted level, which are written; the same length as control
  std::int32_t level = 0;      ///< the wanted level; 0: the tiles' last. TileOrder::tiles: none but the last
  TileScratch scratch = TileScratch::automatic;
  /// Unit normals of the last level's points, of the kind that the tiles were built with, into
  /// VulkanTargets::vertexNormals; points then have 3 or 4 values. The zero vector of points that are not vertices.
  /// None: no normals, at no cost.
  std::optional<BufferDescriptor> normals{};
  /// Ascending numbers of tiles (Far::TileTable::tilesOf): only these are uploaded and evaluated, and what no tile
  /// writes. None: all. Levels up to the tiles' root level are written whole, and exact normals of vertices that read
  /// too many points for a tile.
  std::optional<std::span<const std::int32_t>> only{};
};

}  // namespace honeycomb::Osd
