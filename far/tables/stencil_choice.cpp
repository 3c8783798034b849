#include "far/tables/stencil_choice.h"

#include <fmt/format.h>

#include <numeric>

#include "far/base/index.h"

namespace honeycomb::Far {

namespace {

Result<void> checkNumbers(const std::vector<std::int32_t>& numbers, std::int32_t count, std::int32_t level,
                          const char* what, const char* plural) {
  for (const std::int32_t number : numbers) {
    if (number >= 0 && number < count) continue;
    if (count == 0) {
      return fail(ErrorCode::invalidOption,
                  fmt::format("{} {} is not in level {}, which has no {}", what, number, level, plural), number);
    }
    return fail(ErrorCode::invalidOption,
                fmt::format("{} {} is not in level {}; choose from {} 0 to {}", what, number, level, plural, count - 1),
                number);
  }
  return {};
}

/// The vertices of faces, each once, in the order in which the loops come to them.
std::vector<std::int32_t> verticesOf(const Topology& level, const std::vector<std::int32_t>& faces) {
  std::vector<std::uint8_t> seen(at(level.vertexCount()), 0);
  std::vector<std::int32_t> vertices;
  for (const std::int32_t f : faces) {
    for (const std::int32_t h : level.halfEdgesOf(f)) {
      const std::int32_t v = level.vert(h);
      if (seen[at(v)]) continue;
      seen[at(v)] = 1;
      vertices.push_back(v);
    }
  }
  return vertices;
}

std::vector<std::int32_t> allOf(std::int32_t count) {
  std::vector<std::int32_t> numbers(at(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

}  // namespace

Result<std::vector<std::int32_t>> stencilOutputs(const Topology& level, std::int32_t levelNumber,
                                                 std::int32_t pointCount, const StencilOptions& options) {
  const StencilChoice& choice = options.choice;
  const bool ofFaces = options.kind == StencilKind::faceLimits;
  if (choice.of == StencilChoice::Of::all) {
    if (ofFaces) return allOf(level.faceCount());
    return allOf(options.kind == StencilKind::points ? pointCount : level.vertexCount());
  }
  if (choice.of == StencilChoice::Of::vertices) {
    if (ofFaces) return fail(ErrorCode::invalidOption, "face limits can't be chosen by vertices; choose faces");
    if (auto ok = checkNumbers(choice.numbers, level.vertexCount(), levelNumber, "vertex", "vertices"); !ok) {
      return tl::unexpected(ok.error());
    }
    return choice.numbers;
  }
  if (auto ok = checkNumbers(choice.numbers, level.faceCount(), levelNumber, "face", "faces"); !ok) {
    return tl::unexpected(ok.error());
  }
  if (ofFaces) return choice.numbers;
  return verticesOf(level, choice.numbers);
}

}  // namespace honeycomb::Far
