#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "far/base/index.h"
#include "io/scene/assimp_import.h"

namespace honeycomb::Io {
namespace {

constexpr std::int64_t kMostCorners = std::numeric_limits<std::int32_t>::max();

bool isFinite(const aiVector3D& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// One mesh on one node.
class PartConverter {
 public:
  PartConverter(SceneConversion& conversion, const aiMesh& mesh, std::int32_t node)
      : conversion_(conversion), data_(conversion.data), mesh_(mesh), node_(node) {}

  Result<void> convert() {
    part_.name = mesh_.mName.C_Str();
    part_.node = node_;
    part_.firstVertex = data_.skin.vertexCount();
    return addFaces()
        .and_then([this] { return addPositions(); })
        .and_then([this] { return addInfluences(); })
        .and_then([this] { return addMorphs(); })
        .and_then([this] { return addPrimvars(); })
        .map([this] { data_.parts.push_back(std::move(part_)); });
  }

 private:
  std::string name() const { return fmt::format("mesh '{}'", mesh_.mName.C_Str()); }

  Result<void> addFaces() {
    std::int64_t others = 0;
    for (unsigned f = 0; f < mesh_.mNumFaces; ++f) {
      const aiFace& face = mesh_.mFaces[f];
      for (unsigned k = 0; k < face.mNumIndices; ++k)
        if (face.mIndices[k] >= mesh_.mNumVertices)
          return failScene(conversion_,
                           fmt::format("{}: face {} (counted from 0) names vertex {} of {}; export it anew", name(), f,
                                       face.mIndices[k], mesh_.mNumVertices));
      others += face.mNumIndices < 3 ? 1 : 0;
      if (face.mNumIndices < 3) continue;
      for (unsigned k = 0; k < face.mNumIndices; ++k)
        part_.indices.push_back(static_cast<std::int32_t>(part_.firstVertex + face.mIndices[k]));
      part_.faceOffsets.push_back(std::ssize(part_.indices));
    }
    if (others > 0) data_.notes.push_back(fmt::format("{}: {} points and lines are left out", name(), others));
    return {};
  }

  Result<void> addPositions() {
    part_.endVertex = part_.firstVertex + mesh_.mNumVertices;
    if (part_.endVertex > kMostCorners || std::ssize(part_.indices) > kMostCorners)
      return fail(ErrorCode::tooLarge,
                  fmt::format("{}: more than 2^31 vertices or corners; split the scene", conversion_.file));
    for (unsigned v = 0; v < mesh_.mNumVertices; ++v) {
      if (!isFinite(mesh_.mVertices[v]))
        return fail(ErrorCode::invalidPositions,
                    fmt::format("{}: {}: vertex {} (counted from 0) is not finite; give it a finite position",
                                conversion_.file, name(), v));
      const Vector3 point = vectorOf(mesh_.mVertices[v]);
      data_.skin.positions.insert(data_.skin.positions.end(), point.begin(), point.end());
    }
    return {};
  }

  /// The place of a value in a list, to which it is appended where it isn't there.
  template <class T>
  static std::int32_t numberIn(std::vector<T>& list, const T& value) {
    const auto place = std::find(list.begin(), list.end(), value) - list.begin();
    if (place == std::ssize(list)) list.push_back(value);
    return static_cast<std::int32_t>(place);
  }

  Result<void> addBone(const aiBone& bone, std::vector<std::vector<Influence>>& influences) {
    const auto node = conversion_.nodeByName.find(bone.mName.C_Str());
    if (node == conversion_.nodeByName.end())
      return failScene(conversion_, fmt::format("{}: its skin names the bone '{}', which no node is called; export the "
                                                "skeleton with the mesh and give its joints names",
                                                name(), bone.mName.C_Str()));
    const Transform offset = transformOf(bone.mOffsetMatrix);
    if (!offset.isFinite())
      return failScene(conversion_, fmt::format("{}: bone '{}' has a bind pose that is not finite; bind the skin anew",
                                                name(), bone.mName.C_Str()));
    const std::int32_t joint = numberIn(data_.skin.joints, {node->second, offset});
    for (unsigned w = 0; w < bone.mNumWeights; ++w) {
      const aiVertexWeight& weight = bone.mWeights[w];
      if (weight.mVertexId >= mesh_.mNumVertices || !std::isfinite(weight.mWeight))
        return failScene(conversion_,
                         fmt::format("{}: bone '{}' gives vertex {} of {} the weight {}; bind the skin anew", name(),
                                     bone.mName.C_Str(), weight.mVertexId, mesh_.mNumVertices, weight.mWeight));
      if (weight.mWeight != 0) influences[weight.mVertexId].push_back({joint, weight.mWeight});
    }
    return {};
  }

  /// By rising joint, each joint once, with sum 1. Without any: moved with the mesh's node.
  void normalise(std::vector<Influence>& row, std::int32_t rigid) {
    std::stable_sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.joint < b.joint; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (kept > 0 && row[kept - 1].joint == row[i].joint) {
        row[kept - 1].weight += row[i].weight;
      } else {
        row[kept++] = row[i];
      }
    }
    row.resize(kept);
    double sum = 0;
    for (const Influence& influence : row) sum += influence.weight;
    if (!(sum > 0)) row.assign(1, {rigid, 1.0}), sum = 1;
    for (Influence& influence : row) influence.weight /= sum;
  }

  Result<void> addInfluences() {
    std::vector<std::vector<Influence>> influences(mesh_.mNumVertices);
    for (unsigned b = 0; b < mesh_.mNumBones; ++b)
      if (const auto added = addBone(*mesh_.mBones[b], influences); !added) return added;
    part_.skinned = mesh_.mNumBones > 0;
    const std::int32_t rigid = numberIn(data_.skin.joints, {node_, {}});
    Skin& skin = data_.skin;
    for (std::vector<Influence>& row : influences) {
      normalise(row, rigid);
      skin.influences.insert(skin.influences.end(), row.begin(), row.end());
      skin.influenceOffsets.push_back(std::ssize(skin.influences));
    }
    return {};
  }

  /// What target t adds to vertex v. Assimp gives shapes, whatever the method: relative and normalized weights mean the
  /// same then, p + sum_m w_m (shape_m - p) = (1 - sum_m w_m) p + sum_m w_m shape_m.
  Vector3 morphOffset(const aiAnimMesh& target, unsigned v) const {
    const bool isOffset = conversion_.targetsAreOffsets && mesh_.mMethod == aiMorphingMethod_MORPH_RELATIVE;
    const Vector3 shape = vectorOf(target.mVertices[v]), base = vectorOf(mesh_.mVertices[v]);
    return isOffset ? shape : Vector3{shape[0] - base[0], shape[1] - base[1], shape[2] - base[2]};
  }

  Result<void> addMorphs() {
    std::vector<std::int32_t> targets;
    for (unsigned t = 0; t < mesh_.mNumAnimMeshes; ++t) {
      const aiAnimMesh& target = *mesh_.mAnimMeshes[t];
      if (!std::isfinite(target.mWeight))
        return failScene(conversion_, fmt::format("{}: the weight of morph target {} is not finite", name(), t));
      targets.push_back(numberIn(data_.skin.targets, {node_, static_cast<std::int32_t>(t), target.mWeight}));
    }
    Skin& skin = data_.skin;
    for (unsigned v = 0; v < mesh_.mNumVertices; ++v) {
      for (unsigned t = 0; t < mesh_.mNumAnimMeshes; ++t) {
        const aiAnimMesh& target = *mesh_.mAnimMeshes[t];
        if (!target.mVertices || v >= target.mNumVertices) continue;
        if (!isFinite(target.mVertices[v]))
          return failScene(
              conversion_,
              fmt::format("{}: morph target {}: vertex {} is not finite (both counted from 0)", name(), t, v));
        const Vector3 offset = morphOffset(target, v);
        if (offset != Vector3{}) skin.morphs.push_back({targets[t], offset});
      }
      skin.morphOffsets.push_back(std::ssize(skin.morphs));
    }
    return {};
  }

  Result<void> addPrimvars() {
    const aiVector3D* texcoords = mesh_.mTextureCoords[0];
    const aiColor4D* colours = mesh_.mColors[0];
    part_.textured = texcoords != nullptr;
    part_.coloured = colours != nullptr;
    for (unsigned v = 0; v < mesh_.mNumVertices; ++v) {
      const aiVector3D uv = texcoords ? texcoords[v] : aiVector3D();
      const aiColor4D colour = colours ? colours[v] : aiColor4D(1, 1, 1, 1);
      for (const float x : {uv.x, uv.y, colour.r, colour.g, colour.b})
        if (!std::isfinite(x))
          return failScene(conversion_, fmt::format("{}: vertex {} (counted from 0) has a texture coordinate or colour "
                                                    "that is not finite; correct it",
                                                    name(), v));
      data_.texcoords.insert(data_.texcoords.end(), {uv.x, uv.y});
      data_.colours.insert(data_.colours.end(), {colour.r, colour.g, colour.b});
    }
    if (mesh_.GetNumUVChannels() > 1 || mesh_.GetNumColorChannels() > 1)
      data_.notes.push_back(
          fmt::format("{}: the first set of texture coordinates and of colours is read; others are "
                      "left out",
                      name()));
    return {};
  }

  SceneConversion& conversion_;
  SceneData& data_;
  const aiMesh& mesh_;
  std::int32_t node_;
  ScenePart part_;
};

}  // namespace

Result<void> convertMeshes(SceneConversion& conversion) {
  // Nodes in the order of convertNodes.
  std::vector<const aiNode*> nodes{conversion.scene.mRootNode};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes.insert(nodes.end(), nodes[i]->mChildren, nodes[i]->mChildren + nodes[i]->mNumChildren);
    for (unsigned m = 0; m < nodes[i]->mNumMeshes; ++m) {
      const unsigned mesh = nodes[i]->mMeshes[m];
      if (mesh >= conversion.scene.mNumMeshes)
        return failScene(conversion, fmt::format("node '{}' names mesh {} of {}; export the file anew",
                                                 nodes[i]->mName.C_Str(), mesh, conversion.scene.mNumMeshes));
      PartConverter part(conversion, *conversion.scene.mMeshes[mesh], static_cast<std::int32_t>(i));
      if (const auto converted = part.convert(); !converted) return converted;
    }
  }
  return {};
}

}  // namespace honeycomb::Io
