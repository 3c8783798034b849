#include "io/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "far/base/index.h"
#include "io/scene/clip_frames.h"
#include "io/scene/scene_data.h"
#include "io/scene/welded_mesh.h"

namespace honeycomb::Io {
namespace {

constexpr double kMostFrames = 1e7;

template <class Named>
std::string quotedNames(const std::vector<Named>& list) {
  std::string names;
  for (const Named& entry : list) names += fmt::format("{}'{}'", names.empty() ? "" : ", ", entry.name);
  return names;
}

std::vector<SceneClip> listClips(const SceneData& data) {
  std::vector<SceneClip> clips;
  for (const Clip& clip : data.clips) clips.push_back({clip.name, clip.seconds, clip.framesPerSecond, clip.keys});
  return clips;
}

std::vector<SceneNode> listNodes(const SceneData& data) {
  std::map<std::int32_t, SceneNode> nodes;
  for (const ScenePart& part : data.parts) {
    SceneNode& node = nodes[part.node];
    node.name = data.nodes[at(part.node)].name;
    node.vertices += part.endVertex - part.firstVertex;
    node.faces += std::ssize(part.faceOffsets) - 1;
    node.skinned = node.skinned || part.skinned;
    node.morphed =
        node.morphed || data.skin.morphOffsets[at(part.endVertex)] > data.skin.morphOffsets[at(part.firstVertex)];
  }
  std::vector<SceneNode> list;
  for (const auto& entry : nodes) list.push_back(entry.second);
  return list;
}

}  // namespace

struct Scene::State {
  std::string file;
  SceneData data;
  std::vector<SceneClip> clips;
  std::vector<SceneNode> nodes;

  /// Null: there is none, and none was asked for.
  Result<const Clip*> chooseClip(const std::string& name) const {
    if (name.empty()) return data.clips.empty() ? nullptr : &data.clips.front();
    for (const Clip& clip : data.clips)
      if (clip.name == name) return &clip;
    return fail(ErrorCode::invalidOption,
                data.clips.empty()
                    ? fmt::format("{}: has no clip '{}', and no other; it holds one pose", file, name)
                    : fmt::format("{}: has no clip '{}'; choose from: {}", file, name, quotedNames(clips)));
  }

  /// The parts on a node of that name or below one.
  Result<std::vector<const ScenePart*>> chooseParts(const std::string& name) const {
    std::vector<bool> chosen(data.nodes.size());
    for (std::size_t n = 0; n < chosen.size(); ++n) {
      const std::int32_t parent = data.nodes[n].parent;
      chosen[n] = name.empty() || data.nodes[n].name == name || (parent >= 0 && chosen[at(parent)]);
    }
    std::vector<const ScenePart*> parts;
    for (const ScenePart& part : data.parts)
      if (chosen[at(part.node)]) parts.push_back(&part);
    if (!parts.empty()) return parts;
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: has no node '{}' with a mesh on it or below; choose from: {}", file, name,
                            quotedNames(nodes)));
  }

  Result<double> chooseRate(const SceneRequest& request, const Clip& clip) const {
    const double usual = clip.framesPerSecond > 0 ? clip.framesPerSecond : kUsualFramesPerSecond;
    const double rate = request.framesPerSecond.value_or(usual);
    if (rate > 0 && rate <= kMostFrames && clip.seconds * rate < kMostFrames) return rate;
    return fail(
        ErrorCode::invalidOption,
        fmt::format("{}: {} frames a second of a clip of {} seconds: give a positive rate that makes no more than "
                    "{} frames",
                    file, rate, clip.seconds, kMostFrames));
  }
};

Scene::Scene(std::shared_ptr<const State> state) : state_(std::move(state)) {}
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

Result<Scene> Scene::open(const std::filesystem::path& path) {
  Result<SceneData> data = importScene(path);
  if (!data) return tl::unexpected(data.error());
  State state{path.string(), std::move(*data), {}, {}};
  state.clips = listClips(state.data);
  state.nodes = listNodes(state.data);
  return Scene(std::make_shared<const State>(std::move(state)));
}

const std::vector<SceneClip>& Scene::clips() const {
  return state_->clips;
}
const std::vector<SceneNode>& Scene::nodes() const {
  return state_->nodes;
}
const std::vector<std::string>& Scene::notes() const {
  return state_->data.notes;
}

const std::vector<std::filesystem::path>& Scene::files() const {
  return state_->data.files;
}

Result<SceneMesh> Scene::mesh(const SceneRequest& request) const {
  const Result<const Clip*> clip = state_->chooseClip(request.clip);
  if (!clip) return tl::unexpected(clip.error());
  const auto parts = state_->chooseParts(request.node);
  if (!parts) return tl::unexpected(parts.error());
  if (!(request.weld >= 0) || request.weld > 1)
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: vertices can't be joined within {} diagonals of the bounding "
                            "box; give 0 to 1",
                            state_->file, request.weld));
  WeldedMesh welded = weldParts(state_->data, *parts, request.weld);
  if (welded.mesh.polygons.faceCount() == 0)
    return fail(ErrorCode::invalidMesh, fmt::format("{}: no face is left; give a smaller tolerance", state_->file));
  SceneMesh result{std::move(welded.mesh), nullptr, std::move(welded.notes), welded.fileVertices};
  const Clip* posed = request.clip.empty() ? nullptr : *clip;
  result.mesh.positions = poseSkin(welded.skin, state_->data.nodes, posed, 0);
  if (!*clip) return result;
  const Result<double> rate = state_->chooseRate(request, **clip);
  if (!rate) return tl::unexpected(rate.error());
  // A frame that falls on the end in all but rounding is one.
  const auto frames = static_cast<std::int32_t>(std::floor((*clip)->seconds * *rate + 1e-6)) + 1;
  result.frames = std::make_shared<const ClipFrames>(state_->file, std::move(welded.skin), state_->data.nodes, **clip,
                                                     *rate, frames);
  return result;
}

}  // namespace honeycomb::Io
