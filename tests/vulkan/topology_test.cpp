// Zip on the device: the same arrays as the CPU's.
#include "osd/vulkan/topology.h"

#include <gmock/gmock.h>

#include <cstring>
#include <functional>

#include "counting_callbacks.h"
#include "far/topology/splits/zip.h"
#include "fixture.h"
#include "osd/vulkan/commands.h"
#include "spy.h"
#include "tests/support/must.h"
#include "tests/support/random_mesh.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::VulkanTests {
namespace {

namespace Meshes = honeycomb::Test;
using Meshes::must;
using testing::HasSubstr;

using Numbers = std::vector<std::int32_t>;

/// Two vertices of n edges each, and n of four.
Meshes::PolyMesh bipyramid(std::size_t n) {
  Meshes::PolyMesh mesh;
  mesh.points.resize(n + 2);
  for (std::size_t i = 0; i < n; ++i) {
    mesh.faces.push_back({i, (i + 1) % n, n});
    mesh.faces.push_back({(i + 1) % n, i, n + 1});
  }
  return mesh;
}

/// A control mesh as a caller has it.
struct HalfEdges {
  Numbers faceOffsets, vert, twin;
  Osd::MeshCounts counts;

  explicit HalfEdges(const Far::Topology& mesh)
      : faceOffsets(mesh.faceOffsets().begin(), mesh.faceOffsets().end()),
        vert(mesh.vert().begin(), mesh.vert().end()),
        twin(mesh.twin().begin(), mesh.twin().end()),
        counts{mesh.vertexCount(), mesh.faceCount(), mesh.halfEdgeCount()} {}
};

/// A buffer that host and kernels see.
Osd::VulkanBuffer sharedBuffer(const Osd::VulkanEvaluator& evaluator, std::int32_t numbers, Osd::MemoryUse use) {
  constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  return must(Osd::VulkanBuffer::create(evaluator.core(), static_cast<std::uint64_t>(numbers) * 4, kUsage, use));
}

void write(const Osd::VulkanBuffer& buffer, const Numbers& numbers) {
  std::memcpy(buffer.bytes().data(), numbers.data(), numbers.size() * sizeof(std::int32_t));
}

/// A caller of VulkanTopology with buffers for control meshes of up to so many half-edges.
class Refiner {
 public:
  Refiner(Osd::VulkanEvaluator evaluator, const Osd::VulkanTopologyOptions& options)
      : evaluator_(std::move(evaluator)),
        offsets_(sharedBuffer(evaluator_, options.most.faces + 1, Osd::MemoryUse::upload)),
        vert_(sharedBuffer(evaluator_, options.most.halfEdges, Osd::MemoryUse::upload)),
        twin_(sharedBuffer(evaluator_, options.most.halfEdges, Osd::MemoryUse::upload)),
        back_(
            sharedBuffer(evaluator_, Osd::zipCounts(options.most, options.levels).halfEdges, Osd::MemoryUse::readback)),
        commands_(must(Osd::CommandRunner::create(evaluator_.core()))),
        topology(
            must(Osd::VulkanTopology::create(evaluator_, {offsets_.range(), vert_.range(), twin_.range()}, options))) {}

  /// Submits one frame and waits.
  Result<void> refine(const HalfEdges& mesh) {
    write(offsets_, mesh.faceOffsets);
    write(vert_, mesh.vert);
    write(twin_, mesh.twin);
    Result<void> recorded;
    auto ran = run([&](VkCommandBuffer commands) { recorded = topology.record(commands, mesh.counts); });
    if (!recorded) return recorded;
    return ran ? topology.check() : ran;
  }

  /// The first numbers of an array of the device's.
  Numbers read(const Osd::VulkanRange& range, std::int32_t count) {
    const VkBufferCopy copy{range.offset, 0, static_cast<std::uint64_t>(count) * 4};
    must(run([&](VkCommandBuffer commands) {
      const auto& core = *evaluator_.core();
      const Osd::MemoryAccess copies{VK_PIPELINE_STAGE_TRANSFER_BIT,
                                     VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT};
      memoryBarrier(core, commands, {VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT}, copies);
      core.vk().vkCmdCopyBuffer(commands, range.buffer, back_.handle(), 1, &copy);
      memoryBarrier(core, commands, copies, {VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT});
    }));
    Numbers numbers(static_cast<std::size_t>(count));
    std::memcpy(numbers.data(), back_.bytes().data(), copy.size);
    return numbers;
  }

