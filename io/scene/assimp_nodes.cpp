#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "far/base/index.h"
#include "io/scene/assimp_import.h"

namespace honeycomb::Io {
namespace {

constexpr std::size_t kMostNodes = 1'000'000;
constexpr double kAssumedTicks = 25;    // a second, where the file doesn't say: Assimp's own convention
constexpr double kFastestFrames = 240;  // a second; above, ticks are a fine clock and no frame rate

/// Translation, rotation and scale of a node without shear.
Placement placementOf(const aiMatrix4x4& matrix) {
  aiVector3D scale, translation;
  aiQuaternion rotation;
  matrix.Decompose(scale, rotation, translation);
  return {vectorOf(translation), {rotation.w, rotation.x, rotation.y, rotation.z}, vectorOf(scale)};
}

template <class Key>
constexpr bool isRotation = std::is_same_v<Key, aiQuatKey>;

/// The keys of one kind of a track; `what` names them in messages.
template <class Key>
Result<Keys> convertKeys(const SceneConversion& conversion, const Key* keys, unsigned count, double ticks,
                         const std::string& what) {
  Keys converted;
  for (unsigned k = 0; k < count; ++k) {
    std::vector<double> value;
    if constexpr (isRotation<Key>) {
      const aiQuaternion& q = keys[k].mValue;
      const double length = std::sqrt(double{q.w} * q.w + double{q.x} * q.x + double{q.y} * q.y + double{q.z} * q.z);
      value = {q.w / length, q.x / length, q.y / length, q.z / length};
    } else {
      value = {keys[k].mValue.x, keys[k].mValue.y, keys[k].mValue.z};
    }
    const double time = keys[k].mTime / ticks;
    if (!std::isfinite(time) || !std::all_of(value.begin(), value.end(), [](double x) { return std::isfinite(x); }))
      return failScene(conversion, fmt::format("{}: key {} (counted from 0) is not a finite {}; correct or bake the "
                                               "animation anew",
                                               what, k, isRotation<Key> ? "rotation" : "number"));
    if (!converted.times.empty() && time < converted.times.back())
      return failScene(conversion, fmt::format("{}: key {} (counted from 0) comes before the one ahead of it; sort the "
                                               "keys",
                                               what, k));
    converted.times.push_back(time);
    converted.values.insert(converted.values.end(), value.begin(), value.end());
  }
  return converted;
}

Result<NodeTrack> convertTrack(const SceneConversion& conversion, const aiNodeAnim& channel, std::int32_t node,
                               double ticks, const std::string& clip) {
  const auto what = [&](const char* kind) {
    return fmt::format("clip '{}', node '{}', {}", clip, channel.mNodeName.C_Str(), kind);
  };
  NodeTrack track{node, {}, {}, {}};
  auto keys = convertKeys(conversion, channel.mPositionKeys, channel.mNumPositionKeys, ticks, what("translation"));
  if (!keys) return tl::unexpected(keys.error());
  track.translations = std::move(*keys);
  keys = convertKeys(conversion, channel.mRotationKeys, channel.mNumRotationKeys, ticks, what("rotation"));
  if (!keys) return tl::unexpected(keys.error());
  track.rotations = std::move(*keys);
  keys = convertKeys(conversion, channel.mScalingKeys, channel.mNumScalingKeys, ticks, what("scale"));
  if (!keys) return tl::unexpected(keys.error());
  track.scales = std::move(*keys);
  return track;
}

/// The nodes a morph channel means: named by the node, or (FBX) by the mesh and behind a star its number.
std::vector<std::int32_t> morphedNodes(const SceneConversion& conversion, const std::string& channel) {
  if (const auto node = conversion.nodeByName.find(channel); node != conversion.nodeByName.end()) return {node->second};
  const std::string mesh = channel.substr(0, channel.find('*'));
  std::vector<std::int32_t> nodes;
  for (const ScenePart& part : conversion.data.parts) {
    const bool meant = part.name == mesh || conversion.data.nodes[at(part.node)].name == mesh;
    if (meant && std::find(nodes.begin(), nodes.end(), part.node) == nodes.end()) nodes.push_back(part.node);
  }
  return nodes;
}

std::int32_t targetCount(const aiMeshMorphAnim& channel) {
  std::int64_t count = 0;
  for (unsigned k = 0; k < channel.mNumKeys; ++k) {
    const aiMeshMorphKey& key = channel.mKeys[k];
    for (unsigned i = 0; i < key.mNumValuesAndWeights; ++i) count = std::max(count, std::int64_t{key.mValues[i]} + 1);
  }
  return static_cast<std::int32_t>(std::min<std::int64_t>(count, kMostNodes));
}

Result<MorphTrack> convertMorph(const SceneConversion& conversion, const aiMeshMorphAnim& channel, double ticks,
                                const std::string& clip) {
  MorphTrack track;
  track.targets = targetCount(channel);
  for (unsigned k = 0; k < channel.mNumKeys; ++k) {
    const aiMeshMorphKey& key = channel.mKeys[k];
    std::vector<double> weights(at(track.targets), 0);
    for (unsigned i = 0; i < key.mNumValuesAndWeights; ++i)
      if (at(key.mValues[i]) < weights.size()) weights[at(key.mValues[i])] = key.mWeights[i];
    const double time = key.mTime / ticks;
    if (!std::isfinite(time) || !std::all_of(weights.begin(), weights.end(), [](double x) { return std::isfinite(x); }))
      return failScene(conversion,
                       fmt::format("clip '{}', morph weights of '{}': key {} (counted from 0) is not finite; "
                                   "correct or bake the animation anew",
                                   clip, channel.mName.C_Str(), k));
    if (!track.weights.empty() && time < track.weights.times.back())
      return failScene(conversion, fmt::format("clip '{}', morph weights of '{}': key {} (counted from 0) comes before "
                                               "the one ahead of it; sort the keys",
                                               clip, channel.mName.C_Str(), k));
    track.weights.times.push_back(time);
    track.weights.values.insert(track.weights.values.end(), weights.begin(), weights.end());
  }
  return track;
}

Result<void> convertTracks(SceneConversion& conversion, const aiAnimation& animation, double ticks, Clip& clip) {
  std::int64_t strangers = 0;
  for (unsigned c = 0; c < animation.mNumChannels; ++c) {
    const aiNodeAnim& channel = *animation.mChannels[c];
    const auto node = conversion.nodeByName.find(channel.mNodeName.C_Str());
    strangers += node == conversion.nodeByName.end() ? 1 : 0;
    if (node == conversion.nodeByName.end()) continue;
    Result<NodeTrack> track = convertTrack(conversion, channel, node->second, ticks, clip.name);
    if (!track) return tl::unexpected(track.error());
    clip.keys +=
        std::ssize(track->translations.times) + std::ssize(track->rotations.times) + std::ssize(track->scales.times);
    clip.tracks.push_back(std::move(*track));
  }
  for (unsigned c = 0; c < animation.mNumMorphMeshChannels; ++c) {
    const aiMeshMorphAnim& channel = *animation.mMorphMeshChannels[c];
    Result<MorphTrack> track = convertMorph(conversion, channel, ticks, clip.name);
    if (!track) return tl::unexpected(track.error());
    clip.keys += std::ssize(track->weights.times);
    for (const std::int32_t node : morphedNodes(conversion, channel.mName.C_Str())) {
      track->node = node;
      clip.morphs.push_back(*track);
    }
  }
  if (strangers > 0)
    conversion.data.notes.push_back(fmt::format("clip '{}' moves {} that the scene hasn't; left out", clip.name,
                                                strangers == 1 ? "a node" : fmt::format("{} nodes", strangers)));
  if (animation.mNumMeshChannels > 0)
    conversion.data.notes.push_back(
        fmt::format("clip '{}': animation by exchanging whole meshes is left out", clip.name));
  return {};
}

/// The track of a node, made where there is none.
template <class Track>
Track& trackOf(std::vector<Track>& tracks, std::int32_t node) {
  const auto found = std::find_if(tracks.begin(), tracks.end(), [node](const Track& t) { return t.node == node; });
  if (found != tracks.end()) return *found;
  tracks.push_back({});
  tracks.back().node = node;
  return tracks.back();
}

void takeCurve(const GltfCurve& curve, std::int32_t node, Clip& clip) {
  if (curve.path == GltfPath::weights) {
    MorphTrack& track = trackOf(clip.morphs, node);
    track.weights = curve.keys;
    track.targets = static_cast<std::int32_t>(curve.width);
    return;
  }
  NodeTrack& track = trackOf(clip.tracks, node);
  Keys& keys = curve.path == GltfPath::translation ? track.translations
               : curve.path == GltfPath::rotation  ? track.rotations
                                                   : track.scales;
  keys = curve.keys;
}

void takeCurves(const SceneConversion& conversion, std::size_t animation, Clip& clip) {
  for (const GltfCurve& curve : conversion.curves) {
    const auto node = conversion.nodeByName.find(curve.node);
    if (curve.animation == animation && node != conversion.nodeByName.end()) takeCurve(curve, node->second, clip);
  }
}

double lastKey(const Clip& clip) {
  double last = 0;
  const auto look = [&last](const Keys& keys) { last = keys.empty() ? last : std::max(last, keys.times.back()); };
  for (const NodeTrack& track : clip.tracks) look(track.translations), look(track.rotations), look(track.scales);
  for (const MorphTrack& track : clip.morphs) look(track.weights);
  return last;
}

}  // namespace

Result<void> convertNodes(SceneConversion& conversion) {
  struct Visit {
    const aiNode* node;
    std::int32_t parent;
  };
  std::int64_t twice = 0;
  std::vector<Visit> visits{{conversion.scene.mRootNode, -1}};
  // Breadth first, without recursion: a file may nest as deeply as it likes.
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const auto [node, parent] = visits[i];
    RigNode converted{node->mName.C_Str(), parent, transformOf(node->mTransformation),
                      placementOf(node->mTransformation)};
    if (!converted.local.isFinite())
      return failScene(conversion,
                       fmt::format("node '{}' has a transform that is not finite; correct it", converted.name));
    twice += conversion.nodeByName.emplace(converted.name, static_cast<std::int32_t>(i)).second ? 0 : 1;
    conversion.data.nodes.push_back(std::move(converted));
    for (unsigned c = 0; c < node->mNumChildren; ++c)
      visits.push_back({node->mChildren[c], static_cast<std::int32_t>(i)});
    if (visits.size() > kMostNodes) return failScene(conversion, "has more than a million nodes; simplify the scene");
  }
  if (twice > 0)
    conversion.data.notes.push_back(
        fmt::format("{} nodes have the name of another; animations and bones mean the first "
                    "of each name",
                    twice));
  return {};
}

Result<void> convertClips(SceneConversion& conversion) {
  for (unsigned a = 0; a < conversion.scene.mNumAnimations; ++a) {
    const aiAnimation& animation = *conversion.scene.mAnimations[a];
    const double ticks = animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : kAssumedTicks;
    Clip clip;
    clip.name = animation.mName.length > 0 ? animation.mName.C_Str() : fmt::format("clip {}", a + 1);
    clip.framesPerSecond = animation.mTicksPerSecond > 0 && ticks <= kFastestFrames ? ticks : 0;
    if (const auto tracks = convertTracks(conversion, animation, ticks, clip); !tracks) return tracks;
    takeCurves(conversion, a, clip);
    clip.seconds = lastKey(clip);
    if (clip.keys > 0) conversion.data.clips.push_back(std::move(clip));
  }
  return {};
}

}  // namespace honeycomb::Io
