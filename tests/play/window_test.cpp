#include <signal.h>

#include <chrono>
#include <functional>
#include <thread>
#include <utility>

#include "tests/cli/workplace.h"
#include "tests/play/display.h"
#include "tests/play/file_drop.h"
#include "tests/play/pictures.h"

namespace honeycomb::Test {
namespace {

constexpr std::int32_t kWidth = 240;
constexpr std::int32_t kHeight = 150;
constexpr int kFrames = 3;

/// Real keys and a real mouse on a server without a screen, and its pixels.
class WindowTest : public Workplace {
 protected:
  void SetUp() override {
    display = Display::open(std::filesystem::path(path("")));
    if (!display) GTEST_SKIP() << "Xvfb or xdotool isn't installed (./setup installs both)";
    const std::string torus = torusObj(6);
    mesh = file("torus.obj", torus);
    std::vector<float> numbers;
    for (int f = 0; f < kFrames; ++f) {
      const std::vector<float> frame = bentFrame(torus, f);
      numbers.insert(numbers.end(), frame.begin(), frame.end());
    }
    frames = cache("torus.pc2", 36, kFrames, numbers);
    display->act("mousemove " + std::to_string(kWidth / 2) + " " + std::to_string(kHeight / 2));
  }
  void TearDown() override { close(); }
  void close() {
    if (child <= 0) return;
    // A window that isn't there yet hears no key.
    const bool ended = becomes([this] {
      display->act("key q");
      return hasEnded(child);
    });
    EXPECT_TRUE(ended) << "q closes the window";
    if (!ended) kill(child, SIGKILL);
    EXPECT_EQ(wait(std::exchange(child, 0)).exitCode, 0);
  }

  std::vector<std::string> options() const {
    return {mesh, "--cache", frames, "--levels", "1", "--size", std::to_string(kWidth) + "x" + std::to_string(kHeight)};
  }
  /// Opens the window without panels and waits for its first picture.
  void open(const std::vector<std::string>& more = {}, const RunOptions& how = {}) {
    std::vector<std::string> arguments = options();
    arguments.insert(arguments.begin(), "play");
    arguments.insert(arguments.end(), {"--output", path("shot_%d.png")});
    arguments.insert(arguments.end(), more.begin(), more.end());
    child = start(arguments, how);
    ASSERT_TRUE(becomes([this] { return shareOf(screen(), lit) > 0.9; })) << "there is a picture";
    display->act("key Tab key g");
    // The server tells a window of the pointer once that enters it.
    display->act("mousemove 600 400 sleep 0.2 mousemove 120 75");
  }
  void openAtFirstFrame(const std::vector<std::string>& more = {}, const RunOptions& how = {}) {
    open(more, how);
    display->act("key Home");
  }
  static bool lit(const Colour& colour) { return colour.red + colour.green + colour.blue > 30; }

