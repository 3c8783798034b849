#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "apps/demo/animation.h"
#include "far/base/result.h"
#include "far/tables/refinement.h"

namespace honeycomb::Demo {

/// An evaluator ready to refine frames.
struct Contestant {
  std::string name;
  double preparation = 0;  ///< ms beyond the tables: tiles; pipelines and uploads
  /// Control points of a frame to the vertices of the last level, x y z packed; the result is valid until the next
  /// call.
  std::function<Result<std::span<const float>>(std::span<const float>)> refine;
};

/// How an evaluator did.
struct Standing {
  std::string name;
  double buildTime = 0;          ///< ms, topology and tables included
  double frameTime = 0;          ///< ms, median
  double vertexRate = 0;         ///< refined vertices a second, at the median
  std::uint32_t difference = 0;  ///< largest distance from the first contestant's numbers, in units of the last place
};

/// The reference: must come first in a contest.
Contestant serialContestant(const Far::Refinement& refinement);
Contestant threadedContestant(const Far::Refinement& refinement);
/// On all threads too, by tiles. Errors: those of Far::buildTileTable.
Result<Contestant> tiledContestant(const Far::Refinement& refinement);

/// The vertices among the points of the last level, which come first.
std::span<const float> verticesOf(const Far::Refinement& refinement, std::span<const float> points);

/// How many representable numbers lie between a and b; 0 only when their bits are equal.
std::uint32_t bitDistance(float a, float b);

/// Every contestant refines every frame. `tableTime`: ms that topology and tables took.
Result<std::vector<Standing>> runContest(std::span<const Contestant> contestants, const Animation& animation,
                                         std::int32_t frameCount, double tableTime);

/// The standings as lines of text with a heading.
std::string tableOf(std::span<const Standing> standings);

}  // namespace honeycomb::Demo
