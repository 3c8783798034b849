#include "apps/cli/converted_primvars.h"

#include <algorithm>
#include <optional>

#include "far/base/index.h"
#include "far/tables/refinement.h"

namespace honeycomb::Cli {
namespace {

/// The values of the result's vertices, three a vertex.
Result<std::vector<double>> applyRows(const Far::Conversion& conversion, std::span<const double> values) {
  Result<std::vector<double>> converted = Far::apply(conversion, values, 3);
  if (converted || !conversion.correction) return converted;
  Far::Conversion uncorrected = conversion;
  uncorrected.correction = nullptr;
  return Far::apply(uncorrected, values, 3);
}

/// Texture coordinates of faces that lie in the faces they were made from. Walks the faces in order: those from one
/// source follow each other, and each source's corners are looked up once.
class CornerValues {
 public:
  CornerValues(const Io::Mesh& mesh, const Far::Conversion& conversion)
      : mesh_(mesh),
        conversion_(conversion),
        cornerAt_(at(conversion.sourceCount), -1),
        made_(at(conversion.polygons.vertexCount)),
        texcoords_(mesh.texcoords) {}

  /// Nothing where a face reaches beyond its source.
  std::optional<Primvars<double>> run() {
    const Far::Polygons& polygons = conversion_.polygons;
    std::vector<std::int32_t> corners(polygons.indices.size());
    for (std::size_t f = 0; f < conversion_.faceSources.size(); ++f) {
      const Far::FaceSource& source = conversion_.faceSources[f];
      if (source.kind != Far::FaceParent::face) return std::nullopt;
      enter(source.element);
      for (std::size_t c = at(polygons.faceOffsets[f]); c < at(polygons.faceOffsets[f + 1]); ++c) {
        const std::optional<std::int32_t> value = valueOf(polygons.indices[c]);
        if (!value) return std::nullopt;
        corners[c] = *value;
      }
    }
    return Primvars<double>{{}, std::move(texcoords_), std::move(corners)};
  }

 private:
  struct Made {
    std::int32_t face = -1;  ///< the source it was made for
    std::int32_t value = -1;
  };

  void enter(std::int32_t face) {
    if (face == face_) return;
    face_ = face;
    const std::vector<std::int64_t>& offsets = mesh_.polygons.faceOffsets;
    for (std::int64_t c = offsets[at(face)]; c < offsets[at(face) + 1]; ++c)
      cornerAt_[at(mesh_.polygons.indices[at(c)])] = c;
  }

  /// The corner that the source has at one of its mesh's vertices; -1: none. What other faces left there is passed
  /// over.
  std::int64_t cornerOf(std::int32_t v) const {
    const std::int64_t c = cornerAt_[at(v)];
    const std::vector<std::int64_t>& offsets = mesh_.polygons.faceOffsets;
    return c >= offsets[at(face_)] && c < offsets[at(face_) + 1] ? c : -1;
  }

  /// The texture coordinate of a vertex of the result in the source: -1 where the source has none.
  std::optional<std::int32_t> valueOf(std::int32_t vertex) {
    Made& made = made_[at(vertex)];
    if (made.face == face_) return made.value;
    const std::vector<std::int64_t>& offsets = conversion_.rows.offsets;
    const std::size_t begin = at(offsets[at(vertex)]), end = at(offsets[at(vertex) + 1]);
    double u = 0, v = 0;
    std::int32_t value = -1;
    for (std::size_t b = begin; b < end; ++b) {
      const std::int64_t corner = cornerOf(conversion_.rows.indices[b]);
      if (corner < 0) return std::nullopt;
      value = mesh_.cornerTexcoords[at(corner)];
      if (value < 0) break;
      u += conversion_.rows.weights[b] * mesh_.texcoords[2 * at(value)];
      v += conversion_.rows.weights[b] * mesh_.texcoords[2 * at(value) + 1];
    }
    if (value >= 0 && end - begin > 1) {
      value = static_cast<std::int32_t>(texcoords_.size() / 2);
      texcoords_.insert(texcoords_.end(), {u, v});
    }
    made = {face_, value};
    return value;
  }

  const Io::Mesh& mesh_;
  const Far::Conversion& conversion_;
  std::int32_t face_ = -1;
  std::vector<std::int64_t> cornerAt_;  // per vertex of the source mesh: the corner of the last face that has it
  std::vector<Made> made_;              // per vertex of the result
  std::vector<double> texcoords_;
};

Result<void> convertSeams(const MeshInput& input, const Far::Topology& control, const Far::Conversion& conversion,
                          ConvertedPrimvars& primvars) {
  if (conversion.step) {
    const Result<Far::Refinement> refinement = Far::refine(control, *conversion.step, 1);
    if (!refinement) return tl::unexpected(refinement.error());
    return refineFaceVarying(input.mesh, *refinement, primvars.values);
  }
  std::optional<Primvars<double>> values = CornerValues(input.mesh, conversion).run();
  primvars.texcoordsLeftOut = !values;
  if (!values) return {};
  primvars.values.texcoords = std::move(values->texcoords);
  primvars.values.cornerTexcoords = std::move(values->cornerTexcoords);
  return {};
}

Result<void> convertTexcoords(const MeshInput& input, const Far::Topology& control, const Far::Conversion& conversion,
                              ConvertedPrimvars& primvars) {
  if (input.mesh.cornerTexcoords.empty()) return {};
  const std::optional<std::vector<double>> ofVertices = texcoordsOfVertices(input.mesh);
  if (!ofVertices) return convertSeams(input, control, conversion, primvars);
  const Result<std::vector<double>> triples = applyRows(conversion, *ofVertices);
  if (!triples) return tl::unexpected(triples.error());
  for (std::size_t i = 0; i < triples->size(); i += 3) {
    primvars.values.texcoords.insert(primvars.values.texcoords.end(), {(*triples)[i], (*triples)[i + 1]});
  }
  primvars.values.cornerTexcoords = conversion.polygons.indices;
  return {};
}

}  // namespace

Result<ConvertedPrimvars> convertPrimvars(const MeshInput& input, const Far::Topology& control,
                                          const Far::Conversion& conversion) {
  ConvertedPrimvars primvars;
  if (!input.mesh.colours.empty()) {
    Result<std::vector<double>> colours = applyRows(conversion, input.mesh.colours);
    if (!colours) return tl::unexpected(colours.error());
    primvars.values.colours = std::move(*colours);
  }
  const Result<void> done = convertTexcoords(input, control, conversion, primvars);
  if (!done) return tl::unexpected(done.error());
  return primvars;
}

}  // namespace honeycomb::Cli
