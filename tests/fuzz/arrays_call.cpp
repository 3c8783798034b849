#include <array>
#include <cstring>
#include <numeric>

#include "far/base/index.h"
#include "tests/fuzz/arrays.h"

namespace honeycomb::Fuzz {
namespace {

constexpr std::array<const char*, 10> kSchemes = {
    nullptr,    "zhang-wang", "half-box",  "midpoint",         "trisect",
    "centroid", "doo-sabin",  "akleman:1", "loop:1,akleman:1", "catmull-clark:1,akleman:1"};
constexpr std::array<hc_option, 7> kOptions = {{{"boundary", "eq16"},
                                                {"boundary", "drop"},
                                                {"boundary", "clamped"},
                                                {"tension", "sqrt3"},
                                                {"tuned", "first"},
                                                {"ratio", "0.25"},
                                                {"boundary", "nowhere"}}};

/// What the API is told that isn't so, one bit each.
enum Lie : std::int8_t { kOffsetsInstead = 1, kManyVertices = 2, kOneIndexLess = 4, kLittleMemory = 8 };

/// Signed bytes, one after the other.
class Numbers {
 public:
  explicit Numbers(Bytes bytes) : rest_(bytes) {}

  std::int8_t next() {
    if (rest_.empty()) return 0;
    const auto number = static_cast<std::int8_t>(rest_.front());
    rest_ = rest_.subspan(1);
    return number;
  }
  std::vector<std::int32_t> next(std::size_t count) {
    std::vector<std::int32_t> numbers(count);
    for (std::int32_t& number : numbers) number = next();
    return numbers;
  }
  Bytes rest() const { return rest_; }

 private:
  Bytes rest_;
};

std::size_t sumOf(const std::vector<std::int32_t>& sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), std::size_t{0},
                         [](std::size_t sum, std::int32_t size) { return sum + at(std::max(size, 0)); });
}

std::vector<float> floatsOf(Bytes bytes) {
  std::vector<float> floats(bytes.size() / sizeof(float));
  if (!floats.empty()) std::memcpy(floats.data(), bytes.data(), floats.size() * sizeof(float));
  if (floats.empty()) floats.push_back(0.5F);
  return floats;
}

}  // namespace

ArrayCall::ArrayCall(Bytes bytes) {
  Numbers numbers(bytes);
  scheme = numbers.next();
  build = numbers.next();
  option = numbers.next();
  lies = numbers.next();
  vertexCount = (lies & kManyVertices) != 0 ? std::int32_t{numbers.next()} << 24 : numbers.next();
  const std::size_t faces = at(numbers.next() & 63);
  const std::size_t creaseCount = at(numbers.next() & 15);
  const std::size_t cornerCount = at(numbers.next() & 7);
  sizes = numbers.next(faces);
  indices = numbers.next(sumOf(sizes) - ((lies & kOneIndexLess) != 0 && sumOf(sizes) > 0 ? 1 : 0));
  for (std::size_t i = 0; i < creaseCount; ++i) {
    const std::vector<std::int32_t> crease = numbers.next(3);
    creases.push_back({crease[0], crease[1], crease[2] / 8.0});
  }
  corners = numbers.next(cornerCount);
  points = floatsOf(numbers.rest());
  if ((lies & kOffsetsInstead) == 0) return;
  offsets.assign(1, 0);
  for (const std::int32_t size : sizes) offsets.push_back(offsets.back() + size);
}

hc_polygons ArrayCall::polygons() const {
  hc_polygons polygons{};
  polygons.struct_size = sizeof(polygons);
  polygons.vertex_count = vertexCount;
  polygons.face_count = std::ssize(sizes);
  if (offsets.empty()) polygons.face_sizes = sizes.data();
  if (!offsets.empty()) polygons.face_offsets = offsets.data();
  polygons.face_vertices = indices.data();
  polygons.face_vertex_count = std::ssize(indices);
  polygons.creases = creases.data();
  polygons.crease_count = std::ssize(creases);
  polygons.corners = corners.data();
  polygons.corner_count = std::ssize(corners);
  return polygons;
}

hc_tables_options ArrayCall::options() const {
  const auto bits = static_cast<std::uint8_t>(build);
  hc_tables_options options{};
  options.struct_size = sizeof(options);
  options.scheme = kSchemes[static_cast<std::uint8_t>(scheme) % kSchemes.size()];
  options.levels = bits & 3;
  options.normals = bits >> 2 & 3;
  options.tiles = bits >> 4 & 1;
  options.limits = bits >> 5 & 1;
  options.central_points = bits >> 6 & 1;
  options.order = bits >> 7;
  const std::size_t which = static_cast<std::uint8_t>(option) % (kOptions.size() + 1);
  options.options = which < kOptions.size() ? &kOptions[which] : nullptr;
  options.option_count = which < kOptions.size() ? 1 : 0;
  options.memory_limit = (lies & kLittleMemory) != 0 ? 4096 : 0;
  return options;
}

}  // namespace honeycomb::Fuzz
