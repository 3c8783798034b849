// Kernels from a folder, for those who tune them: builds with HONEYCOMB_KERNEL_RELOAD; others say that they can't.
#include "osd/vulkan/kernel_files.h"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>

#include "fixture.h"
#include "osd/vulkan/frames.h"
#include "osd/vulkan/session.h"
#include "runs.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using Test::randomNumbers;
using Test::randomTable;
using testing::HasSubstr;

class KernelFilesTest : public VulkanTest {
 protected:
  void SetUp() override {
    VulkanTest::SetUp();
    folder = std::filesystem::path(testing::TempDir()) /
             (std::string("kernels_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  void TearDown() override {
    std::filesystem::remove_all(folder);
    VulkanTest::TearDown();
  }

  std::filesystem::path folder;
};

#ifndef HONEYCOMB_KERNEL_RELOAD

TEST_F(KernelFilesTest, ABuildWithoutSaysWhatToConfigure) {
  const auto refused = Osd::VulkanEvaluator::create(context->device(), {.kernelFolder = folder});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  EXPECT_THAT(refused.error().message, HasSubstr("HONEYCOMB_KERNEL_RELOAD"));
}

#else

/// SPIR-V of a kernel that does nothing: `void main() {}`, 64 invocations a workgroup.
std::vector<std::uint32_t> idleKernel() {
  const auto op = [](std::uint32_t words, std::uint32_t code) { return words << 16U | code; };
  return {0x07230203, 0x00010000, 0,          5,          0,     // header, 5 ids
          op(2, 17),  1,                                         // OpCapability Shader
          op(3, 14),  0,          1,                             // OpMemoryModel Logical GLSL450
          op(5, 15),  5,          1,          0x6e69616d, 0,     // OpEntryPoint GLCompute %1 "main"
          op(6, 16),  1,          17,         64,         1, 1,  // OpExecutionMode %1 LocalSize
          op(2, 19),  2,                                         // %2 = OpTypeVoid
          op(3, 33),  3,          2,                             // %3 = OpTypeFunction %2
          op(5, 54),  2,          1,          0,          3,     // %1 = OpFunction
          op(2, 248), 4,          op(1, 253), op(1, 56)};        // OpLabel, OpReturn, OpFunctionEnd
}

class KernelReloadTest : public KernelFilesTest {
 protected:
  /// Each file is newer than the one before, however fast they are written.
  void put(std::span<const std::uint32_t> code) {
    const auto file = folder / "circulant.comp.spv";
    const auto bytes = std::as_bytes(code);
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    std::filesystem::last_write_time(file, start + std::chrono::seconds(++written));
  }
  /// Does a session give the reference's points of another frame than those before?
  bool right(Osd::VulkanSession& session) {
    const auto in = randomNumbers(900, ++frame);
    std::vector<float> out(session.refined().size());
    const auto ran = session.refine(in, out);
    EXPECT_TRUE(ran);
    return static_cast<bool>(sameBits(expectedPoints(levels, in, {}, {}), out));
  }

  const std::filesystem::file_time_type start = std::filesystem::file_time_type::clock::now();
  int written = 0;
  std::uint32_t frame = 0;
  const std::vector<Far::LevelTable> levels{randomTable({.sourceCount = 300, .circulants = {{5, 20}, {6, 60}}}, 1)};
};

TEST_F(KernelReloadTest, AKernelThatChangesIsUsedFromTheNextFrameOn) {
  auto evaluator = makeEvaluator({.kernelFolder = folder});
  auto session = *Osd::VulkanSession::create(evaluator, *evaluator.upload(pointersTo(levels), nullptr));
  EXPECT_TRUE(right(session));
  put(idleKernel());
  EXPECT_FALSE(right(session));
  put(Osd::kernelCode(Osd::Kernel::circulant));
  EXPECT_TRUE(right(session));
  EXPECT_TRUE(right(session));
}

TEST_F(KernelReloadTest, AnEvaluatorStartsWithWhatIsInTheFolder) {
  put(idleKernel());
  auto evaluator = makeEvaluator({.kernelFolder = folder});
  auto session = *Osd::VulkanSession::create(evaluator, *evaluator.upload(pointersTo(levels), nullptr));
  EXPECT_FALSE(right(session));
}

TEST_F(KernelReloadTest, FramesInFlightTakeTheNewKernelWhenTheirTurnComes) {
  auto evaluator = makeEvaluator({.kernelFolder = folder});
  auto frames = *Osd::VulkanFrames::create(evaluator, *evaluator.upload(pointersTo(levels), nullptr));
  const auto before = randomNumbers(900, 1), after = randomNumbers(900, 2);
  const auto old = *frames.submit(before);
  put(idleKernel());
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(frames.submit(after));
  put(Osd::kernelCode(Osd::Kernel::circulant));
  const auto last = *frames.submit(after);
  ASSERT_TRUE(frames.wait(last));
  EXPECT_FALSE(frames.results(old));
  EXPECT_TRUE(
      sameBits(expectedPoints(levels, after, {}, {}), (*frames.results(last))->numbers(Osd::PointBuffer::refined)));
}

TEST_F(KernelReloadTest, AFileThatIsNoWholeSpirvIsAnErrorAndTheOldKernelStays) {
  auto evaluator = makeEvaluator({.kernelFolder = folder});
  auto session = *Osd::VulkanSession::create(evaluator, *evaluator.upload(pointersTo(levels), nullptr));
  const auto good = Osd::kernelCode(Osd::Kernel::circulant);
  for (const auto& bad : {good.first(good.size() - 1), good.first(5), good.first(0), good.subspan(1)}) {
    put(bad);
    const auto refused = session.run();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::invalidFile);
    EXPECT_THAT(refused.error().message, HasSubstr("circulant.comp.spv"));
    EXPECT_TRUE(right(session));
  }
}

#endif

}  // namespace
}  // namespace honeycomb::VulkanTests
