#include "io/scene/gltf_check.h"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "far/base/index.h"
#include "io/scene/gltf_arrays.h"

namespace honeycomb::Io {
namespace {

using Json = nlohmann::json;

constexpr std::int64_t kMostElements = std::int64_t{1} << 31U;

class GltfChecker {
 public:
  explicit GltfChecker(const GltfDocument& document) : document_(document) {}

  Result<void> run() {
    checkViews();
    checkAccessors();
    checkMeshes();
    checkNodes();
    checkSkins();
    checkAnimations();
    if (wrong_.empty()) return {};
    return fail(ErrorCode::invalidFile, fmt::format("{}: {}; export it anew", document_.path().string(), wrong_));
  }

 private:
  static const Json& member(const Json& object, const char* key) { return GltfDocument::member(object, key); }
  const Json& list(const char* key) const { return document_.list(key); }
  static std::int64_t number(const Json& object, const char* key, std::int64_t otherwise) {
    const Json& value = member(object, key);
    return value.is_number_integer() ? value.get<std::int64_t>() : otherwise;
  }

  /// Remembers the first thing that is wrong.
  void expect(bool right, const std::string& what) {
    if (!right && wrong_.empty()) wrong_ = what;
  }
  bool isIn(const char* key, const Json& index) const {
    return index.is_number_integer() && index.get<std::int64_t>() >= 0 &&
           index.get<std::int64_t>() < std::ssize(list(key));
  }
  /// A member that may be missing, but names an element of the list `key` where it is there.
  void expectIndex(const Json& object, const char* memberName, const char* key, const std::string& where) {
    const Json& index = member(object, memberName);
    expect(index.is_null() || isIn(key, index), fmt::format("{}: its {} is not one of the {}", where, memberName, key));
  }

  void checkViews() {
    for (std::size_t i = 0; i < list("bufferViews").size(); ++i) {
      const Json& view = list("bufferViews")[i];
      const std::string where = fmt::format("bufferView {}", i);
      expect(isIn("buffers", member(view, "buffer")), where + ": its buffer is not one of the buffers");
      if (!wrong_.empty()) return;
      const std::int64_t whole = number(list("buffers")[at(number(view, "buffer", 0))], "byteLength", 0);
      const std::int64_t offset = number(view, "byteOffset", 0), length = number(view, "byteLength", 0);
      expect(offset >= 0 && length >= 0 && length <= whole && offset <= whole - length,
             where + ": reaches past its buffer");
    }
  }

  void checkAccessors() {
    for (std::size_t i = 0; i < list("accessors").size() && wrong_.empty(); ++i) {
      const Json& accessor = list("accessors")[i];
      const std::string where = fmt::format("accessor {}", i);
      const std::int64_t count = number(accessor, "count", 0);
      const std::int64_t size =
          gltfComponentBytes(number(accessor, "componentType", 0)) * gltfComponents(member(accessor, "type"));
      expect(size > 0 && count >= 0 && count < kMostElements, where + ": has no known type or no sensible count");
      expectIndex(accessor, "bufferView", "bufferViews", where);
      checkSparse(accessor, size, where);
      if (!wrong_.empty() || member(accessor, "bufferView").is_null() || count == 0) continue;
      const Json& view = list("bufferViews")[at(number(accessor, "bufferView", 0))];
      const std::int64_t stride = number(view, "byteStride", 0) > 0 ? number(view, "byteStride", 0) : size;
      const std::int64_t offset = number(accessor, "byteOffset", 0);
      const std::int64_t length = number(view, "byteLength", 0);
      expect(stride < 1 << 16 && offset >= 0 && offset <= length && (count - 1) * stride + size <= length - offset,
             where + ": reaches past its bufferView");
    }
  }

  /// The `bytes` that a part of a sparse accessor needs of its view.
  void checkSparsePart(const Json& part, std::int64_t bytes, const std::string& where) {
    expect(isIn("bufferViews", member(part, "bufferView")), where + ": its bufferView is not one of the bufferViews");
    if (!wrong_.empty()) return;
    const Json& view = list("bufferViews")[at(number(part, "bufferView", 0))];
    const std::int64_t offset = number(part, "byteOffset", 0);
    expect(offset >= 0 && bytes <= number(view, "byteLength", 0) - offset, where + ": reaches past its bufferView");
  }

  /// `size`: bytes of an element.
  void checkSparse(const Json& accessor, std::int64_t size, const std::string& where) {
    const Json& sparse = member(accessor, "sparse");
    if (!wrong_.empty() || sparse.is_null()) return;
    const std::int64_t count = number(sparse, "count", 0);
    const std::int64_t indexSize = gltfComponentBytes(number(member(sparse, "indices"), "componentType", 0));
    expect(count > 0 && count <= number(accessor, "count", 0) && indexSize > 0,
           where + ": its sparse part has no sensible count or type");
    checkSparsePart(member(sparse, "indices"), count * indexSize, where + ", sparse indices");
    checkSparsePart(member(sparse, "values"), count * size, where + ", sparse values");
  }

