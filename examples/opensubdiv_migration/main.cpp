// For users of OpenSubdiv: a cube's control points moved and refined by both libraries, step beside step.
#include <honeycomb/far/schemes/akleman.h>
#include <honeycomb/far/tables/refinement.h>
#include <honeycomb/osd/cpu_evaluator.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/osd/bufferDescriptor.h>
#include <opensubdiv/osd/cpuEvaluator.h>

#include <array>
#include <cstdio>
#include <memory>
#include <vector>

namespace {

constexpr int kLevels = 3;
constexpr int kFrames = 4;

// The cage, as OpenSubdiv's descriptor and our polygons take it: sides of each face, and the loops.
const std::array kSides{4, 4, 4, 4, 4, 4};
const std::array kLoops{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};

/// The corners of a cube that grows by a tenth a frame.
std::vector<float> controlPoints(int frame) {
  const float size = 1 + 0.1F * static_cast<float>(frame);
  std::vector<float> points;
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis) points.push_back((corner >> axis & 1) != 0 ? size : -size);
  return points;
}

void print(const char* library, int frame, const std::vector<float>& points) {
  float most = 0;
  for (const float coordinate : points) most = coordinate > most ? coordinate : most;
  std::printf("%s frame %d: %zu vertices, up to %.5f\n", library, frame, points.size() / 3, most);
}

void playWithOpenSubdiv() {
  namespace Far = OpenSubdiv::Far;
  namespace Osd = OpenSubdiv::Osd;
  // The mesh.
  Far::TopologyDescriptor cage;
  cage.numVertices = 8;
  cage.numFaces = static_cast<int>(kSides.size());
  cage.numVertsPerFace = kSides.data();
  cage.vertIndicesPerFace = kLoops.data();
  // The scheme.
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  const Factory::Options scheme(OpenSubdiv::Sdc::SCHEME_CATMARK);
  const std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(cage, scheme));
  // The levels, and their tables.
  refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(kLevels));
  Far::StencilTableFactory::Options options;
  options.generateIntermediateLevels = false;
  const std::unique_ptr<const Far::StencilTable> table(Far::StencilTableFactory::Create(*refiner, options));
  // The index buffer: refiner->GetLevel(kLevels).GetFaceVertices(f) of every face.
  std::vector<float> refined(3 * static_cast<std::size_t>(table->GetNumStencils()));
  for (int frame = 0; frame < kFrames; ++frame) {
    const std::vector<float> control = controlPoints(frame);
    const Osd::BufferDescriptor xyz(0, 3, 3);
    Osd::CpuEvaluator::EvalStencils(control.data(), xyz, refined.data(), xyz, table->GetSizes().data(),
                                    table->GetOffsets().data(), table->GetControlIndices().data(),
                                    table->GetWeights().data(), 0, table->GetNumStencils());
    print("OpenSubdiv", frame, refined);
  }
}

bool playWithHoneycomb() {
  namespace Far = honeycomb::Far;
  namespace Osd = honeycomb::Osd;
  // The mesh. What isn't a manifold comes back as an error value that names the face.
  Far::Polygons cage;
  cage.vertexCount = 8;
  cage.indices.assign(kLoops.begin(), kLoops.end());
  for (const int sides : kSides) cage.faceOffsets.push_back(cage.faceOffsets.back() + sides);
  const auto topology = Far::Topology::create(cage);
  // The scheme.
  const auto scheme = Far::akleman();
  // The levels, and their tables.
  if (!topology || !scheme) return false;
  const auto refinement = Far::refine(*topology, *scheme, kLevels);
  if (!refinement) return false;
  // The index buffer: refinement->triangles(kLevels), lines(kLevels), or the polygons of its topology.
  const Far::Topology& finest = refinement->level(kLevels).topology;
  std::vector<float> refined(3 * static_cast<std::size_t>(finest.vertexCount()));
  Osd::TbbEvaluator evaluator;
  for (int frame = 0; frame < kFrames; ++frame) {
    const std::vector<float> control = controlPoints(frame);
    const Osd::BufferDescriptor xyz{.offset = 0, .length = 3, .stride = 3};
    if (!evaluator.evaluate<float>(*refinement, kLevels, {control, xyz}, {refined, xyz})) return false;
    print("Honeycomb", frame, refined);
  }
  return true;
}

}  // namespace

int main() {
  playWithOpenSubdiv();
  return playWithHoneycomb() ? 0 : 1;
}
