#include "far/tables/table_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// Values whose soundness is told by one number: small enough to find the first unsound one in quickly, large enough
/// for vectors.
constexpr std::int64_t kProofBlock = 16384;
constexpr std::int64_t kBlocksPerTask = 8;

/// The first i < count with unsound(i), found in the first block for which blockUnsound(begin, end) holds; -1: none.
template <class BlockUnsound, class Unsound>
std::int64_t firstUnsound(std::int64_t count, const BlockUnsound& blockUnsound, const Unsound& unsound) {
  std::vector<std::uint8_t> blocks(at((count + kProofBlock - 1) / kProofBlock));
  const auto endOf = [&](std::int64_t block) { return std::min(count, (block + 1) * kProofBlock); };
  Parallel::forEach(
      0, std::ssize(blocks), [&](std::int64_t b) { blocks[at(b)] = blockUnsound(b * kProofBlock, endOf(b)) ? 1 : 0; },
      kBlocksPerTask);
  const std::int64_t block = std::find(blocks.begin(), blocks.end(), 1) - blocks.begin();
  for (std::int64_t i = block * kProofBlock; i < count; ++i) {
    if (unsound(i)) return i;
  }
  return -1;
}

template <class... Arguments>
Result<void> broken(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  return fail(ErrorCode::invalidFile, fmt::format(text, std::forward<Arguments>(arguments)...));
}

/// What a batch takes of a table's arrays.
struct Extent {
  std::int64_t first = 0;
  std::int64_t count = 0;
};

/// Do all parts of a batch lie in their arrays?
Result<void> proveBatch(const LevelTable& table, std::string_view kind, std::size_t number, Extent indices,
                        Extent outputs, Extent weights) {
  if (!liesWithin(indices.first, indices.count, std::ssize(table.indices)))
    return broken("{} batch {} reads past the indices", kind, number);
  if (!liesWithin(outputs.first, outputs.count, table.targetCount))
    return broken("{} batch {} writes past the level's points", kind, number);
  if (!liesWithin(weights.first, weights.count, std::ssize(table.weights)))
    return broken("{} batch {} reads past the weights", kind, number);
  return {};
}

Result<void> proveCirculants(const LevelTable& table) {
  for (std::size_t i = 0; i < table.circulants.size(); ++i) {
    const CirculantBatch& batch = table.circulants[i];
    if (!isFormOf(batch.form, batch.sides)) return broken("circulant batch {} has no such form", i);
    const std::int64_t points = std::int64_t{batch.faceCount} * batch.sides;
    auto sound = proveBatch(table, "circulant", i, {batch.firstIndex, points}, {batch.firstOutput, points},
                            {batch.firstForm, batch.formWeights()});
    if (!sound) return sound;
    if (!liesWithin(batch.firstRow, batch.sides, std::ssize(table.weights)))
      return broken("circulant batch {} reads past the weights", i);
  }
  return {};
}

Result<void> proveProjected(const LevelTable& table) {
  for (std::size_t i = 0; i < table.projected.size(); ++i) {
    const ProjectedFace& face = table.projected[i];
    const bool turns = face.firstCorner >= 0 && face.firstCorner < std::max(face.corners, 1) &&
                       std::int64_t{face.firstCorner} + face.outputs <= 2 * std::int64_t{face.corners};
    if (face.corners < 1 || face.outputs < 0 || !turns) return broken("projected face {} has no such corners", i);
    const std::int64_t weights =
        2 + std::int64_t{face.corners} * (face.outputs > 0 ? 3 : 1) + 3 * std::int64_t{face.outputs};
    auto sound = proveBatch(table, "projected", i, {face.firstIndex, face.corners}, {face.firstOutput, face.outputs},
                            {face.firstWeight, weights});
    if (!sound) return sound;
  }
  return {};
}

Result<void> proveDense(const LevelTable& table) {
  for (std::size_t i = 0; i < table.dense.size(); ++i) {
    const DenseRows& batch = table.dense[i];
    if (batch.width < 1 || batch.width > kWidestDense) return broken("dense batch {} has no such width", i);
    auto sound = proveBatch(table, "dense", i, {batch.firstIndex, std::int64_t{batch.rowCount} * batch.width},
                            {batch.firstOutput, batch.rowCount}, {batch.firstWeight, batch.width});
    if (!sound) return sound;
  }
  return {};
}

