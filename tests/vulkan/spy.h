#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "osd/vulkan/functions.h"

namespace honeycomb::VulkanTests {

/// As long as one lives, its thread is in Vulkan, or in the spy: what is allocated then isn't ours.
class InVulkan {
 public:
  InVulkan() { ++depth; }
  ~InVulkan() { --depth; }
  InVulkan(const InVulkan&) = delete;
  InVulkan& operator=(const InVulkan&) = delete;
  static bool here() { return depth > 0; }

 private:
  static inline thread_local int depth = 0;
};

/// Stands between evaluators and a device: all functions they look up are counted, and fail where they are told to.
/// One at a time, since Vulkan's functions have no place for a pointer of ours; safe from several threads.
class Spy {
 public:
  explicit Spy(const Osd::VulkanDevice& device);
  ~Spy();
  Spy(const Spy&) = delete;
  Spy& operator=(const Spy&) = delete;

  /// The device as evaluators are to see it.
  Osd::VulkanDevice device() const;

  /// The `call`-th call of that function from now on (1: the next) fails so, once. Nothing is executed then, but for a
  /// wait, which is waited for.
  void fail(std::string_view function, int call, VkResult result);
  /// Has it failed?
  bool struck() const;
  /// As in a driver that has no such function.
  void hide(std::string_view function);
  /// The device's only extension is VK_EXT_memory_budget, or it has none at all.
  void setExtension(bool budget) { extension_ = budget; }
  /// What VK_EXT_memory_budget says of every heap.
  void setBudget(std::uint64_t used, std::uint64_t limit) { budget_ = {used, limit}; }

  /// Objects and device memory that were made and not destroyed.
  std::int64_t alive() const;
  /// Calls with other allocation callbacks than the device's.
  int strangers() const;
  /// Calls of that function so far.
  int calls(std::string_view function) const;

  /// Functions that can fail: they return a VkResult.
  static const std::vector<std::string>& fallible();

  /// For the functions themselves: what the call is to return instead of being executed, and that it was.
  std::optional<VkResult> called(const char* function);
  void executed(const char* function);
  void given(const VkAllocationCallbacks* allocator);
  /// Other arguments don't matter.
  template <class Argument>
  void given(const Argument&) {}
  /// Answers in the place of VK_EXT_memory_budget; false without a budget.
  bool tell(VkPhysicalDeviceMemoryBudgetPropertiesEXT& budget) const;
  std::optional<bool> extension() const { return extension_; }
  PFN_vkVoidFunction ofInstance(VkInstance instance, const char* name) const;
  PFN_vkVoidFunction ofDevice(VkDevice device, const char* name) const;

 private:
  struct Fault {
    std::string function;
    int call = 0;
    VkResult result = VK_SUCCESS;
  };
  struct Budget {
    std::uint64_t used = 0, limit = 0;
  };

  Osd::VulkanDevice real_;
  PFN_vkGetDeviceProcAddr getDevice_ = nullptr;
  mutable std::mutex mutex_;
  std::map<std::string, int, std::less<>> calls_;
  std::set<std::string, std::less<>> hidden_;
  std::optional<Fault> fault_;
  std::optional<Budget> budget_;
  std::int64_t alive_ = 0;
  int strangers_ = 0;
  std::optional<bool> extension_;
};

}  // namespace honeycomb::VulkanTests
