#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "osd/vulkan/context.h"
#include "osd/vulkan/evaluator.h"
#include "osd/vulkan/instance.h"

namespace honeycomb::VulkanTests {

/// Is the validation layer wanted? The test preset `validation` sets HONEYCOMB_VULKAN_VALIDATION=1.
inline bool validationWanted() {
  const char* value = std::getenv("HONEYCOMB_VULKAN_VALIDATION");
  return value != nullptr && std::string_view(value) == "1";
}

/// A device for each test. At its end the device is destroyed, and nothing may have been said by the validation layer,
/// leaked objects included (without the `validation` preset the layer isn't loaded).
class VulkanTest : public testing::Test {
 protected:
  void SetUp() override {
    auto created = Osd::VulkanContext::create({.validation = validationWanted()});
    ASSERT_TRUE(created) << created.error().message;
    context.emplace(std::move(*created));
  }

  void TearDown() override {
    if (!context) return;
    const auto log = context->validationLog();
    context.reset();
    if (!log) return;
    for (const std::string& message : log->messages()) ADD_FAILURE() << message;
  }

  Osd::VulkanEvaluator makeEvaluator(const Osd::VulkanEvaluatorOptions& options = {}) {
    auto evaluator = Osd::VulkanEvaluator::create(context->device(), options);
    if (!evaluator) throw std::runtime_error(evaluator.error().message);
    return std::move(*evaluator);
  }

  std::optional<Osd::VulkanContext> context;
};

}  // namespace honeycomb::VulkanTests