  Viewer::Picture screen() const { return display->pixels(kWidth, kHeight); }
  /// Looks until it is so, for a minute at most.
  static bool becomes(const std::function<bool()>& so) {
    for (int i = 0; i < 1200; ++i) {
      if (so()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  }
  /// The picture without a window. Of all frames: the camera holds them all.
  Viewer::Picture headless(int frame, const std::vector<std::string>& more = {}) const {
    return headless(options(), frame, more);
  }
  Viewer::Picture headless(std::vector<std::string> arguments, int frame,
                           const std::vector<std::string>& more = {}) const {
    arguments.insert(arguments.begin(), "play");
    arguments.insert(arguments.end(), {"--headless", "--output", path("headless_%d.png")});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome done = run(arguments);
    EXPECT_EQ(done.exitCode, 0) << done.err;
    return readPng(path("headless_" + std::to_string(frame) + ".png"));
  }
  bool shows(const Viewer::Picture& picture) const {
    return becomes([&] { return screen().rgba == picture.rgba; });
  }
  /// The same, of what is being built: the camera stays where it is until it is told to hold a new surface, and
  /// messages go with a key.
  bool showsOnceHeld(const Viewer::Picture& picture) const {
    return becomes([&] {
      display->act("key f");
      return screen().rgba == picture.rgba;
    });
  }

  /// Whatever the interface has over it: what the window draws, as it writes it, is this picture.
  bool draws(const Viewer::Picture& picture) {
    const std::string shot = path("shot_" + std::to_string(shots++) + ".png");
    display->act("key p");
    return becomes([&] { return readPng(shot).width == kWidth; }) && readPng(shot).rgba == picture.rgba;
  }

  std::unique_ptr<Display> display;
  std::string mesh, frames;
  pid_t child = 0;
  int shots = 0;
};

TEST_F(WindowTest, PlaysUntilItIsStopped) {
  open();
  const Viewer::Picture first = screen();
  EXPECT_TRUE(becomes([&] { return difference(first, screen()) > 0.01; })) << "it plays";
  display->act("key Home");
  EXPECT_TRUE(shows(headless(0))) << "the bytes of the picture without a window";
}

TEST_F(WindowTest, KeysStepAndChangeTheView) {
  openAtFirstFrame();
  display->act("key Right key Right");
  EXPECT_TRUE(shows(headless(2)));
  display->act("key 1");
  EXPECT_TRUE(shows(headless(2, {"--view", "shaded"})));
  display->act("key c key n key e");
  EXPECT_TRUE(shows(headless(2, {"--view", "shaded", "--cage", "--normals-shown", "--edges"})));
}

TEST_F(WindowTest, OptionsAreLive) {
  openAtFirstFrame();
  const auto akleman = headless(0);
  display->act("key m");
  EXPECT_TRUE(showsOnceHeld(headless(0, {"--scheme", "zhang-wang"})));
  display->act("key u");
  EXPECT_TRUE(showsOnceHeld(akleman));
  display->act("key apostrophe");
  EXPECT_TRUE(showsOnceHeld(headless(0, {"--tension", "0.5"})));
}

TEST_F(WindowTest, TheMouseTurnsMovesAndZoomsAndFComesBack) {
  openAtFirstFrame();
  const Viewer::Picture before = headless(0);
  ASSERT_TRUE(shows(before));
  const auto changes = [&](const std::string& by) {
    const Viewer::Picture old = screen();
    display->act(by);
    return becomes([&] { return difference(old, screen()) > 0.02; });
  };
  EXPECT_TRUE(changes("mousedown 1 mousemove_relative 40 5 mouseup 1")) << "turned";
  EXPECT_TRUE(changes("mousedown 3 mousemove_relative 20 12 mouseup 3")) << "moved";
  EXPECT_TRUE(changes("click 4 click 4 click 4")) << "closer";
  display->act("key f");
  EXPECT_FALSE(screen().rgba == before.rgba) << "everything is in the picture again, from another side";
}

TEST_F(WindowTest, WritesThePictureThatHeadlessWrites) {
  openAtFirstFrame();
  const Viewer::Picture expected = headless(0);
  ASSERT_TRUE(shows(expected));
  EXPECT_TRUE(draws(expected));
}

TEST_F(WindowTest, EveryBackendShowsTheSame) {
  openAtFirstFrame();
  const Viewer::Picture expected = headless(0);
  ASSERT_TRUE(shows(expected));
  for (int i = 0; i < 4; ++i) {
    display->act("key b key Right key Left");
    // The picture is there once the keys before it have been heard.
    EXPECT_TRUE(draws(expected)) << i;
    EXPECT_TRUE(showsOnceHeld(expected)) << i << ", and no message that the backend isn't ready";
  }
}

TEST_F(WindowTest, HelpIsOverThePicture) {
  openAtFirstFrame();
  const Viewer::Picture bare = headless(0);
  ASSERT_TRUE(shows(bare));
  display->act("key question");
  EXPECT_TRUE(becomes([&] { return difference(bare, screen()) > 0.3; }));
  display->act("key question");
  EXPECT_TRUE(shows(bare));
}

// A layer between the program and the driver has the device lost at a submission, as a reset of a GPU does.
TEST_F(WindowTest, WhereTheDeviceIsLostTheCpuGoesOn) {
  const std::string order = path("lose_device"), summary = path("summary.json");
  RunOptions how;
  how.environment = {{"VK_LAYER_PATH", HONEYCOMB_LAYER_FOLDER},
                     {"VK_INSTANCE_LAYERS", "VK_LAYER_lost_device"},
                     {"HONEYCOMB_LOSE_DEVICE", order}};
  how.output = summary;
  openAtFirstFrame({"--backend", "vulkan", "--json"}, how);
  const Viewer::Picture expected = headless(0);
  ASSERT_TRUE(shows(expected));
  (void)file("lose_device", "");
  ASSERT_TRUE(becomes([&] { return !std::filesystem::exists(order); })) << "it is lost";
  EXPECT_TRUE(becomes([&] { return shareOf(screen(), lit) > 0.9 && difference(expected, screen()) > 0.02; }))
      << "a message says so";
  EXPECT_TRUE(draws(expected));
  display->act("key Right");
  EXPECT_TRUE(draws(headless(1)));
  close();
  EXPECT_THAT(read("summary.json"), testing::HasSubstr("\"backend\": \"tbb\""));
}

TEST_F(WindowTest, DroppedFilesArePlayed) {
  const std::string other = file("cube.obj", cubeObj());
  openAtFirstFrame();
  ASSERT_TRUE(shows(headless(0)));
  ASSERT_TRUE(dropFiles({other}));
  EXPECT_TRUE(shows(headless({other, "--levels", "1", "--size", "240x150"}, 0)));
  ASSERT_TRUE(dropFiles({frames, mesh})) << "a cache and its mesh, in any order";
  ASSERT_TRUE(shows(headless(0))) << "a key before that is for the cube, which has one frame";
  display->act("key Right");
  EXPECT_TRUE(shows(headless(1)));
}

TEST_F(WindowTest, DroppedFilesOfOtherKindsAreRefusedInWords) {
  openAtFirstFrame();
  const Viewer::Picture before = headless(0);
  ASSERT_TRUE(shows(before));
  ASSERT_TRUE(dropFiles({file("notes.txt", "nothing to see")}));
  EXPECT_TRUE(becomes([&] { return difference(before, screen()) > 0.02; })) << "a message says why";
  EXPECT_TRUE(draws(before)) << "what was there is there still";
}

TEST(WindowErrorsTest, WithoutADisplayTheErrorSaysWhatElseToDo) {
  const Outcome done = run({"play", "cube.obj"}, {.environment = {{"DISPLAY", ""}}});
  EXPECT_EQ(done.exitCode, 1);
  EXPECT_TRUE(isOneErrorLine(done.err)) << done.err;
  EXPECT_THAT(done.err, testing::HasSubstr("write pictures with --headless"));
}

}  // namespace
}  // namespace honeycomb::Test
