#include <nlohmann/json.hpp>

#include "tests/io/scene/gltf_builder.h"
#include "workplace.h"

namespace honeycomb::Test {
namespace {

/// An unfinished bake whose input changes before it goes on: the files that its input names count, too.
class BakeInputsTest : public Workplace {
 protected:
  static constexpr int kFrames = 200;
  static constexpr long kRoom = 100'000;  // bytes of a frame or some hundred of them, but not of all

  /// Bakes until the disk is full, as it were: that leaves some frames whole.
  void stopHalfWay(const std::string& in) const {
    const Outcome outcome = run(bake(in), {{}, kRoom});
    ASSERT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, testing::HasSubstr("the same command goes on"));
  }
  int framesResumed(const std::string& in) const {
    const Outcome outcome = run(bake(in));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    std::filesystem::remove(path("out.pc2"));
    return nlohmann::json::parse(outcome.out).at("frames_resumed");
  }
  std::vector<std::string> bake(const std::string& in) const {
    return {"bake", in, path("out.pc2"), "--levels", "3", "--json", "--threads", "1"};
  }
  /// The file with another last byte, and nothing else changed.
  void changeEnd(const std::string& name) const {
    std::string bytes = read(name);
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    (void)file(name, bytes);
  }
};

/// A tetrahedron that moves, its numbers in a file beside.
std::string movingTetrahedron(Io::Test::GltfBuilder& file, int frames) {
  const auto text = [](int number) { return std::to_string(number); };
  const std::string points = text(file.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3", 3));
  const std::string indices =
      text(file.add(std::vector<std::uint16_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, "SCALAR", 1));
  const std::string times = text(file.floats({0, static_cast<float>(frames - 1) / 24}, "SCALAR", 1));
  const std::string places = text(file.floats({0, 0, 0, 5, 4, 3}, "VEC3", 3));
  return R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":)" +
         points + R"(},"indices":)" + indices +
         R"(}]}],"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],"samplers":[)" +
         R"({"input":)" + times + R"(,"output":)" + places + "}]}]";
}

TEST_F(BakeInputsTest, BuffersBesideAGltfFileArePartOfIt) {
  Io::Test::GltfBuilder builder;
  const std::string rest = movingTetrahedron(builder, kFrames);
  const std::string in = file("moving.gltf", builder.fileBeside("its%20numbers.bin", rest));
  (void)file("its numbers.bin", builder.bytes());
  (void)file("its%20numbers.bin", builder.bytes());  // Assimp 5.2 takes the name as it stands
  stopHalfWay(in);
  EXPECT_GT(framesResumed(in), 1);
  stopHalfWay(in);
  changeEnd("its numbers.bin");
  EXPECT_EQ(framesResumed(in), 0);
}

TEST_F(BakeInputsTest, EveryFileOfASequenceIsPartOfIt) {
  const std::string obj = torusObj(4);
  for (int f = 10; f < 40; ++f) (void)file("f" + std::to_string(f) + ".obj", withPositions(obj, bentFrame(obj, f)));
  stopHalfWay(path("f%d.obj"));
  EXPECT_GT(framesResumed(path("f%d.obj")), 1);
  stopHalfWay(path("f%d.obj"));
  (void)file("f35.obj", withPositions(obj, bentFrame(obj, 7)));
  EXPECT_EQ(framesResumed(path("f%d.obj")), 0);
}

}  // namespace
}  // namespace honeycomb::Test
