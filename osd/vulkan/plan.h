#pragma once

#include <optional>

#include "far/tables/level_table.h"
#include "far/tables/limit_table.h"
#include "far/tables/normal_rule.h"
#include "osd/vulkan/stage_planner.h"

namespace honeycomb::Osd {

/// The dispatches of a level; its arrays are added to the image, which refers to the table until it is uploaded.
///     step 1   circulants, loose rows, block sums of large faces
///     step 2   sums of large faces                                 (only where there are large faces)
///     step 3   outputs of large faces, summed rows
/// Errors: tooLarge.
Result<StagePlan> planLevel(const VulkanLimits& limits, const Far::LevelTable& table, const PointLayout& source,
                            const PointLayout& target, TableImage& image);

/// Where limits are written; either may be absent.
struct LimitLayouts {
  std::optional<BufferDescriptor> positions{};  ///< length 3
  std::optional<BufferDescriptor> normals{};    ///< length 3
  bool empty() const { return !positions && !normals; }
};

/// The dispatches of limit positions and normals: one step. `results` is the number of points in the buffers that are
/// written. Errors: tooLarge.
Result<StagePlan> planLimits(const VulkanLimits& limits, const Far::LimitRows& rows, const PointLayout& source,
                             const LimitLayouts& layouts, std::int64_t results, TableImage& image);

/// The dispatches that sum the normals of faces (packed, by the numbers of `table`) to unit normals of points: one
/// step. Errors: tooLarge.
Result<StagePlan> planNormals(const VulkanLimits& limits, const Far::NormalTable& table,
                              const BufferDescriptor& normals, TableImage& image);

}  // namespace honeycomb::Osd
