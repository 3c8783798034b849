#include "apps/cli/play/backend_loader.h"

#include <chrono>
#include <cstdlib>
#include <thread>

#include "tests/play/stage_fixture.h"

namespace honeycomb::Test {
namespace {

using namespace Cli::Play;

class BackendLoaderTest : public StageTest {
 protected:
  void SetUp() override {
    ASSERT_TRUE(stage_->show(surface(torusObj(4))));
    ASSERT_TRUE(stage_->pose("tbb", 0));
  }
  /// Asks until there is an answer that isn't "not yet", for a minute at most.
  Result<bool> settled(const std::string& backend) {
    for (int i = 0; i < 6000; ++i) {
      if (auto ready = loader.ready(backend); !ready || *ready) return ready;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  BackendLoader loader{*stage_};
};

TEST_F(BackendLoaderTest, BringsABackendWhileAnotherGoesOn) {
  const Viewer::Picture expected = picture("tbb");
  EXPECT_FALSE(loader.ready("vulkan").value()) << "this thread doesn't wait for it";
  EXPECT_EQ(picture("tbb").rgba, expected.rgba) << "meanwhile";
  ASSERT_TRUE(settled("vulkan").value());
  EXPECT_TRUE(stage_->refinesBy("vulkan"));
  EXPECT_EQ(picture("vulkan").rgba, expected.rgba);
}

TEST_F(BackendLoaderTest, OneAfterAnother) {
  EXPECT_FALSE(loader.ready("vulkan").value());
  EXPECT_FALSE(loader.ready("serial").value());
  EXPECT_TRUE(settled("serial").value());
  EXPECT_TRUE(loader.ready("vulkan").value());
}

TEST_F(BackendLoaderTest, NothingComesOfASurfaceThatIsNotShownAnyMore) {
  EXPECT_FALSE(loader.ready("vulkan").value());
  ASSERT_TRUE(stage_->show(surface(cubeObj())));
  EXPECT_TRUE(settled("serial").value()) << "what was asked for of the other surface is done by then";
  EXPECT_FALSE(stage_->refinesBy("vulkan"));
  EXPECT_TRUE(settled("vulkan").value());
  EXPECT_EQ(picture("vulkan").rgba, picture("serial").rgba);
}

TEST_F(BackendLoaderTest, AnErrorIsToldOnceWhoeverAsksInBetween) {
  EXPECT_FALSE(loader.ready("abacus").value());
  EXPECT_TRUE(settled("serial").value());
  const auto refused = loader.ready("abacus");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
  EXPECT_THAT(refused.error().message, testing::HasSubstr("vulkan")) << "what there is";
  EXPECT_FALSE(loader.ready("abacus").value()) << "tried again";
}

/// A folder for what Mesa compiles, for as long as it lives.
class ShaderCache {
 public:
  explicit ShaderCache(std::filesystem::path folder) : folder_(std::move(folder)) {
    setenv("MESA_SHADER_CACHE_DIR", folder_.c_str(), 1);
    unsetenv("MESA_SHADER_CACHE_DISABLE");
  }
  ~ShaderCache() { unsetenv("MESA_SHADER_CACHE_DIR"); }
  ShaderCache(const ShaderCache&) = delete;
  ShaderCache& operator=(const ShaderCache&) = delete;
  /// Shaders in it; the index is there from the start.
  int shaders() const {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
      count += entry.is_regular_file() && entry.path().filename() != "index" ? 1 : 0;
    return count;
  }

 private:
  std::filesystem::path folder_;
};

// lavapipe compiles a kernel when it first runs and keeps it in its cache: it has run before the stage's device runs
// it.
TEST_F(BackendLoaderTest, WhatADriverCompilesLateIsCompiledBeforeItIsReady) {
  if (stage_->context().deviceName().find("llvmpipe") == std::string::npos) GTEST_SKIP() << "this isn't lavapipe";
  std::filesystem::create_directory(path("shaders"));
  const ShaderCache cache(path("shaders"));
  const Stage stage = Stage::open({.picture = {64, 48}}).value();
  ASSERT_EQ(cache.shaders(), 0);
  ASSERT_TRUE(stage.prepare("vulkan", *surface(cubeObj())));
  // The driver writes its files behind our back.
  for (int i = 0; i < 6000 && cache.shaders() == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_GT(cache.shaders(), 0);
}

}  // namespace
}  // namespace honeycomb::Test
