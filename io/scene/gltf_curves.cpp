#include "io/scene/gltf_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "far/base/index.h"
#include "io/scene/gltf_arrays.h"

namespace honeycomb::Io {
namespace {

using Json = nlohmann::json;

std::string textOf(const Json& object, const char* key) {
  const Json& value = GltfDocument::member(object, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

std::size_t indexOf(const Json& object, const char* key) {
  return GltfDocument::member(object, key).get<std::size_t>();
}

std::optional<GltfPath> pathNamed(const std::string& name) {
  constexpr std::array<std::pair<const char*, GltfPath>, 4> kPaths{{{"translation", GltfPath::translation},
                                                                    {"rotation", GltfPath::rotation},
                                                                    {"scale", GltfPath::scale},
                                                                    {"weights", GltfPath::weights}}};
  for (const auto& [text, path] : kPaths)
    if (name == text) return path;
  return std::nullopt;
}

Interpolation interpolationOf(const Json& sampler) {
  const std::string name = textOf(sampler, "interpolation");
  return name == "STEP" ? Interpolation::step : name == "CUBICSPLINE" ? Interpolation::cubic : Interpolation::linear;
}

/// glTF has x y z w.
void scalarFirst(std::vector<double>& quaternions) {
  for (std::size_t i = 0; i + 3 < quaternions.size(); i += 4)
    std::rotate(quaternions.begin() + std::ptrdiff_t(i), quaternions.begin() + std::ptrdiff_t(i + 3),
                quaternions.begin() + std::ptrdiff_t(i + 4));
}

class CurveReader {
 public:
  explicit CurveReader(const GltfDocument& document) : document_(document), arrays_(document) {}

  Result<GltfCurves> run() {
    for (std::size_t a = 0; a < document_.list("animations").size(); ++a)
      if (const auto read = addAnimation(a); !read) return tl::unexpected(read.error());
    return std::move(result_);
  }

 private:
  std::string clipName(std::size_t animation) const {
    const std::string name = textOf(document_.list("animations")[animation], "name");
    return name.empty() ? fmt::format("clip {}", animation + 1) : name;
  }
  /// Assimp names the nameless by their place.
  std::string nodeName(std::size_t node) const {
    const std::string name = textOf(document_.list("nodes")[node], "name");
    return name.empty() ? fmt::format("nodes[{}]", node) : name;
  }

  Result<void> addAnimation(std::size_t a) {
    const Json& animation = document_.list("animations")[a];
    const Json& channels = GltfDocument::member(animation, "channels");
    const Json& samplers = GltfDocument::member(animation, "samplers");
    if (!channels.is_array() || !samplers.is_array()) return {};
    std::int64_t unread = 0;
    for (const Json& channel : channels) {
      const Json& sampler = samplers[indexOf(channel, "sampler")];
      const Json& target = GltfDocument::member(channel, "target");
      const std::optional<GltfPath> path = pathNamed(textOf(target, "path"));
      const bool curved = interpolationOf(sampler) != Interpolation::linear;
      if (!curved || !path || GltfDocument::member(target, "node").is_null()) continue;
      const Result<bool> read = add({a, nodeName(indexOf(target, "node")), *path, 0, {}}, sampler);
      if (!read) return tl::unexpected(read.error());
      unread += *read ? 0 : 1;
    }
    if (unread > 0)
      result_.notes.push_back(fmt::format(
          "clip '{}': {} of its channels are step or cubic and can't be read as such; they are played as linear",
          clipName(a), unread));
    return {};
  }

  /// False where the arrays are none that can be read here.
  Result<bool> add(GltfCurve curve, const Json& sampler) {
    auto times = arrays_.numbers(indexOf(sampler, "input")), values = arrays_.numbers(indexOf(sampler, "output"));
    if (!times || !values) return false;
    Keys& keys = curve.keys;
    keys = {std::move(*times), std::move(*values), interpolationOf(sampler)};
    const std::size_t parts = keys.times.size() * (keys.interpolation == Interpolation::cubic ? 3 : 1);
    curve.width = keys.values.size() / parts;
    const std::size_t usual = curve.path == GltfPath::rotation ? 4 : 3;
    const bool sized = curve.path == GltfPath::weights ? curve.width > 0 : curve.width == usual;
    if (!sized || keys.values.size() != parts * curve.width) return false;
    if (const auto sound = checkKeys(curve); !sound) return tl::unexpected(sound.error());
    if (curve.path == GltfPath::rotation) scalarFirst(keys.values);
    result_.curves.push_back(std::move(curve));
    return true;
  }

  Result<void> checkKeys(const GltfCurve& curve) const {
    const Keys& keys = curve.keys;
    const std::size_t numbers = keys.values.size() / keys.times.size();  // a key
    for (std::size_t k = 0; k < keys.times.size(); ++k) {
      const auto first = keys.values.begin() + static_cast<std::ptrdiff_t>(k * numbers);
      const bool finite =
          std::isfinite(keys.times[k]) && std::all_of(first, first + static_cast<std::ptrdiff_t>(numbers),
                                                      [](double number) { return std::isfinite(number); });
      const bool rising = k == 0 || keys.times[k] >= keys.times[k - 1];
      if (!finite || !rising)
        return fail(ErrorCode::invalidFile,
                    fmt::format("{}: clip '{}', node '{}': key {} (counted from 0) {}; correct or bake the animation "
                                "anew",
                                document_.path().string(), clipName(curve.animation), curve.node, k,
                                finite ? "comes before the one ahead of it" : "is not finite"));
    }
    return {};
  }

  const GltfDocument& document_;
  GltfArrays arrays_;
  GltfCurves result_;
};

}  // namespace

Result<GltfCurves> gltfCurves(const GltfDocument& document) {
  return CurveReader(document).run();
}

}  // namespace honeycomb::Io
