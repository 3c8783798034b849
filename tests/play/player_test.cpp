#include "apps/cli/play/player.h"

#include <condition_variable>
#include <mutex>
#include <thread>

#include "apps/cli/play/key_commands.h"
#include "apps/cli/play/live_options.h"
#include "tests/cli/workplace.h"

namespace honeycomb::Test {
namespace {

using namespace Cli::Play;
using testing::HasSubstr;

/// Lets builds through one by one.
class Gate {
 public:
  void open() {
    const std::lock_guard lock(mutex_);
    ++passes_;
    changed_.notify_all();
  }
  void pass() {
    std::unique_lock lock(mutex_);
    ++waiting_;
    changed_.wait(lock, [this] { return passes_ > 0; });
    --passes_;
  }
  int arrived() {
    const std::lock_guard lock(mutex_);
    return waiting_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int passes_ = 0;
  int waiting_ = 0;
};

class PlayerTest : public Workplace {
 protected:
  PlayerTest() { request.surface.input = file("cube.obj", cubeObj()); }

  std::unique_ptr<Player> playing(BackgroundBuild::Build build = PlaySurface::build) const {
    return std::make_unique<Player>(request, Appearance{}, BackendChoice::parse("tbb").value(), std::move(build));
  }
  /// Time passes until nothing is being built; the number of surfaces that came.
  static int settle(Player& player) {
    int surfaces = 0;
    while (player.building()) {
      surfaces += player.update(0, 1.6F) ? 1 : 0;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return surfaces;
  }

  SurfaceRequest request;
};

TEST_F(PlayerTest, ShowsTheSurfaceOnceItIsBuilt) {
  const auto player = playing();
  EXPECT_FALSE(player->surface());
  EXPECT_EQ(settle(*player), 1);
  ASSERT_TRUE(player->surface());
  EXPECT_EQ(player->surface()->refinement().levelCount(), 2);
  EXPECT_EQ(player->clock.frames(), 1);
  EXPECT_TRUE(player->orbit());
}

TEST_F(PlayerTest, AnAnimationBringsItsFrames) {
  request.animation.cache = cache("c.pc2", 8, 3, std::vector<float>(72, 0.5F));
  request.animation.frames = "1:3";
  const auto player = playing();
  settle(*player);
  EXPECT_EQ(player->clock.frames(), 2);
  EXPECT_EQ(player->surface()->frameNumber(0), 1);
}

TEST_F(PlayerTest, TheOldSurfaceStaysWhileAnotherIsBuilt) {
  Gate gate;
  const auto player = playing([&gate](const SurfaceRequest& wanted) {
    gate.pass();
    return PlaySurface::build(wanted);
  });
  gate.open();
  settle(*player);
  const auto old = player->surface();
  press(*player, keyOf('='));
  EXPECT_TRUE(player->building());
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(player->update(0.01, 1.6F));
  EXPECT_EQ(player->surface(), old);
  gate.open();
  EXPECT_EQ(settle(*player), 1);
  EXPECT_EQ(player->surface()->refinement().levelCount(), 3);
}

TEST_F(PlayerTest, AMessageGoesWithAKeyOnceItCouldBeSeen) {
  const auto player = playing();
  settle(*player);
  player->say("mind the gap");
  player->update(0.25, 1.6F);
  press(*player, keyOf('F'));
  EXPECT_EQ(player->message(), "mind the gap") << "just said";
  player->update(0.5, 1.6F);
  press(*player, keyOf('B'));
  EXPECT_THAT(player->message(), HasSubstr("refined by")) << "the key's own";
  player->update(0.75, 1.6F);
  press(*player, keyOf('F'));
  EXPECT_EQ(player->message(), "");
}

TEST_F(PlayerTest, OfManyChangesTheLastIsBuilt) {
  Gate gate;
  const auto player = playing([&gate](const SurfaceRequest& wanted) {
    gate.pass();
    return PlaySurface::build(wanted);
  });
  for (int i = 0; i < 3; ++i) press(*player, keyOf('='));
  gate.open();
  gate.open();
  EXPECT_EQ(settle(*player), 1) << "what has been followed by a change isn't shown";
  EXPECT_EQ(gate.arrived(), 2) << "and what was asked for in between isn't built";
  EXPECT_EQ(player->surface()->refinement().levelCount(), 5);
}

TEST_F(PlayerTest, AnErrorIsTheMessageAndTheOldSurfaceStays) {
  const auto player = playing();
  settle(*player);
  const auto old = player->surface();
  SurfaceRequest wrong = player->request();
  wrong.surface.scheme.scheme = "chaikin";
  player->change(wrong);
  EXPECT_EQ(settle(*player), 0);
  EXPECT_EQ(player->surface(), old);
  EXPECT_THAT(player->message(), HasSubstr("there is no 'chaikin'"));
  EXPECT_EQ(player->request().surface.scheme.scheme, "akleman") << "as it was";
  EXPECT_FALSE(player->failure());
}

TEST_F(PlayerTest, WithoutAFirstSurfaceThereIsNothingToPlay) {
  request.surface.input = path("none.obj");
  const auto player = playing();
  settle(*player);
  ASSERT_TRUE(player->failure());
  EXPECT_THAT(player->failure()->message, HasSubstr("none.obj"));
}

TEST_F(PlayerTest, ADroppedMeshIsPlayedAndADroppedCacheMovesIt) {
  const auto player = playing();
  settle(*player);
  player->openFile(file("grid.obj", gridObj(2)));
  settle(*player);
  EXPECT_THAT(player->surface()->file(), HasSubstr("grid.obj"));
  player->openFile(cache("g.pc2", 9, 4, std::vector<float>(108, 0.5F)));
  settle(*player);
  EXPECT_EQ(player->clock.frames(), 4);
  player->openFile(cache("bad.pc2", 5, 1, std::vector<float>(15, 0.5F)));
  settle(*player);
  EXPECT_THAT(player->message(), HasSubstr("has 5 points a frame"));
  EXPECT_EQ(player->clock.frames(), 4);
}

TEST_F(PlayerTest, ALostDeviceLeavesTheCpuAndAMessage) {
  const auto player = playing();
  settle(*player);
  player->useBackend("vulkan");
  player->deviceLost();
  EXPECT_EQ(player->backend.current(), "tbb");
  EXPECT_THAT(player->message(), HasSubstr("the Vulkan device was lost"));
}

TEST_F(PlayerTest, ABackendThatFailsIsLeft) {
  const auto player = playing();
  settle(*player);
  player->useBackend("vulkan");
  EXPECT_TRUE(player->backendFailed({ErrorCode::outOfMemory, "no memory there"}));
  EXPECT_EQ(player->backend.current(), "tbb");
  EXPECT_THAT(player->message(), HasSubstr("no memory there; refined by tbb"));
  EXPECT_FALSE(player->backendFailed({ErrorCode::outOfMemory, "nor here"}));
}

TEST_F(PlayerTest, EveryKeyHasOneCommandAndNoOtherDoesAnything) {
  const auto player = playing();
  settle(*player);
  std::set<int> keys;
  for (const KeyCommand& command : keyCommands()) {
    EXPECT_TRUE(keys.insert(static_cast<int>(command.key)).second) << command.name;
    EXPECT_FALSE(command.help.empty()) << command.name;
    EXPECT_TRUE(press(*player, command.key)) << command.name;
  }
  EXPECT_FALSE(press(*player, keyOf('H')));
  settle(*player);
}

TEST_F(PlayerTest, KeysChangeWhatIsShown) {
  const auto player = playing();
  settle(*player);
  press(*player, keyOf('5'));
  EXPECT_EQ(Viewer::looks()[player->appearance.look].name, "planarity");
  press(*player, keyOf('E'));
  EXPECT_EQ(player->appearance.edges, false);
  press(*player, keyOf('C'));
  EXPECT_TRUE(player->appearance.cage);
  press(*player, keyOf('B'));
  EXPECT_EQ(player->backend.asked(), "vulkan");
  press(*player, keyOf('Q'));
  EXPECT_TRUE(player->quit);
}

TEST_F(PlayerTest, KeysReachEveryOptionOfAScheme) {
  const auto player = playing();
  settle(*player);
  std::set<std::string_view> reached;
  for (std::size_t i = 0; i < optionsOf(player->request()).size(); ++i) {
    reached.insert(player->chosenOption()->name);
    const SurfaceRequest before = player->request();
    const Cli::SchemeOption& option = *player->chosenOption();
    press(*player, keyOf('\''));
    EXPECT_NE(player->request().surface.scheme.text(option), before.surface.scheme.text(option)) << option.name;
    player->change(before);
    press(*player, keyOf('O'));
  }
  EXPECT_EQ(reached.size(), optionsOf(player->request()).size());
  settle(*player);
}

TEST_F(PlayerTest, AnotherSchemeGivesUpOptionsThatItHasNot) {
  const auto player = playing();
  settle(*player);
  SurfaceRequest tense = player->request();
  const auto options = optionsOf(tense);
  tense.surface.scheme.set(*options.front(), "0.6");
  player->change(tense);
  settle(*player);
  EXPECT_EQ(player->message(), "");
  for (std::size_t i = 0; i < Cli::schemes().size(); ++i) {
    press(*player, keyOf('M'));
    settle(*player);
    // Loop subdivision is for triangles, and this is a cube: the others go on from there.
    EXPECT_THAT(player->message(), testing::AnyOf(HasSubstr("scheme "), HasSubstr("Loop subdivision takes triangles")));
  }
  EXPECT_EQ(player->request().surface.scheme.scheme, "akleman");
}

}  // namespace
}  // namespace honeycomb::Test
