#include "runs.h"

#include <bit>
#include <cstdint>

#include "osd/vulkan/session.h"
#include "reference.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {

using Test::randomNumbers;

testing::AssertionResult sameBits(std::span<const float> expected, std::span<const float> actual) {
  if (expected.size() != actual.size()) {
    return testing::AssertionFailure() << expected.size() << " numbers expected, " << actual.size() << " there";
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (std::bit_cast<std::uint32_t>(expected[i]) == std::bit_cast<std::uint32_t>(actual[i])) continue;
    return testing::AssertionFailure() << "number " << i << " of " << expected.size() << ": expected " << expected[i]
                                       << ", got " << actual[i] << ", off by " << actual[i] - expected[i];
  }
  return testing::AssertionSuccess();
}

std::vector<const Far::LevelTable*> pointersTo(const std::vector<Far::LevelTable>& levels) {
  std::vector<const Far::LevelTable*> pointers;
  for (const Far::LevelTable& level : levels) pointers.push_back(&level);
  return pointers;
}

std::vector<float> expectedPoints(const std::vector<Far::LevelTable>& levels, const std::vector<float>& control,
                                  const Osd::BufferDescriptor& controlDesc, const Osd::BufferDescriptor& refinedDesc) {
  std::vector<float> points = control;
  Osd::BufferDescriptor desc = controlDesc;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Osd::BufferDescriptor packed{0, desc.length, desc.length};
    const Osd::BufferDescriptor next = i + 1 == levels.size() ? refinedDesc : packed;
    std::vector<float> target(static_cast<std::size_t>(next.extent(levels[i].targetCount)));
    evaluateLevel(levels[i], points, desc, target, next);
    points = std::move(target);
    desc = next;
  }
  return points;
}

testing::AssertionResult agrees(Osd::VulkanEvaluator& evaluator, const std::vector<Far::LevelTable>& levels,
                                const Osd::BufferDescriptor& control, const Osd::BufferDescriptor& refined) {
  auto table = evaluator.upload(pointersTo(levels), nullptr, {.control = control, .refined = refined});
  if (!table) return testing::AssertionFailure() << table.error().message;
  auto session = Osd::VulkanSession::create(evaluator, *table);
  if (!session) return testing::AssertionFailure() << session.error().message;
  std::vector<float> out(session->refined().size());
  for (const std::uint32_t frame : {1U, 2U}) {
    const auto in = randomNumbers(control.extent(levels.front().sourceCount), frame);
    if (const auto ran = session->refine(in, out); !ran) return testing::AssertionFailure() << ran.error().message;
    if (auto same = sameBits(expectedPoints(levels, in, control, refined), out); !same)
      return same << ", frame " << frame;
  }
  return testing::AssertionSuccess();
}

}  // namespace honeycomb::VulkanTests
