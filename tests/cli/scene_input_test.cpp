#include <nlohmann/json.hpp>

#include "io/pc2.h"
#include "tests/io/scene/characters.h"
#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

class SceneInputTest : public Workplace {
 protected:
  std::string in_ = file("character.gltf", Io::Test::Character::gltf());
};

TEST_F(SceneInputTest, InfoListsClipsNodesAndWhatWasJoined) {
  const auto info = nlohmann::json::parse(run({"info", in_, "--json"}).out);
  EXPECT_EQ(info["vertices"], 8);
  EXPECT_EQ(info["boundary_loops"], nlohmann::json::array());
  EXPECT_EQ(info["clips"][0]["name"], "bend");
  EXPECT_EQ(info["clips"][0]["seconds"], 2.0);
  EXPECT_EQ(info["nodes"][0]["name"], "body");
  EXPECT_THAT(info["notes"].dump(), HasSubstr("36 vertices of the file are 8 after joining"));
}

TEST_F(SceneInputTest, AClipIsBakedAtAnyRate) {
  for (const auto& [rate, frames] : {std::pair{"2", 5}, std::pair{"7.5", 16}}) {
    const Outcome outcome = run({"bake", in_, path("out.pc2"), "--clip", "bend", "--fps", rate, "--levels", "2"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto baked = Io::Pc2Reader::open(path("out.pc2"));
    ASSERT_TRUE(baked) << baked.error().message;
    EXPECT_EQ(baked->info().frameCount, frames);
  }
}

TEST_F(SceneInputTest, UnknownClipsListThoseThereAre) {
  EXPECT_REFUSED((std::vector<std::string>{"bake", in_, path("out.pc2"), "--clip", "walk"}),
                 HasSubstr("has no clip 'walk'; choose from: 'bend'"));
  EXPECT_REFUSED((std::vector<std::string>{"refine", in_, path("out.obj"), "--node", "leg"}),
                 HasSubstr("has no node 'leg' with a mesh on it or below; choose from: 'body'"));
}

}  // namespace
}  // namespace honeycomb::Test
