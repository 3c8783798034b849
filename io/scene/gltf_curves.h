#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "far/base/result.h"
#include "io/scene/gltf_document.h"
#include "io/scene/rig.h"

namespace honeycomb::Io {

/// What a channel of an animation moves.
enum class GltfPath { translation, rotation, scale, weights };

/// A channel that is not interpolated linearly, which Assimp doesn't tell from one that is.
struct GltfCurve {
  std::size_t animation = 0;
  std::string node;  ///< as Assimp calls it
  GltfPath path = GltfPath::translation;
  std::size_t width = 0;  ///< numbers a key
  Keys keys;              ///< rotations as w x y z
};

struct GltfCurves {
  std::vector<GltfCurve> curves;
  std::vector<std::string> notes;  ///< of channels whose numbers can't be read here: Assimp's stay
};

/// The step and cubic channels of a document that checkGltf has passed. Errors: invalidFile for a key that is not
/// finite, naming animation, node and key.
Result<GltfCurves> gltfCurves(const GltfDocument& document);

}  // namespace honeycomb::Io
