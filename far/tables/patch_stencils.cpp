#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <unordered_map>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/patch_table.h"

namespace honeycomb::Far {
namespace {

using Sides = std::array<std::int32_t, 3>;

/// The weights other than zero of a row over the points of a patch.
struct LocalRow {
  std::vector<std::int32_t> points;  ///< places as in VertexPatch::point
  std::vector<double> weights;
};

/// A row and the patch whose points it reads.
struct PlacedRow {
  std::int32_t patch = 0;
  const LocalRow* row = nullptr;
};

LocalRow withoutZeros(const std::vector<double>& weights) {
  LocalRow row;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] == 0) continue;
    row.points.push_back(static_cast<std::int32_t>(i));
    row.weights.push_back(weights[i]);
  }
  return row;
}

LocalRow localRow(const Sides& sides, const PatchRow& row) {
  return withoutZeros(pointWeights(sides, row));
}

Result<Array<std::int32_t>> rowOffsets(std::span<const PlacedRow> rows) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  std::int64_t total = 0;
  for (const PlacedRow& placed : rows) total += static_cast<std::int64_t>(placed.row->points.size());
  if (total > kMost || static_cast<std::int64_t>(rows.size()) > kMost)
    return fail(ErrorCode::tooLarge,
                fmt::format("the stencils of {} points of the surface hold {} weights, more than 2^31 - 1; take fewer "
                            "points at a time",
                            rows.size(), total));
  Array<std::int32_t> offsets{0};
  offsets.reserve(rows.size() + 1);
  for (const PlacedRow& placed : rows) {
    offsets.push_back(offsets.back() + static_cast<std::int32_t>(placed.row->points.size()));
  }
  return offsets;
}

/// Row i writes point i.
Result<LevelTable> looseTable(const PatchTable& patches, std::span<const PlacedRow> rows) {
  Result<Array<std::int32_t>> offsets = rowOffsets(rows);
  if (!offsets) return tl::unexpected(offsets.error());
  LevelTable table;
  table.sourceCount = patches.topology().vertexCount();
  table.targetCount = static_cast<std::int32_t>(rows.size());
  table.loose.offsets = std::move(*offsets);
  table.loose.outputs.resize(rows.size());
  table.indices.edit().resize(at(table.loose.offsets.back()));
  table.weights.resize(table.indices.size());
  table.weightsSingle.resize(table.indices.size());
  Array<std::int32_t>& indices = table.indices.edit();
  const auto write = [&](std::int64_t i) {
    const LocalRow& row = *rows[at(i)].row;
    const VertexPatch patch = patches.patch(rows[at(i)].patch);
    table.loose.outputs[at(i)] = static_cast<std::int32_t>(i);
    for (std::size_t j = 0; j < row.points.size(); ++j) {
      const std::size_t entry = at(table.loose.offsets[at(i)]) + j;
      indices[entry] = patch.point(row.points[j]);
      table.weights[entry] = row.weights[j];
      table.weightsSingle[entry] = static_cast<float>(row.weights[j]);
    }
  };
  constexpr std::int64_t kRowGrain = 256;
  Parallel::forEach(0, static_cast<std::int64_t>(rows.size()), write, kRowGrain);
  return table;
}

/// What the weights of a sample depend on.
struct Signature {
  Sides sides;
  Barycentric barycentric;
  bool operator==(const Signature&) const = default;
};

struct SignatureHash {
  std::size_t operator()(const Signature& s) const {
    std::uint64_t hash = 0;
    // Fibonacci hashing of one number after the other.
    const auto add = [&](std::uint64_t number) { hash = std::rotl((hash ^ number) * 0x9e3779b97f4a7c15U, 29); };
    for (const std::int32_t n : s.sides) add(static_cast<std::uint64_t>(n));
    // Adding zero makes -0 and 0, which are equal, the same bits.
    for (const double u : s.barycentric) add(std::bit_cast<std::uint64_t>(u + 0.0));
    return hash;
  }
};

/// The distinct signatures among samples, in order of appearance, and which one each sample has.
struct SignatureList {
  std::vector<Signature> signatures;
  std::vector<std::int32_t> ofSample;
};

SignatureList listSignatures(const PatchTable& patches, std::span<const PatchSample> samples) {
  SignatureList list;
  list.ofSample.reserve(samples.size());
  std::unordered_map<Signature, std::int32_t, SignatureHash> known;
  for (const PatchSample& sample : samples) {
    const Signature signature{patches.patch(sample.patch).sides(), sample.barycentric};
    const auto [found, isNew] = known.try_emplace(signature, static_cast<std::int32_t>(list.signatures.size()));
    if (isNew) list.signatures.push_back(signature);
    list.ofSample.push_back(found->second);
  }
  return list;
}

struct SampleRows {
  LocalRow position, du, dv;
};

std::vector<SampleRows> signatureRows(const std::vector<Signature>& signatures) {
  std::vector<SampleRows> rows(signatures.size());
  const auto evaluate = [&](std::int64_t i) {
    const Signature& s = signatures[at(i)];
    const PatchDerivatives<PatchRow> row = evaluatePatch(unitFaces(s.sides), s.barycentric);
    rows[at(i)] = {localRow(s.sides, row.position), localRow(s.sides, row.du), localRow(s.sides, row.dv)};
  };
  constexpr std::int64_t kSignatureGrain = 16;
  Parallel::forEach(0, static_cast<std::int64_t>(signatures.size()), evaluate, kSignatureGrain);
  return rows;
}

}  // namespace

Result<LevelTable> PatchTable::bezierStencils() const {
  constexpr Sides kHexagons{6, 6, 6};
  const std::array<PatchRow, 10> bezier = Far::bezierPoints(unitFaces(kHexagons));
  std::array<LocalRow, 10> rows;
  for (std::size_t i = 0; i < 10; ++i) rows[i] = localRow(kHexagons, bezier[i]);
  std::vector<PlacedRow> placed;
  placed.reserve(10 * regular_.size());
  for (const std::int32_t patch : regular_) {
    for (const LocalRow& row : rows) placed.push_back({patch, &row});
  }
  return looseTable(*this, placed);
}

Result<LimitStencils> PatchTable::limitStencils(std::span<const PatchSample> samples) const {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (const Result<void> sound = check(samples[i]); !sound)
      return fail(sound.error().code, fmt::format("sample {}: {}", i, sound.error().message),
                  static_cast<std::int64_t>(i));
  }
  const SignatureList list = listSignatures(*this, samples);
  const std::vector<SampleRows> rows = signatureRows(list.signatures);
  const auto table = [&](LocalRow SampleRows::*part) {
    std::vector<PlacedRow> placed(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      placed[i] = {samples[i].patch, &(rows[at(list.ofSample[i])].*part)};
    }
    return looseTable(*this, placed);
  };
  Result<LevelTable> positions = table(&SampleRows::position);
  if (!positions) return tl::unexpected(positions.error());
  Result<LevelTable> du = table(&SampleRows::du);
  if (!du) return tl::unexpected(du.error());
  Result<LevelTable> dv = table(&SampleRows::dv);
  if (!dv) return tl::unexpected(dv.error());
  return LimitStencils{std::move(*positions), std::move(*du), std::move(*dv)};
}

}  // namespace honeycomb::Far
