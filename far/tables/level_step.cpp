#include "far/tables/level_step.h"

#include <optional>
#include <utility>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/crease_blend.h"
#include "far/tables/crease_ends.h"
#include "far/tables/level_table_builder.h"
#include "far/tables/replaced_rows.h"
#include "far/topology/crease_children.h"
#include "far/topology/crease_cut.h"

namespace honeycomb::Far {

namespace {

/// Of splits that bring their own table nothing is known of the points.
std::int32_t cornerPoints(const SplitResult& split) {
  return split.table ? 0 : split.cornerPoints;
}

/// Creases whose last step comes are those with at most this many left.
constexpr double kLastStep = 1;

/// A step from a level with creases: it is opened or closed first, and the rows that read the points of the reshaped
/// level are made to read those of the level as it is.
class CreasedStep {
 public:
  CreasedStep(const Level& parent, const Scheme& scheme) : parent_(parent), scheme_(scheme) {}

  Result<Level> take() {
    if (uncut(level())) open_ = cutCreases(level(), 0);
    const bool closes = anyLasts();
    if (closes) closed_ = uncut(level()) ? cutCreases(level(), kLastStep) : weldCreases(level(), kLastStep);
    const std::optional<Reshaped>& shape = closes ? closed_ : open_;
    const Topology& from = shape ? shape->topology : level();
    Result<SplitResult> split = splitFor(from, scheme_).apply(from);
    if (!split) return tl::unexpected(split.error());
    LevelTable table = tableFrom(shape, *split);
    if (closes) {
      if (auto blended = blend(*split, table); !blended) return tl::unexpected(blended.error());
    }
    CreaseChildren creases = creaseChildren(from, *split);
    replaceRows(table, creaseEndRows(split->topology, creases, table, scheme_.centralPoints));
    TopologyArrays arrays = std::move(split->topology).arrays();
    arrays.creases = std::move(creases.creases);
    arrays.heldCorners = std::move(creases.heldCorners);
    if (shape) nameParents(*shape, arrays);
    return Level{Topology(std::move(arrays)), std::move(table), centralPointsOf(scheme_), cornerPoints(*split),
                 splitFor(from, scheme_).cornerPlace};
  }

 private:
  const Topology& level() const { return parent_.topology; }

  bool anyLasts() const {
    for (const CreaseEdge& crease : level().creases()) {
      if (crease.sharpness <= kLastStep) return true;
    }
    return false;
  }

  /// The table of a step from a shape of the level, reading the points of the level as it is.
  LevelTable tableFrom(const std::optional<Reshaped>& shape, const SplitResult& split) const {
    if (!shape) return buildLevelTable(parent_.points(), split, scheme_);
    LevelTable table = buildLevelTable(SourceLevel(shape->topology, parent_.central), split, scheme_);
    const std::int32_t reshaped = shape->topology.vertexCount();
    const bool byFace = parent_.central == CentralPoints::byFace;
    Array<std::int32_t>& indices = table.indices.edit();
    Parallel::forEach(0, static_cast<std::int64_t>(indices.size()), [&](std::int64_t i) {
      std::int32_t& point = indices[at(i)];
      if (point < reshaped) {
        point = shape->vertexOf[at(point)];
      } else {
        const std::int32_t face = point - reshaped;
        point = level().vertexCount() + (byFace ? shape->faceOf[at(face)] : face);
      }
    });
    table.sourceCount = parent_.pointCount();
    return table;
  }

  /// The points at the creases that are closed: partly those of a sharp step.
  Result<void> blend(const SplitResult& split, LevelTable& table) const {
    if (closed_->faces.empty() && !scheme_.centralPoints) return {};
    const Topology& open = open_ ? open_->topology : level();
    const Result<SplitResult> sharpSplit = splitFor(open, scheme_).apply(open);
    if (!sharpSplit) return tl::unexpected(sharpSplit.error());
    LevelTable sharpTable = tableFrom(open_, *sharpSplit);
    const CreaseChildren creases = creaseChildren(open, *sharpSplit);
    replaceRows(sharpTable, creaseEndRows(sharpSplit->topology, creases, sharpTable, scheme_.centralPoints));
    const ShapedStep smooth{closed_->topology, split, table};
    const ShapedStep sharp{open, *sharpSplit, sharpTable};
    replaceRows(table, blendCreases(*closed_, smooth, sharp, scheme_.centralPoints));
    return {};
  }

  void nameParents(const Reshaped& shape, TopologyArrays& arrays) const {
    for (const FaceRun& run : arrays.runs) {
      const std::vector<std::int32_t>& of = run.parent == FaceParent::vertex ? shape.vertexOf
                                            : run.parent == FaceParent::face ? shape.faceOf
                                                                             : shape.firstOf;
      Parallel::forEach(run.firstFace, run.firstFace + run.faceCount, [&](std::int64_t f) {
        std::int32_t& parent = arrays.parents[at(f)];
        parent = of[at(parent)];
      });
    }
  }

  const Level& parent_;
  const Scheme& scheme_;
  std::optional<Reshaped> open_;    // level 0 cut open; none where the level is open already
  std::optional<Reshaped> closed_;  // with the creases closed whose last step this is
};

}  // namespace

const Split& splitFor(const Topology& level, const Scheme& scheme) {
  return level.creases().empty() ? scheme.split : scheme.creases.split;
}

Result<Level> nextLevel(const Level& parent, const Scheme& scheme) {
  if (!parent.topology.creases().empty()) return CreasedStep(parent, scheme).take();
  Result<SplitResult> split = scheme.split.apply(parent.topology);
  if (!split) return tl::unexpected(split.error());
  LevelTable table = buildLevelTable(parent.points(), *split, scheme);
  const std::int32_t corners = cornerPoints(*split);
  return Level{std::move(split->topology), std::move(table), centralPointsOf(scheme), corners,
               scheme.split.cornerPlace};
}

}  // namespace honeycomb::Far
