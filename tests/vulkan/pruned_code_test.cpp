// Branches that constants decide are cut off a kernel's SPIR-V, and nothing else is.
#include "osd/vulkan/pruned_code.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <vector>

#include "osd/vulkan/pipelines.h"

namespace honeycomb::VulkanTests {
namespace {

using Osd::Kernel;
using Osd::Specialization;
using Words = std::vector<std::uint32_t>;
using testing::ElementsAreArray;

// SPIR-V 1.6, 3.32 "Instructions".
constexpr std::uint32_t kNameOp = 5, kConstantOp = 43, kSpecConstantOp = 50, kSpecOperation = 52, kDecorateOp = 71,
                        kBitwiseAndOp = 199, kNotEqualOp = 171, kPhiOp = 245, kLoopMergeOp = 246,
                        kSelectionMergeOp = 247, kLabelOp = 248, kBranchOp = 249, kBranchConditionalOp = 250;

/// A module of instructions, with the header that all have.
class Module {
 public:
  Module& add(std::uint32_t opcode, const Words& operands) {
    words.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16 | opcode);
    words.insert(words.end(), operands.begin(), operands.end());
    return *this;
  }
  Words words{0x07230203, 0x00010500, 0, 100, 0};
};

/// Ids: 1 the constant `cases` (constant_id 10), 2 the number 4, 3 the number 0, 4 their intersection, 5 the condition.
Module withCondition() {
  return Module()
      .add(kDecorateOp, {1, 1, 10})
      .add(kSpecConstantOp, {90, 1, 0})
      .add(kConstantOp, {90, 2, 4})
      .add(kConstantOp, {90, 3, 0})
      .add(kSpecOperation, {90, 4, kBitwiseAndOp, 1, 2})
      .add(kSpecOperation, {91, 5, kNotEqualOp, 4, 3});
}

Module withSelection(std::uint32_t condition) {
  return withCondition()
      .add(kLabelOp, {20})
      .add(kSelectionMergeOp, {22, 0})
      .add(kBranchConditionalOp, {condition, 21, 22})
      .add(kLabelOp, {21})
      .add(kBranchOp, {22})
      .add(kLabelOp, {22});
}

Module withJump(std::uint32_t target) {
  return withCondition()
      .add(kLabelOp, {20})
      .add(kBranchOp, {target})
      .add(kLabelOp, {21})
      .add(kBranchOp, {22})
      .add(kLabelOp, {22});
}

Words pruned(const Module& module, std::uint32_t cases) {
  Specialization specialization;
  specialization.cases = cases;
  return Osd::prunedCode(module.words, specialization);
}

TEST(PrunedCodeTest, ASelectionThatConstantsDecideIsAJump) {
  EXPECT_THAT(pruned(withSelection(5), 12), ElementsAreArray(withJump(21).words));
  EXPECT_THAT(pruned(withSelection(5), 3), ElementsAreArray(withJump(22).words));
}

TEST(PrunedCodeTest, OneThatIsDecidedWhileItRunsStays) {
  EXPECT_THAT(pruned(withSelection(6), 12), ElementsAreArray(withSelection(6).words));
}

TEST(PrunedCodeTest, ALoopStays) {
  const Module loop = withCondition()
                          .add(kLabelOp, {20})
                          .add(kLoopMergeOp, {22, 23, 0})
                          .add(kBranchConditionalOp, {5, 21, 22})
                          .add(kLabelOp, {21});
  EXPECT_THAT(pruned(loop, 3), ElementsAreArray(loop.words));
}

TEST(PrunedCodeTest, AJoinKeepsTheBranchesThatItNames) {
  const Module join = withSelection(5).add(kPhiOp, {91, 6, 3, 20, 4, 21});
  EXPECT_THAT(pruned(join, 12), ElementsAreArray(join.words)) << "the join isn't taken from block 20";
  EXPECT_THAT(pruned(join, 3), ElementsAreArray(withJump(22).add(kPhiOp, {91, 6, 3, 20, 4, 21}).words));
}

TEST(PrunedCodeTest, WhatIsNotWholeStays) {
  Module broken = withSelection(5);
  broken.words.push_back(9U << 16 | kNameOp);
  EXPECT_THAT(pruned(broken, 3), ElementsAreArray(broken.words));
  EXPECT_THAT(pruned(Module(), 3), ElementsAreArray(Module().words));
}

std::size_t branchesIn(const Words& code) {
  std::size_t branches = 0;
  for (std::size_t i = 5; i < code.size(); i += code[i] >> 16)
    branches += (code[i] & 0xffffU) == kBranchConditionalOp ? 1 : 0;
  return branches;
}

TEST(PrunedCodeTest, EachCaseOfTilesIsABranchThatConstantsDecide) {
  for (const Kernel kernel : {Kernel::tileBuffer, Kernel::tileLong, Kernel::tileShared}) {
    const auto code = Osd::kernelCode(kernel);
    const std::size_t all = branchesIn({code.begin(), code.end()}), left = branchesIn(Osd::prunedCode(code, {}));
    EXPECT_GE(all - left, 49U);
  }
}

}  // namespace
}  // namespace honeycomb::VulkanTests
