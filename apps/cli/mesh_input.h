#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/read_options.h"
#include "far/base/result.h"
#include "far/topology/defects.h"
#include "far/topology/topology.h"
#include "io/frame_source.h"
#include "io/mesh.h"
#include "io/scene/scene.h"

namespace honeycomb::Cli {

/// A mesh as read from a file, perhaps without its isolated vertices, perhaps with its vertices in another order.
struct MeshInput {
  std::string file;  ///< as the user wrote it
  Io::Mesh mesh;
  std::int32_t fileVertices = 0;   ///< vertices in the file
  std::vector<std::int32_t> kept;  ///< 0-based number in the file of each vertex of `mesh`; empty: all are there
  std::shared_ptr<const Io::FrameSource> frames;  ///< the file's own animation, all fileVertices; null: one pose only
  std::optional<double> framesPerSecond;          ///< wanted of its animation; none: as it was made
  std::vector<std::filesystem::path> files;       ///< that the mesh and its frames are read from besides `file`
  std::int64_t isolated = 0;                      ///< vertices that were left out
  std::vector<std::string> notes;                 ///< what was left out or changed while reading, a sentence each
  std::vector<Io::SceneClip> clips;               ///< all of a scene's
  std::vector<Io::SceneNode> nodes;               ///< all of a scene's that have meshes

  std::int64_t dropped() const { return isolated; }
  std::int64_t fileVertex(std::int64_t v) const { return kept.empty() ? v : kept[static_cast<std::size_t>(v)]; }
};

/// Reads a mesh in any of the formats there are. Errors: those of the reader, naming file and line; invalidOption for
/// what the format hasn't.
Result<MeshInput> readMesh(const std::string& file, const ReadOptions& options);

/// What reading left out or changed, a line each for whoever watches.
void printNotes(const Session& session, const MeshInput& input);

/// A defect as the owner of the file sees it.
struct DefectReport {
  std::int64_t line = 0;    ///< 1-based; 0: the file has no lines
  std::int64_t face = 0;    ///< 1-based number of the f statement; 0: no face meant
  std::int64_t vertex = 0;  ///< 1-based number as in the file; 0: no vertex meant
  std::string what;         ///< in these numbers
  std::string remedy;
};
DefectReport report(const MeshInput& input, const Far::Defect& defect);

/// The connectivity, validated. Errors: invalidMesh, naming line, face and vertex of the first defect and how many
/// there are, and pointing to `honeycomb info`.
Result<Far::Topology> makeTopology(const MeshInput& input, Far::FaceOrder order = Far::FaceOrder::input);

/// Takes what the vertices have from those of `order`, one each: positions, colours, lines, and their numbers in the
/// file. The polygons stay as they are.
void gatherVertices(MeshInput& input, const std::vector<std::int32_t>& order);

/// Numbers the vertices anew: vertex k is the one that was order[k]. Vertices that are left out must be in no face.
void renumberVertices(MeshInput& input, const std::vector<std::int32_t>& order);

/// "FILE:LINE", or "FILE" where the line is 0.
std::string placeInFile(const MeshInput& input, std::int64_t line);
/// ", as in the file": whose numbers of faces and vertices messages have, where they count from 1.
std::string_view countedAs(const MeshInput& input);

/// The one line that stands for all the defects; `defects` isn't empty.
Error summarize(const MeshInput& input, const std::vector<Far::Defect>& defects);

/// The error with the file in front, unless it already names it.
Error inFile(const std::string& file, Error error);

/// The error with the file in front, and where it names a vertex or a face of the mesh, that element's line and its
/// number as in the file.
Error located(const MeshInput& input, const Error& error);

}  // namespace honeycomb::Cli