 private:
  Result<void> run(const std::function<void(VkCommandBuffer)>& record) {
    if (auto begun = commands_.begin(VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT); !begun) return begun;
    record(commands_.commandBuffer());
    if (auto ended = commands_.end(); !ended) return ended;
    if (auto sent = commands_.submit(); !sent) return sent;
    return commands_.wait();
  }

  Osd::VulkanEvaluator evaluator_;
  Osd::VulkanBuffer offsets_, vert_, twin_, back_;
  Osd::CommandRunner commands_;

 public:
  Osd::VulkanTopology topology;
};

void expectSame(std::span<const std::int32_t> expected, const Numbers& actual, const char* what, std::int32_t level) {
  ASSERT_EQ(expected.size(), actual.size()) << what << " of level " << level;
  const auto [here, there] = std::mismatch(expected.begin(), expected.end(), actual.begin());
  if (here == expected.end()) return;
  ADD_FAILURE() << what << " of level " << level << ": number " << here - expected.begin() << " of " << expected.size()
                << " is " << *there << ", the CPU's is " << *here;
}

/// Refines on the device and compares every array of every level.
void compare(Refiner& refiner, const Meshes::PolyMesh& mesh) {
  Far::Topology level = Meshes::toTopology(mesh);
  const HalfEdges control(level);
  must(refiner.refine(control));
  for (std::int32_t k = 1; k <= refiner.topology.options().levels; ++k) {
    level = must(Far::zip(Far::BoundaryRule::brick).apply(level)).topology;
    const Osd::MeshCounts counts = Osd::zipCounts(control.counts, k);
    EXPECT_EQ(counts, (Osd::MeshCounts{level.vertexCount(), level.faceCount(), level.halfEdgeCount()}));
    const Osd::VulkanTopology& topology = refiner.topology;
    expectSame(level.vert(), refiner.read(topology.vert(k), counts.halfEdges), "vert", k);
    expectSame(level.outgoing(), refiner.read(topology.vert(k), counts.vertices), "outgoing", k);
    expectSame(level.parents(), refiner.read(topology.parents(k), counts.faces), "parents", k);
    if (topology.options().links) {
      expectSame(level.twin(), refiner.read(topology.twin(k), counts.halfEdges), "twin", k);
      expectSame(level.face(), refiner.read(topology.face(), counts.halfEdges), "face", k);
    }
    expectSame(level.faceOffsets(), refiner.read(topology.faceOffsets(), counts.faces + 1), "faceOffsets", k);
  }
}

constexpr Osd::VulkanTopologyOptions kRoom{.most = {700, 700, 2500}, .levels = 4, .maxValence = 300, .links = true};

class TopologyTest : public VulkanTest {
 protected:
  Refiner makeRefiner(const Osd::VulkanTopologyOptions& options = kRoom, const Osd::VulkanEvaluatorOptions& how = {}) {
    return {makeEvaluator(how), options};
  }
};

TEST_F(TopologyTest, EqualsTheCpusWhateverMeshEachFrameHas) {
  Refiner refiner = makeRefiner();
  for (const Meshes::PolyMesh& mesh : {Meshes::torus(12, 10), Meshes::tetrahedron(), Meshes::prism(300), bipyramid(300),
                                       Meshes::pillow(7), Meshes::dodecahedron()}) {
    SCOPED_TRACE(testing::Message() << mesh.faces.size() << " faces, the first of " << mesh.faces[0].size());
    compare(refiner, mesh);
  }
}

TEST_F(TopologyTest, EqualsTheCpusOnRandomPolygons) {
  for (std::uint64_t seed = 0; seed < 6; seed += 2) {
    const Meshes::PolyMesh mesh = Meshes::randomMesh(seed).mesh;
    SCOPED_TRACE(testing::Message() << "random mesh " << seed);
    const HalfEdges control(Meshes::toTopology(mesh));
    Refiner refiner = makeRefiner({.most = control.counts, .levels = 3, .maxValence = 4000});
    compare(refiner, mesh);
  }
}

TEST_F(TopologyTest, LevelsOfSeveralPagesInSmallDispatches) {
  const HalfEdges control(Meshes::toTopology(Meshes::torus(12, 10)));
  // Level 4 is written in 19 windows and reads level 2 in 3 pages.
  Refiner refiner = makeRefiner({.most = control.counts, .levels = 4, .maxValence = 20},
                                {.maxStorageBufferRange = 8192, .maxWorkgroupsInRow = 2});
  compare(refiner, Meshes::torus(12, 10));
  compare(refiner, Meshes::prism(60));
  // Twins are found by vert of levels 1 and 2, in 1 and 3 pages.
  Refiner linked = makeRefiner({.most = control.counts, .levels = 2, .links = true},
                               {.maxStorageBufferRange = 8192, .maxWorkgroupsInRow = 2});
  compare(linked, Meshes::torus(12, 10));
}

TEST_F(TopologyTest, InMemoryThatIsNotShared) {
  Refiner refiner = makeRefiner({.most = {100, 100, 400}, .levels = 2}, {.stageEverything = true});
  compare(refiner, Meshes::torus(5, 4));
}

TEST_F(TopologyTest, RecordingAllocatesNothingWhateverTheMesh) {
  const CountingCallbacks counting;
  Osd::VulkanDevice device = context->device();
  device.allocator = counting.callbacks();
  Spy spy(device);
  Refiner refiner(must(Osd::VulkanEvaluator::create(spy.device())), {.most = {200, 200, 600}, .levels = 3});
  must(refiner.refine(HalfEdges(Meshes::toTopology(Meshes::torus(5, 4)))));
  const std::int64_t alive = spy.alive();
  const int memory = spy.calls("vkAllocateMemory"), sets = spy.calls("vkUpdateDescriptorSets");
  const int submissions = spy.calls("vkQueueSubmit");
  const std::int64_t held = counting.live();
  for (const Meshes::PolyMesh& mesh : {Meshes::prism(40), bipyramid(30), Meshes::torus(5, 4)}) {
    must(refiner.refine(HalfEdges(Meshes::toTopology(mesh))));
  }
  EXPECT_EQ(spy.calls("vkQueueSubmit"), submissions + 3);
  EXPECT_EQ(spy.calls("vkAllocateMemory"), memory);
  EXPECT_EQ(spy.calls("vkUpdateDescriptorSets"), sets);
  EXPECT_EQ(spy.alive(), alive);
  EXPECT_EQ(counting.live(), held);
}

TEST_F(TopologyTest, AControlMeshThatIsNotWantedIsAnErrorThatSaysWhatToDo) {
  Refiner refiner = makeRefiner({.most = {100, 100, 400}, .levels = 3, .maxValence = 5});
  const HalfEdges sound(Meshes::toTopology(Meshes::torus(5, 4)));
  const auto refusal = [&](const std::function<void(HalfEdges&)>& spoil) {
    HalfEdges spoilt = sound;
    spoil(spoilt);
    const auto refined = refiner.refine(spoilt);
    return refined ? std::string("refined") : refined.error().message;
  };
  EXPECT_THAT(refusal([](HalfEdges& mesh) { mesh.twin[17] = -1; }),
              HasSubstr("half-edge 17 of the control mesh has no twin: the device refines closed meshes"));
  EXPECT_THAT(refusal([](HalfEdges& mesh) { mesh.twin[17] = mesh.twin[18]; }),
              HasSubstr("half-edge 17 of the control"));
  EXPECT_THAT(refusal([](HalfEdges& mesh) { mesh.twin[17] = 1 << 30; }), HasSubstr("match the half-edges anew"));
  EXPECT_THAT(refusal([](HalfEdges& mesh) { mesh.vert[0] = 20; }), HasSubstr("leaves a vertex there is none of"));
  EXPECT_THAT(refusal([](HalfEdges& mesh) { mesh.faceOffsets[3] = 9; }), HasSubstr("face offsets"));
  EXPECT_THAT(refusal([](HalfEdges& mesh) { mesh.faceOffsets[3] = 1 << 30; }), HasSubstr("face offsets"));
  EXPECT_THAT(refusal([](HalfEdges& mesh) { ++mesh.counts.vertices; }), HasSubstr("has no faces, or several fans"));
  EXPECT_THAT(refusal([](HalfEdges& mesh) { mesh = HalfEdges(Meshes::toTopology(bipyramid(6))); }),
              HasSubstr("of more edges than 5: raise VulkanTopologyOptions::maxValence"));
  EXPECT_THAT(refusal([](HalfEdges& mesh) { mesh.counts.halfEdges += 2000; }),
              HasSubstr("with more VulkanTopologyOptions::most"));
  EXPECT_THAT(refusal([](HalfEdges& mesh) { mesh.counts.faces = 40; }), HasSubstr("a closed mesh has"));
  EXPECT_EQ(refusal([](HalfEdges&) {}), "refined");
}

TEST_F(TopologyTest, TwoFansOfFacesAtOneVertexAreAnError) {
  Refiner refiner = makeRefiner({.most = {100, 100, 400}, .levels = 2});
  Meshes::PolyMesh two = Meshes::tetrahedron();
  for (const Meshes::Loop& face : Meshes::tetrahedron().faces) {
    two.faces.push_back({face[0] + 4, face[1] + 4, face[2] + 4});
  }
  two.points.resize(8);
  HalfEdges joined(Meshes::toTopology(two));
  for (std::int32_t& v : joined.vert) v = v > 4 ? v - 1 : v == 4 ? 0 : v;
  joined.counts.vertices = 7;
  const auto refined = refiner.refine(joined);
  ASSERT_FALSE(refined);
  EXPECT_EQ(refined.error().code, ErrorCode::invalidMesh);
  EXPECT_THAT(refined.error().message, HasSubstr("give each fan a vertex of its own"));
}

TEST_F(TopologyTest, WhatCantBeMadeIsRefused) {
  const auto evaluator = makeEvaluator({.maxStorageBufferRange = 8192});
  const Osd::VulkanBuffer buffer = sharedBuffer(evaluator, 400, Osd::MemoryUse::upload);
  const Osd::VulkanControlMesh mesh{buffer.range(), buffer.range(), buffer.range()};
  const auto refusal = [&](const Osd::VulkanControlMesh& control, const Osd::VulkanTopologyOptions& options) {
    const auto made = Osd::VulkanTopology::create(evaluator, control, options);
    return made ? std::string("made") : made.error().message;
  };
  const Osd::MeshCounts most{100, 100, 400};
  EXPECT_THAT(refusal(mesh, {.most = most, .levels = 0}), HasSubstr("both are 1 or more"));
  EXPECT_THAT(refusal(mesh, {.most = {100, 100, 200}}), HasSubstr("a closed mesh has"));
  EXPECT_THAT(refusal(mesh, {.most = most, .levels = 15}), HasSubstr("more than 2^31 - 1"));
  EXPECT_THAT(refusal(mesh, {.most = {700, 700, 2400}}), HasSubstr("binds 8192 at once: lower"));
  EXPECT_THAT(refusal(mesh, {.most = most, .levels = 6}), HasSubstr("level 4 has 129600 bytes"));
  EXPECT_THAT(refusal(mesh, {.most = {100, 100, 402}}), HasSubstr("the half-edges' vertices has 1600 bytes, 1608 are"));
  EXPECT_THAT(refusal({mesh.faceOffsets, mesh.vert, {}}, {.most = most}),
              HasSubstr("a buffer for the half-edges' twins"));
  const auto made = must(Osd::VulkanTopology::create(evaluator, mesh, {.most = most}));
  const auto early = made.check();
  ASSERT_FALSE(early);
  EXPECT_THAT(early.error().message, HasSubstr("record, submit and wait first"));
}

TEST_F(TopologyTest, EachCallThatFailsIsAnErrorAndLeavesNothingBehind) {
  const Osd::VulkanTopologyOptions options{.most = {20, 20, 80}};
  int calls = 0;
  for (const std::string& function : Spy::fallible()) {
    bool struck = true;
    for (int call = 1; struck; ++call) {
      Spy spy(context->device());
      {
        auto evaluator = must(Osd::VulkanEvaluator::create(spy.device()));
        const Osd::VulkanBuffer buffer = sharedBuffer(evaluator, 80, Osd::MemoryUse::upload);
        spy.fail(function, call, VK_ERROR_OUT_OF_DEVICE_MEMORY);
        const auto made =
            Osd::VulkanTopology::create(evaluator, {buffer.range(), buffer.range(), buffer.range()}, options);
        struck = spy.struck();
        // Where no whole block of memory is to be had, the buffer alone is asked for.
        const bool recovers = function == "vkAllocateMemory" || function == "vkMapMemory";
        EXPECT_TRUE(made.has_value() == !struck || recovers) << function << " " << call;
        EXPECT_EQ(made ? ErrorCode::outOfMemory : made.error().code, ErrorCode::outOfMemory) << function << " " << call;
      }
      EXPECT_EQ(spy.alive(), 0) << function << " " << call;
      calls += struck ? 1 : 0;
    }
  }
  EXPECT_GT(calls, 20) << "calls that can fail";
}

}  // namespace
}  // namespace honeycomb::VulkanTests
