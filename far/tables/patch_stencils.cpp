#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <unordered_map>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/patch_rows.h"
#include "far/tables/patch_table.h"

namespace honeycomb::Far {
namespace {

using Sides = std::array<std::int32_t, 3>;

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
  PatchWeights position, du, dv;
};
using SamplePart = PatchWeights SampleRows::*;
constexpr std::array<SamplePart, 3> kSampleParts{&SampleRows::position, &SampleRows::du, &SampleRows::dv};

std::vector<SampleRows> signatureRows(const std::vector<Signature>& signatures) {
  std::vector<SampleRows> rows(signatures.size());
  const auto evaluate = [&](std::int64_t i) {
    const Signature& s = signatures[at(i)];
    const PatchDerivatives<PatchRow> row = evaluatePatch(unitFaces(s.sides), s.barycentric);
    rows[at(i)] = {patchWeights(s.sides, row.position), patchWeights(s.sides, row.du), patchWeights(s.sides, row.dv)};
  };
  constexpr std::int64_t kSignatureGrain = 16;
  Parallel::forEach(0, static_cast<std::int64_t>(signatures.size()), evaluate, kSignatureGrain);
  return rows;
}

/// The rows of samples, one after the other.
class SampleStencils {
 public:
  SampleStencils(const PatchTable& patches, std::span<const PatchSample> samples)
      : patches_(patches),
        samples_(samples),
        list_(listSignatures(patches, samples)),
        rows_(signatureRows(list_.signatures)) {}

  Result<LevelTable> table(std::span<const SamplePart> parts) const {
    std::vector<PlacedPatchRow> placed;
    placed.reserve(parts.size() * samples_.size());
    for (const SamplePart part : parts) {
      for (std::size_t i = 0; i < samples_.size(); ++i) {
        placed.push_back({samples_[i].patch, &(rows_[at(list_.ofSample[i])].*part)});
      }
    }
    return patchRowTable(patches_, placed);
  }

 private:
  const PatchTable& patches_;
  std::span<const PatchSample> samples_;
  SignatureList list_;
  std::vector<SampleRows> rows_;
};

}  // namespace

Result<LevelTable> PatchTable::bezierStencils() const {
  constexpr Sides kHexagons{6, 6, 6};
  const std::array<PatchRow, 10> bezier = Far::bezierPoints(unitFaces(kHexagons));
  std::array<PatchWeights, 10> rows;
  for (std::size_t i = 0; i < 10; ++i) rows[i] = patchWeights(kHexagons, bezier[i]);
  std::vector<PlacedPatchRow> placed;
  placed.reserve(10 * regular_.size());
  for (const std::int32_t patch : regular_) {
    for (const PatchWeights& row : rows) placed.push_back({patch, &row});
  }
  return patchRowTable(*this, placed);
}

Result<void> PatchTable::check(std::span<const PatchSample> samples) const {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (const Result<void> sound = check(samples[i]); !sound)
      return fail(sound.error().code, fmt::format("sample {}: {}", i, sound.error().message),
                  static_cast<std::int64_t>(i));
  }
  return {};
}

Result<LimitStencils> PatchTable::limitStencils(std::span<const PatchSample> samples) const {
  if (const Result<void> sound = check(samples); !sound) return tl::unexpected(sound.error());
  const SampleStencils stencils(*this, samples);
  std::array<LevelTable, kSampleParts.size()> tables;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    Result<LevelTable> table = stencils.table(std::span(kSampleParts).subspan(i, 1));
    if (!table) return tl::unexpected(table.error());
    tables[i] = std::move(*table);
  }
  return LimitStencils{std::move(tables[0]), std::move(tables[1]), std::move(tables[2])};
}

Result<LevelTable> PatchTable::limitFrames(std::span<const PatchSample> samples) const {
  if (const Result<void> sound = check(samples); !sound) return tl::unexpected(sound.error());
  return SampleStencils(*this, samples).table(kSampleParts);
}

}  // namespace honeycomb::Far