/// One offset more than rows, and a place to begin within the arrays.
Result<void> proveRowShape(const LevelTable& table, const LooseRows& rows, std::string_view kind) {
  if (rows.offsets.size() != rows.outputs.size() + 1) return broken("{} rows have as many offsets as rows", kind);
  if (!liesWithin(rows.firstIndex, 0, std::ssize(table.indices)) ||
      !liesWithin(rows.firstWeight, 0, std::ssize(table.weights)))
    return broken("{} rows begin past the indices or the weights", kind);
  return {};
}

/// Each row has at least `fewest` entries, within the arrays, and writes a point of the level.
Result<void> proveRows(const LevelTable& table, const LooseRows& rows, std::int32_t fewest, std::string_view kind) {
  const std::int64_t entries =
      std::min(std::ssize(table.indices) - rows.firstIndex, std::ssize(table.weights) - rows.firstWeight);
  if (const std::int64_t i = firstNotAscending(rows.offsets, fewest, entries); i >= 0)
    return broken("offset {} of the {} rows is out of place", i, kind);
  if (const std::int64_t i = firstOutside(rows.outputs, table.targetCount); i >= 0)
    return broken("{} row {} writes past the level's points", kind, i);
  return {};
}

/// A row reads points or shares, or both.
Result<void> proveSummed(const LevelTable& table) {
  const SummedRows& summed = table.summed;
  if (auto sound = proveRows(table, summed.rows, 0, "summed"); !sound) return sound;
  const std::int64_t shares = std::min(std::ssize(summed.faces), std::ssize(table.weights) - summed.firstShare);
  if (const std::int64_t i = firstNotAscending(summed.shareOffsets, 0, shares); i >= 0)
    return broken("offset {} of the shares of summed rows is out of place", i);
  if (const std::int64_t i = firstOutside(summed.faces, static_cast<std::int32_t>(table.projected.size())); i >= 0)
    return broken("share {} of summed rows is of no projected face", i);
  for (std::size_t r = 0; r < at(summed.rowCount()); ++r) {
    if (summed.rows.offsets[r] == summed.rows.offsets[r + 1] && summed.shareOffsets[r] == summed.shareOffsets[r + 1])
      return broken("summed row {} reads nothing", r);
  }
  return {};
}

/// A level has as many points as its rows write, and rows read something for each: a table makes no more points than
/// its size allows.
Result<void> proveOutputs(const LevelTable& table) {
  std::int64_t outputs = std::int64_t{table.loose.rowCount()} + table.summed.rowCount();
  for (const CirculantBatch& batch : table.circulants) outputs += std::int64_t{batch.faceCount} * batch.sides;
  for (const ProjectedFace& face : table.projected) outputs += face.outputs;
  for (const DenseRows& batch : table.dense) outputs += batch.rowCount;
  // A face's half may have two outputs a corner; a summed row may read shares alone.
  const std::int64_t most = 2 * std::ssize(table.indices) + table.summed.rowCount();
  if (outputs == table.targetCount && outputs <= most) return {};
  return broken("it has {} points, its rows write {}, and its indices allow {}", table.targetCount, outputs, most);
}

}  // namespace

std::int64_t firstOutside(std::span<const std::int32_t> values, std::int32_t end) {
  const auto top = static_cast<std::uint32_t>(end) - 1;
  // Below zero, or more than the last: either sets the highest bit.
  const auto blockOutside = [&](std::int64_t begin, std::int64_t last) {
    std::uint32_t bits = 0;
    for (std::int64_t i = begin; i < last; ++i) {
      const auto value = static_cast<std::uint32_t>(values[at(i)]);
      bits |= value | (top - value);
    }
    return (bits >> 31U) != 0 || end <= 0;
  };
  return firstUnsound(std::ssize(values), blockOutside,
                      [&](std::int64_t i) { return values[at(i)] < 0 || values[at(i)] >= end; });
}

std::int64_t firstNotAscending(std::span<const std::int32_t> offsets, std::int32_t step, std::int64_t end) {
  const auto outOfPlace = [&](std::int64_t i) {
    const std::int64_t least = i == 0 ? 0 : std::int64_t{offsets[at(i - 1)]} + step;
    return offsets[at(i)] < least || offsets[at(i)] > end;
  };
  const auto anyOutOfPlace = [&](std::int64_t begin, std::int64_t last) {
    for (std::int64_t i = begin; i < last; ++i) {
      if (outOfPlace(i)) return true;
    }
    return false;
  };
  return firstUnsound(std::ssize(offsets), anyOutOfPlace, outOfPlace);
}

bool isFormOf(CirculantForm form, std::int32_t sides) {
  if (sides < 3 || sides > kLargestCirculant) return false;
  switch (form) {
    case CirculantForm::direct:
      return sides % 2 == 1;
    case CirculantForm::evenOdd:
      return sides % 2 == 0;
    case CirculantForm::quad:
      return sides == 4;
    case CirculantForm::hexagon:
      return sides == 6;
  }
  return false;
}