  std::int64_t countOf(const Json& index) const {
    return isIn("accessors", index) ? number(list("accessors")[at(index.get<std::int64_t>())], "count", 0) : -1;
  }

  void checkMeshes() {
    for (std::size_t i = 0; i < list("meshes").size(); ++i) {
      const Json& primitives = member(list("meshes")[i], "primitives");
      for (std::size_t p = 0; p < primitives.size() && primitives.is_array(); ++p)
        checkPrimitive(primitives[p], fmt::format("mesh {}, primitive {}", i, p));
    }
  }

  void checkPrimitive(const Json& primitive, const std::string& where) {
    expectIndex(primitive, "indices", "accessors", where);
    const std::int64_t vertices = countOf(member(member(primitive, "attributes"), "POSITION"));
    expect(vertices > 0, where + ": has no positions");
    checkAttributes(member(primitive, "attributes"), vertices, where);
    const Json& targets = member(primitive, "targets");
    for (std::size_t t = 0; t < targets.size() && targets.is_array(); ++t)
      checkAttributes(targets[t], vertices, fmt::format("{}, target {}", where, t));
  }

  void checkAttributes(const Json& attributes, std::int64_t vertices, const std::string& where) {
    if (!attributes.is_object()) return;
    for (const auto& attribute : attributes.items())
      expect(countOf(attribute.value()) == vertices,
             fmt::format("{}: {} has not as many elements as there are vertices", where, attribute.key()));
  }

  void checkNodes() {
    std::vector<int> parents(list("nodes").size(), 0);
    for (std::size_t i = 0; i < list("nodes").size(); ++i) {
      const Json& node = list("nodes")[i];
      const std::string where = fmt::format("node {}", i);
      expectIndex(node, "mesh", "meshes", where);
      expectIndex(node, "skin", "skins", where);
      const Json& children = member(node, "children");
      for (std::size_t c = 0; c < children.size() && children.is_array(); ++c) {
        expect(isIn("nodes", children[c]), where + ": a child is not one of the nodes");
        if (isIn("nodes", children[c]))
          expect(++parents[at(children[c].get<std::int64_t>())] == 1 && children[c] != i,
                 fmt::format("{}: its child {} has another parent", where, children[c].get<std::int64_t>()));
      }
    }
    for (const Json& scene : list("scenes")) {
      const Json& roots = member(scene, "nodes");
      for (std::size_t r = 0; r < roots.size() && roots.is_array(); ++r) {
        expect(isIn("nodes", roots[r]), "a scene names a node that is not there");
        // A tree below each root then: without, a circle of nodes would be walked for ever.
        if (isIn("nodes", roots[r]))
          expect(parents[at(roots[r].get<std::int64_t>())] == 0, "a scene names a node that hangs on another");
      }
    }
  }

  void checkSkins() {
    for (std::size_t i = 0; i < list("skins").size(); ++i) {
      const Json& skin = list("skins")[i];
      const Json& joints = member(skin, "joints");
      const std::string where = fmt::format("skin {}", i);
      expect(joints.is_array(), where + ": has no joints");
      for (std::size_t j = 0; j < joints.size() && joints.is_array(); ++j)
        expect(isIn("nodes", joints[j]), fmt::format("{}: joint {} is not one of the nodes", where, j));
      const Json& matrices = member(skin, "inverseBindMatrices");
      expect(countOf(matrices) >= std::ssize(joints),
             fmt::format("{}: has no inverseBindMatrices, or fewer than joints, which Assimp 5.2 can't read", where));
      if (isIn("accessors", matrices))
        expect(member(list("accessors")[at(matrices.get<std::int64_t>())], "type") == "MAT4",
               where + ": its inverseBindMatrices are no matrices");
    }
  }

  void checkAnimations() {
    for (std::size_t i = 0; i < list("animations").size(); ++i) {
      const Json& animation = list("animations")[i];
      const std::string where = fmt::format("animation {}", i);
      const Json& samplers = member(animation, "samplers");
      for (std::size_t s = 0; s < samplers.size() && samplers.is_array(); ++s) {
        const std::int64_t keys = countOf(member(samplers[s], "input"));
        const std::int64_t values = countOf(member(samplers[s], "output"));
        const bool cubic = member(samplers[s], "interpolation") == "CUBICSPLINE";
        expect(keys > 0 && values >= (cubic ? 3 : 1) * keys,
               fmt::format("{}: sampler {} has fewer values than keys, or none", where, s));
      }
      const Json& channels = member(animation, "channels");
      for (std::size_t c = 0; c < channels.size() && channels.is_array(); ++c) {
        const std::int64_t sampler = number(channels[c], "sampler", -1);
        expect(sampler >= 0 && sampler < std::ssize(samplers),
               fmt::format("{}: channel {} names no sampler", where, c));
        expectIndex(member(channels[c], "target"), "node", "nodes", fmt::format("{}, channel {}", where, c));
      }
    }
  }

  const GltfDocument& document_;
  std::string wrong_;
};

}  // namespace

Result<void> checkGltf(const GltfDocument& document) {
  return GltfChecker(document).run();
}

}  // namespace honeycomb::Io
