#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "osd/vulkan/table.h"
#include "osd/vulkan/tile_image.h"

namespace honeycomb::Osd {

/// Are the layouts sound, with points of one length? Errors: invalidOption.
Result<void> checkDescriptors(const VulkanTableOptions& options);

/// Are these a layout of unit normals, and the points some that have normals? Errors: invalidOption.
Result<void> checkNormalLayout(const BufferDescriptor& points, const BufferDescriptor& normals);

/// Puts a VulkanTable together: levels and limits in table.cpp, fast normals of levels in normal_builder.cpp, tiles in
/// tile_builder.cpp, what goes before these in tile_shared_builder.cpp.
class TableBuilder {
 public:
  TableBuilder(const std::shared_ptr<const VulkanCore>& core, VulkanPipelines& pipelines,
               const VulkanTableOptions& options)
      : core_(core), pipelines_(pipelines) {
    state_.options = options;
  }

  /// `limits` and `fast` may be null, where the options want nothing of them.
  Result<VulkanTable> build(std::span<const Far::LevelTable* const> levels, const Far::LimitTable* limits,
                            const Far::NormalTable* fast);
  Result<VulkanTable> build(Far::LevelTables levels, const Far::TileTable& tiles, const VulkanTileOptions& options);

 private:
  using Steps = std::vector<std::vector<TableDispatch>>;
  /// Points of a buffer.
  struct Place {
    PointBuffer points;
    PointLayout layout;
  };

  Result<void> addLevels(std::span<const Far::LevelTable* const> levels, const Far::NormalTable* fast);
  Result<void> addLimits(const Far::LimitTable& limits);
  Result<Steps> level(const Far::LevelTable& table, PointBuffer source, PointBuffer target);
  Result<Steps> level(const Far::LevelTable& table, const Place& source, const Place& target);
  Result<Steps> frames(const Far::LimitRows& rows, const LimitLayouts& layouts, std::int64_t results,
                       const Place& source, PointBuffer positions, PointBuffer normals);
  Result<Steps> normalsOf(const Far::LimitRows& rows, const Place& points, const Place& normals);
  Result<void> joinFaceNormals(const Far::NormalTable& table, std::size_t k, const Place& points, Steps& next);
  Result<void> addNormalSums(const Far::NormalTable& table);
  Result<Steps> addStage(const StagePlan& plan, const TableImage& image, TableStage stage);
  Result<void> appendFrames(std::vector<TableDispatch>& phase, const Far::LimitRows& rows, const LimitLayouts& layouts,
                            std::int64_t results, PointBuffer source);
  Result<Place> addRoot(Far::LevelTables levels, const Far::TileTable& tiles);
  Result<void> addShared(const Far::TileTable& tiles, Place source);
  Result<void> copyShared(const Far::SharedPoints& set, std::int32_t k, const Place& points);
  Result<void> copyRuns(std::span<const Far::SharedPoints::Run> runs, const Place& from, const Place& to);
  Result<void> addSharedNormals(const Far::TileTable& tiles, std::int32_t k, const Place& points);
  Result<void> addNormals(const Far::LimitRows& rows, const Place& points, const Place& normals);
  Result<void> addTiles(const Far::TileTable& tiles, const Place& root, const VulkanTileOptions& options);
  Result<void> checkPages(const StagePlanner& stage) const;
  Result<Dispatch> tileDispatch(const Far::TileTable& tiles, const StagePlanner& stage, std::uint32_t points,
                                TileScratch scratch) const;
  void setTarget(Dispatch& dispatch, const StagePlanner& stage) const;
  Result<void> addTileStage(const TileImage& image, const Place& root, Dispatch dispatch);
  Result<void> addPieces(const Dispatch& whole, const TileImage& image);
  void setGroups(Dispatch& dispatch, const TileImage& image);
  void setPiece(Dispatch& dispatch, const Dispatch& whole, const TileImage& image, std::int32_t first) const;
  static PointBuffer scratchOf(std::size_t level) {
    return level % 2 == 0 ? PointBuffer::scratchEven : PointBuffer::scratchOdd;
  }
  /// The layout of the vertices' normals; none where they aren't wanted.
  const std::optional<BufferDescriptor>& normals() const { return state_.options.vertexLimits.normals; }
  std::uint64_t normalBytes() const {
    return normals() ? static_cast<std::uint64_t>(normals()->extent(state_.refinedCount)) * sizeof(float) : 0;
  }
  Place normalPlace() const { return {PointBuffer::vertexNormals, {*normals(), state_.refinedCount}}; }
  std::uint64_t bytesOf(PointBuffer points) const { return state_.bytes[static_cast<std::size_t>(points)]; }
  Place placeOf(PointBuffer points, std::int64_t count) const { return {points, layoutOf(points, count)}; }
  void append(Steps& steps);
  PointLayout layoutOf(PointBuffer points, std::int64_t count) const;
  void need(PointBuffer points, std::uint64_t bytes) {
    auto& needed = state_.bytes[static_cast<std::size_t>(points)];
    needed = std::max(needed, bytes);
  }

  std::shared_ptr<const VulkanCore> core_;
  VulkanPipelines& pipelines_;
  VulkanTable::State state_;
  Far::TileNormalKind normalKind_ = Far::TileNormalKind::none;  ///< wanted of tiles
};

}  // namespace honeycomb::Osd
