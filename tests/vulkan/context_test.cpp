// Devices: found, listed, chosen.
#include "osd/vulkan/context.h"

#include <gmock/gmock.h>

#include "fixture.h"

namespace honeycomb::VulkanTests {
namespace {

using testing::HasSubstr;

class ContextTest : public VulkanTest {};

TEST_F(ContextTest, HasADeviceAndAQueueForComputeAndDrawing) {
  EXPECT_NE(context->device().instance, VkInstance{});
  EXPECT_NE(context->device().physicalDevice, VkPhysicalDevice{});
  EXPECT_NE(context->device().device, VkDevice{});
  EXPECT_NE(context->device().queue, VkQueue{});
  EXPECT_FALSE(context->deviceName().empty());
  EXPECT_TRUE(context->supportsGraphics());
  EXPECT_EQ(context->limits().maxStorageBufferRange, context->info().maxStorageBufferRange);
}

TEST_F(ContextTest, SurvivesBeingMoved) {
  const VkDevice device = context->device().device;
  Osd::VulkanContext moved = std::move(*context);
  EXPECT_EQ(moved.device().device, device);
  EXPECT_EQ(context->device().device, VkDevice{});
  *context = std::move(moved);
  EXPECT_EQ(context->device().device, device);
  EXPECT_TRUE(Osd::VulkanEvaluator::create(context->device()));
}

TEST_F(ContextTest, ListsTheDevicesItChoosesFrom) {
  const auto devices = Osd::listDevices();
  ASSERT_TRUE(devices) << devices.error().message;
  ASSERT_FALSE(devices->empty());
  for (const Osd::DeviceInfo& device : *devices) {
    EXPECT_FALSE(device.name.empty());
    EXPECT_GT(device.maxStorageBufferRange, 0U);
    EXPECT_GT(device.heapSize, 0U);
    EXPECT_GT(device.subgroupSize, 0U);
  }
  const auto byIndex = Osd::VulkanContext::create({.device = "0"});
  const auto byName = Osd::VulkanContext::create({.device = devices->front().name.substr(0, 5)});
  ASSERT_TRUE(byIndex && byName);
  EXPECT_EQ(byIndex->deviceName(), devices->front().name);
  EXPECT_EQ(byName->deviceName(), devices->front().name);
}

TEST_F(ContextTest, ADeviceThatIsNotThereIsAnError) {
  const auto refused = Osd::VulkanContext::create({.device = "Voodoo 2"});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::noDevice);
  EXPECT_THAT(refused.error().message, HasSubstr("no Vulkan device matches 'Voodoo 2'"));
  EXPECT_THAT(refused.error().message, HasSubstr(context->deviceName()));
}

TEST_F(ContextTest, AnExtensionThatIsNotThereIsAnError) {
  const auto refused = Osd::VulkanContext::create({.deviceExtensions = {"VK_HONEYCOMB_none"}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
}

std::vector<Osd::DeviceInfo> devicesOf(const std::vector<VkPhysicalDeviceType>& types) {
  std::vector<Osd::DeviceInfo> devices;
  for (const VkPhysicalDeviceType type : types) devices.push_back({.name = Osd::deviceTypeName(type), .type = type});
  return devices;
}

TEST(ChooseDevice, AutoPrefersDiscreteThenIntegratedThenVirtualThenCpu) {
  std::vector types{VK_PHYSICAL_DEVICE_TYPE_OTHER, VK_PHYSICAL_DEVICE_TYPE_CPU, VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU,
                    VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU, VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU};
  for (; !types.empty(); types.pop_back()) EXPECT_EQ(Osd::chooseDevice(devicesOf(types), "auto"), types.size() - 1);
}

TEST(ChooseDevice, TakesTheFirstOfEquals) {
  EXPECT_EQ(Osd::chooseDevice(devicesOf({VK_PHYSICAL_DEVICE_TYPE_CPU, VK_PHYSICAL_DEVICE_TYPE_CPU}), "auto"), 0U);
}

TEST(ChooseDevice, ByIndexOrPartOfANameInAnyCase) {
  const auto devices = devicesOf({VK_PHYSICAL_DEVICE_TYPE_CPU, VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU});
  EXPECT_EQ(Osd::chooseDevice(devices, "1"), 1U);
  EXPECT_EQ(Osd::chooseDevice(devices, "CRETE"), 1U);
  EXPECT_FALSE(Osd::chooseDevice(devices, "2"));
  EXPECT_FALSE(Osd::chooseDevice(devices, ""));
}

TEST(ChooseDevice, WithoutDevicesSaysWhatToInstall) {
  const auto refused = Osd::chooseDevice({}, "auto");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::noDevice);
  EXPECT_THAT(refused.error().message, HasSubstr("install a driver such as mesa-vulkan-drivers, or use a CPU backend"));
}

}  // namespace
}  // namespace honeycomb::VulkanTests
