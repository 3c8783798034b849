#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "far/base/result.h"
#include "io/frame_source.h"
#include "io/mesh.h"

namespace honeycomb::Io {

/// Is this the name of a scene: glTF, FBX, COLLADA, BVH and others, by the extension?
bool isSceneFile(const std::filesystem::path& path);
/// ".gltf, .glb, ..": the extensions of scenes.
std::string sceneFormatNames();

/// An animation in a scene.
struct SceneClip {
  std::string name;
  double seconds = 0;
  double framesPerSecond = 0;  ///< as it was made; 0: the file doesn't say
  std::int64_t keys = 0;       ///< of all nodes and morph weights
};

/// A node that meshes hang on.
struct SceneNode {
  std::string name;
  std::int64_t vertices = 0;  ///< before any are joined
  std::int64_t faces = 0;
  bool skinned = false;
  bool morphed = false;
};

/// What of a scene is wanted, and how.
struct SceneRequest {
  std::string clip;                       ///< empty: the first, if there is any
  std::string node;                       ///< this node and those below it; empty: all
  std::optional<double> framesPerSecond;  ///< at which the clip is sampled; none: the clip's own, else 24
  double weld = 1e-6;                     ///< in diagonals of the bounding box; 0: the same place exactly
};

/// One mesh out of a scene, its split vertices joined again.
struct SceneMesh {
  /// Positions are those of the clip's first frame where a clip was named, else as the nodes stand.
  Mesh mesh;
  /// Frames 0 .. floor(seconds x rate) of the clip, from time 0, all in the space of the scene; null: no clip.
  std::shared_ptr<const FrameSource> frames;
  std::vector<std::string> notes;  ///< what was joined or left out, a sentence each
  std::int64_t fileVertices = 0;   ///< before any were joined
};

/// A file that holds meshes on nodes and animations of them, as Assimp reads it. Immutable; shared freely.
class Scene {
 public:
  /// Reads and checks all of it. Errors: unreadable; unsupported, where the library was built without Assimp; tooLarge
  /// past 2^30 bytes; invalidFile when it isn't what its name says, has no mesh, can't be understood, or holds a bone
  /// that no node is called, indices out of range, numbers that are not finite (naming clip, node and key);
  /// invalidPositions.
  static Result<Scene> open(const std::filesystem::path& path);
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  ~Scene();

  const std::vector<SceneClip>& clips() const;
  const std::vector<SceneNode>& nodes() const;
  /// What is in the file and left out.
  const std::vector<std::string>& notes() const;
  /// The files it is read from besides its own: glTF's buffers.
  const std::vector<std::filesystem::path>& files() const;

  /// Errors: invalidOption for a clip or node that isn't there, listing those that are, and for a rate or tolerance out
  /// of range; invalidMesh where no face is left. n log n in vertices.
  Result<SceneMesh> mesh(const SceneRequest& request) const;

 private:
  struct State;
  explicit Scene(std::shared_ptr<const State> state);
  std::shared_ptr<const State> state_;
};

}  // namespace honeycomb::Io