Result<void> proveShape(const LevelTable& table) {
  if (table.sourceCount < 0 || table.targetCount < 0) return broken("it has no such number of points");
  if (table.weights.size() != table.weightsSingle.size())
    return broken("there are {} weights, and {} rounded ones", table.weights.size(), table.weightsSingle.size());
  for (const auto prove : {proveCirculants, proveProjected, proveDense, proveOutputs}) {
    if (auto sound = prove(table); !sound) return sound;
  }
  if (auto sound = proveRowShape(table, table.loose, "loose"); !sound) return sound;
  if (auto sound = proveRowShape(table, table.summed.rows, "summed"); !sound) return sound;
  if (table.summed.shareOffsets.size() != table.summed.rows.offsets.size() ||
      !liesWithin(table.summed.firstShare, 0, std::ssize(table.weights)))
    return broken("the shares of summed rows begin past the weights");
  return {};
}

Result<void> proveIndices(const LevelTable& table) {
  if (const std::int64_t i = firstOutside(table.indices, table.sourceCount); i >= 0)
    return broken("index {} is {}, and the level before has {} points", i, table.indices[at(i)], table.sourceCount);
  if (auto sound = proveRows(table, table.loose, 1, "loose"); !sound) return sound;
  return proveSummed(table);
}

Result<void> proveShape(const LimitRows& rows) {
  if (rows.weights.size() != rows.weightsSingle.size())
    return broken("there are {} weights, and {} rounded ones", rows.weights.size(), rows.weightsSingle.size());
  std::int64_t indices = 0, elements = 0;
  for (std::size_t i = 0; i < rows.batches.size(); ++i) {
    const FrameBatch& batch = rows.batches[i];
    if (batch.sides < 0 || batch.count < 0) return broken("batch {} has no such sides", i);
    indices += std::int64_t{batch.count} * batch.sides;
    elements += batch.count;
    if (!liesWithin(batch.firstIndex, std::int64_t{batch.count} * batch.sides, std::ssize(rows.indices)) ||
        !liesWithin(batch.firstElement, batch.count, std::ssize(rows.elements)) ||
        !liesWithin(batch.firstWeight, 3 * std::int64_t{batch.sides}, std::ssize(rows.weights)))
      return broken("batch {} reads past its arrays", i);
    // Batches that share their elements would take more time than the table's size justifies.
    if (indices > std::ssize(rows.indices) || elements > std::ssize(rows.elements))
      return broken("batch {} and those before have more elements than there are", i);
  }
  return {};
}

Result<void> proveIndices(const LimitRows& rows, std::int32_t points, std::int32_t elements) {
  if (const std::int64_t i = firstOutside(rows.indices, points); i >= 0)
    return broken("index {} is {}, and there are {} points", i, rows.indices[at(i)], points);
  if (const std::int64_t i = firstOutside(rows.elements, elements); i >= 0)
    return broken("element {} is {}, and there are {}", i, rows.elements[at(i)], elements);
  return {};
}

Result<void> proveShape(const LimitTable& limits, std::int32_t points) {
  for (const LimitRows* rows : {&limits.faces, &limits.vertices, &limits.verticesHere}) {
    if (rows->sourceCount < 0 || rows->elementCount < 0) return broken("they have no such number of points");
    if (auto sound = proveShape(*rows); !sound) return sound;
  }
  if (auto sound = proveShape(limits.child); !sound) return sound;
  const bool none = limits.faces.sourceCount == 0 && limits.child.sourceCount == 0;
  const bool fits = limits.faces.sourceCount == points && limits.child.sourceCount == points;
  const bool fitsHere = limits.verticesHere.batches.empty() || limits.verticesHere.sourceCount == points;
  const bool sameVertices = limits.vertices.elementCount == limits.verticesHere.elementCount;
  if (none && limits.faces.batches.empty() && limits.vertices.batches.empty() && limits.verticesHere.batches.empty())
    return {};
  if (!fits || !fitsHere || !sameVertices || limits.vertices.sourceCount > limits.child.targetCount)
    return broken("they are of another level than the last");
  return {};
}

Result<void> proveIndices(const LimitTable& limits) {
  for (const LimitRows* rows : {&limits.faces, &limits.vertices, &limits.verticesHere}) {
    if (auto sound = proveIndices(*rows, rows->sourceCount, rows->elementCount); !sound) return sound;
  }
  return proveIndices(limits.child);
}

}  // namespace honeycomb::Far
