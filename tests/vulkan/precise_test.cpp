// Contraction would change bits on the devices that do it, which the one under test may not: so the compiled kernels
// are read, and every operation on floating-point numbers must be marked NoContraction.
#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "osd/vulkan/pipelines.h"

namespace honeycomb::VulkanTests {
namespace {

// Of the SPIR-V specification: opcodes, and the decoration.
constexpr std::uint32_t kOpDecorate = 71;
constexpr std::uint32_t kNoContraction = 42;
const std::set<std::uint32_t> kArithmetic = {
    127 /*FNegate*/, 129 /*FAdd*/, 131 /*FSub*/, 133 /*FMul*/, 136 /*FDiv*/, 142 /*VectorTimesScalar*/, 148 /*Dot*/};
constexpr std::size_t kHeaderWords = 5;

struct Arithmetic {
  std::size_t operations = 0;
  std::size_t contractible = 0;
};

Arithmetic inspect(std::span<const std::uint32_t> code) {
  std::set<std::uint32_t> precise;
  std::vector<std::uint32_t> results;
  for (std::size_t at = kHeaderWords; at < code.size(); at += code[at] >> 16U) {
    const std::uint32_t opcode = code[at] & 0xFFFFU;
    if (opcode == kOpDecorate && code[at + 2] == kNoContraction) precise.insert(code[at + 1]);
    if (kArithmetic.contains(opcode)) results.push_back(code[at + 2]);
  }
  Arithmetic found{.operations = results.size()};
  for (const std::uint32_t id : results) found.contractible += precise.contains(id) ? 0U : 1U;
  return found;
}

TEST(PreciseTest, NoOperationOfAnyKernelMayBeContracted) {
  for (std::uint32_t k = 0; k < Osd::kKernelCount; ++k) {
    const Arithmetic found = inspect(Osd::kernelCode(static_cast<Osd::Kernel>(k)));
    const bool ofPoints = k < static_cast<std::uint32_t>(Osd::Kernel::zipFaceOf);
    EXPECT_EQ(found.operations > 0U, ofPoints) << "kernel " << k;
    EXPECT_EQ(found.contractible, 0U) << "kernel " << k << " of " << found.operations << " operations";
  }
}

}  // namespace
}  // namespace honeycomb::VulkanTests
