#include "io/scene/welded_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include "far/base/index.h"
#include "io/scene/weld.h"

namespace honeycomb::Io {
namespace {

/// The length of the bounding box's diagonal.
double diagonal(const std::vector<double>& positions) {
  Vector3 low, high;
  low.fill(std::numeric_limits<double>::max());
  high.fill(std::numeric_limits<double>::lowest());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], positions[i]);
    high[i % 3] = std::max(high[i % 3], positions[i]);
  }
  return positions.empty() ? 0 : std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

class PartWelder {
 public:
  PartWelder(const SceneData& scene, const std::vector<const ScenePart*>& parts) : scene_(scene), parts_(parts) {
    textured_ = std::any_of(parts.begin(), parts.end(), [](const ScenePart* part) { return part->textured; });
    coloured_ = std::any_of(parts.begin(), parts.end(), [](const ScenePart* part) { return part->coloured; });
  }

  WeldedMesh run(double tolerance) {
    gather();
    weld_ = weldVertices(gathered_, tolerance * diagonal(gathered_.positions));
    keepRepresentatives();
    std::int64_t begin = 0;
    for (const ScenePart* part : parts_) {
      addFaces(*part, begin);
      begin += part->endVertex - part->firstVertex;
    }
    note();
    return std::move(result_);
  }

 private:
  void gather() {
    gathered_.joints = scene_.skin.joints;
    gathered_.targets = scene_.skin.targets;
    for (const ScenePart* part : parts_) {
      for (std::int64_t v = part->firstVertex; v < part->endVertex; ++v) {
        gathered_.append(scene_.skin, v);
        sources_.push_back(v);
      }
    }
  }

  void keepRepresentatives() {
    Mesh& mesh = result_.mesh;
    result_.skin.joints = gathered_.joints;
    result_.skin.targets = gathered_.targets;
    result_.fileVertices = gathered_.vertexCount();
    vertex_.resize(sources_.size());
    for (std::int64_t v = 0; v < gathered_.vertexCount(); ++v) {
      const std::int32_t first = weld_.representative[at(v)];
      if (first != v) {
        vertex_[at(v)] = vertex_[at(first)];
        recoloured_ += coloured_ && colourOf(v) != colourOf(first) ? 1 : 0;
        continue;
      }
      vertex_[at(v)] = mesh.polygons.vertexCount++;
      result_.skin.append(gathered_, v);
      if (!coloured_) continue;
      const Vector3 colour = colourOf(v);
      mesh.colours.insert(mesh.colours.end(), colour.begin(), colour.end());
    }
  }

  Vector3 colourOf(std::int64_t v) const {
    const std::size_t first = 3 * at(sources_[at(v)]);
    return {scene_.colours[first], scene_.colours[first + 1], scene_.colours[first + 2]};
  }

  /// The number of the texture coordinates that vertex v of the parts brings to its vertex of the mesh.
  std::int32_t texcoord(std::int64_t v) {
    const std::size_t source = 2 * at(sources_[at(v)]);
    const double s = scene_.texcoords[source], t = scene_.texcoords[source + 1];
    const auto next = static_cast<std::int32_t>(result_.mesh.texcoords.size() / 2);
    const auto [entry, fresh] = texcoords_.try_emplace({vertex_[at(v)], s, t}, next);
    if (fresh) result_.mesh.texcoords.insert(result_.mesh.texcoords.end(), {s, t});
    return entry->second;
  }

  /// `begin`: the part's first vertex among those of all parts.
  void addFaces(const ScenePart& part, std::int64_t begin) {
    std::vector<std::int64_t> corners;  // vertices of the parts
    for (std::size_t f = 0; f + 1 < part.faceOffsets.size(); ++f) {
      corners.clear();
      for (std::int64_t c = part.faceOffsets[f]; c < part.faceOffsets[f + 1]; ++c) {
        const std::int64_t v = part.indices[at(c)] - part.firstVertex + begin;
        if (corners.empty() || vertex_[at(corners.back())] != vertex_[at(v)]) corners.push_back(v);
      }
      while (corners.size() > 1 && vertex_[at(corners.front())] == vertex_[at(corners.back())]) corners.pop_back();
      collapsed_ += corners.size() < 3 ? 1 : 0;
      if (corners.size() >= 3) addFace(part, corners);
    }
  }

  void addFace(const ScenePart& part, const std::vector<std::int64_t>& corners) {
    Mesh& mesh = result_.mesh;
    for (const std::int64_t v : corners) {
      mesh.polygons.indices.push_back(vertex_[at(v)]);
      if (textured_) mesh.cornerTexcoords.push_back(part.textured ? texcoord(v) : -1);
    }
    mesh.polygons.faceOffsets.push_back(std::ssize(mesh.polygons.indices));
  }

  void note() {
    std::vector<std::string>& notes = result_.notes;
    const std::int64_t joined = result_.fileVertices - result_.mesh.polygons.vertexCount;
    if (joined > 0)
      notes.push_back(fmt::format("{} vertices of the file are {} after joining those that seams had split",
                                  result_.fileVertices, result_.mesh.polygons.vertexCount));
    if (weld_.disagreeing > 0)
      notes.push_back(
          fmt::format("{} vertices lie on another but move differently: they stay apart", weld_.disagreeing));
    if (collapsed_ > 0) notes.push_back(fmt::format("{} faces without area are left out", collapsed_));
    if (recoloured_ > 0)
      notes.push_back(fmt::format("{} joined vertices had another colour; the first of each is kept", recoloured_));
  }

  const SceneData& scene_;
  const std::vector<const ScenePart*>& parts_;
  bool textured_ = false;
  bool coloured_ = false;
  Skin gathered_;                      // of the parts alone
  std::vector<std::int64_t> sources_;  // the scene's vertex of each
  Weld weld_;
  std::vector<std::int32_t> vertex_;  // the mesh's vertex of each
  std::map<std::tuple<std::int32_t, double, double>, std::int32_t> texcoords_;
  std::int64_t collapsed_ = 0;
  std::int64_t recoloured_ = 0;
  WeldedMesh result_;
};

}  // namespace

WeldedMesh weldParts(const SceneData& scene, const std::vector<const ScenePart*>& parts, double tolerance) {
  return PartWelder(scene, parts).run(tolerance);
}

}  // namespace honeycomb::Io
