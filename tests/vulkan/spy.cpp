#include "spy.h"

#include <cstring>

namespace honeycomb::VulkanTests {

namespace {

Spy* currentSpy = nullptr;

// A number for each function, so that each has a Spied of its own.
enum class Name {
#define HONEYCOMB_NAME(name) name,
  HONEYCOMB_VULKAN_INSTANCE_FUNCTIONS(HONEYCOMB_NAME) HONEYCOMB_VULKAN_DEVICE_FUNCTIONS(HONEYCOMB_NAME)
#undef HONEYCOMB_NAME
};

const char* textOf(Name name) {
  static constexpr const char* kTexts[] = {
#define HONEYCOMB_TEXT(name) #name,
      HONEYCOMB_VULKAN_INSTANCE_FUNCTIONS(HONEYCOMB_TEXT) HONEYCOMB_VULKAN_DEVICE_FUNCTIONS(HONEYCOMB_TEXT)
#undef HONEYCOMB_TEXT
  };
  return kTexts[static_cast<std::size_t>(name)];
}

template <Name kName, class Function>
struct Spied;

template <Name kName, class... Arguments>
struct Spied<kName, VkResult(VKAPI_PTR*)(Arguments...)> {
  static constexpr bool kFallible = true;
  static inline VkResult(VKAPI_PTR* real)(Arguments...) = nullptr;
  static VKAPI_ATTR VkResult VKAPI_CALL call(Arguments... arguments) {
    const InVulkan inVulkan;
    (currentSpy->given(arguments), ...);
    if (const auto failure = currentSpy->called(textOf(kName))) {
      // Else what was submitted would still run while the evaluator takes its buffers away.
      if (std::string_view(textOf(kName)).starts_with("vkWait")) real(arguments...);
      return *failure;
    }
    const VkResult result = real(arguments...);
    if (result == VK_SUCCESS) currentSpy->executed(textOf(kName));
    return result;
  }
};

template <Name kName, class... Arguments>
struct Spied<kName, void(VKAPI_PTR*)(Arguments...)> {
  static constexpr bool kFallible = false;
  static inline void(VKAPI_PTR* real)(Arguments...) = nullptr;
  static VKAPI_ATTR void VKAPI_CALL call(Arguments... arguments) {
    const InVulkan inVulkan;
    (currentSpy->given(arguments), ...);
    currentSpy->called(textOf(kName));
    real(arguments...);
    currentSpy->executed(textOf(kName));
  }
};

VKAPI_ATTR VkResult VKAPI_CALL fewExtensions(VkPhysicalDevice, const char*, std::uint32_t* count,
                                             VkExtensionProperties* extensions) {
  *count = currentSpy->extension().value_or(false) ? 1 : 0;
  if (extensions != nullptr && *count == 1) {
    std::strcpy(extensions->extensionName, VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
  }
  return VK_SUCCESS;
}

VKAPI_ATTR void VKAPI_CALL memoryProperties(VkPhysicalDevice device, VkPhysicalDeviceMemoryProperties2* memory) {
  using Real = Spied<Name::vkGetPhysicalDeviceMemoryProperties2, PFN_vkGetPhysicalDeviceMemoryProperties2>;
  auto* const budget = static_cast<VkPhysicalDeviceMemoryBudgetPropertiesEXT*>(memory->pNext);
  // What we answer ourselves the driver, which may not know the extension, isn't asked.
  if (budget != nullptr && currentSpy->tell(*budget)) memory->pNext = nullptr;
  Real::call(device, memory);
  memory->pNext = budget;
}

template <Name kName, class Function>
PFN_vkVoidFunction spied(PFN_vkVoidFunction real) {
  Spied<kName, Function>::real = reinterpret_cast<Function>(real);
  return reinterpret_cast<PFN_vkVoidFunction>(&Spied<kName, Function>::call);
}

// The function to call in the place of `real`: itself where the lists don't have it.
PFN_vkVoidFunction inPlaceOf(std::string_view name, PFN_vkVoidFunction real) {
  if (real == nullptr) return real;
#define HONEYCOMB_SPIED(one) \
  if (name == #one) return spied<Name::one, PFN_##one>(real);
  HONEYCOMB_VULKAN_INSTANCE_FUNCTIONS(HONEYCOMB_SPIED)
  HONEYCOMB_VULKAN_DEVICE_FUNCTIONS(HONEYCOMB_SPIED)
#undef HONEYCOMB_SPIED
  return real;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instanceFunction(VkInstance instance, const char* name) {
  const InVulkan inVulkan;
  return currentSpy->ofInstance(instance, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceFunction(VkDevice device, const char* name) {
  const InVulkan inVulkan;
  return currentSpy->ofDevice(device, name);
}

// What a successful call makes or destroys. Pools take their sets and command buffers along.
int objectsOf(std::string_view function) {
  if (function.starts_with("vkCreate") || function == "vkAllocateMemory") return 1;
  if (function.starts_with("vkDestroy") || function == "vkFreeMemory") return -1;
  return 0;
}

}  // namespace

Spy::Spy(const Osd::VulkanDevice& device) : real_(device) {
  getDevice_ =
      reinterpret_cast<PFN_vkGetDeviceProcAddr>(real_.getInstanceProcAddr(real_.instance, "vkGetDeviceProcAddr"));
  currentSpy = this;
}

Spy::~Spy() {
  currentSpy = nullptr;
}

Osd::VulkanDevice Spy::device() const {
  Osd::VulkanDevice device = real_;
  device.getInstanceProcAddr = instanceFunction;
  device.getDeviceProcAddr = deviceFunction;
  return device;
}

PFN_vkVoidFunction Spy::ofInstance(VkInstance instance, const char* name) const {
  const std::string_view text = name;
  if (hidden_.contains(text)) return nullptr;
  const PFN_vkVoidFunction function = inPlaceOf(text, real_.getInstanceProcAddr(instance, name));
  if (text == "vkGetPhysicalDeviceMemoryProperties2") return reinterpret_cast<PFN_vkVoidFunction>(memoryProperties);
  const bool list = text == "vkEnumerateDeviceExtensionProperties";
  return list && extension_ ? reinterpret_cast<PFN_vkVoidFunction>(fewExtensions) : function;
}

PFN_vkVoidFunction Spy::ofDevice(VkDevice device, const char* name) const {
  return hidden_.contains(std::string_view(name)) ? nullptr : inPlaceOf(name, getDevice_(device, name));
}

void Spy::fail(std::string_view function, int call, VkResult result) {
  const std::lock_guard lock(mutex_);
  fault_ = Fault{std::string(function), call, result};
}

bool Spy::struck() const {
  const std::lock_guard lock(mutex_);
  return fault_ && fault_->call <= 0;
}

void Spy::hide(std::string_view function) {
  hidden_.emplace(function);
}

std::int64_t Spy::alive() const {
  const std::lock_guard lock(mutex_);
  return alive_;
}

int Spy::calls(std::string_view function) const {
  const std::lock_guard lock(mutex_);
  const auto found = calls_.find(function);
  return found == calls_.end() ? 0 : found->second;
}

const std::vector<std::string>& Spy::fallible() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
#define HONEYCOMB_FALLIBLE(name) \
  if (Spied<Name::name, PFN_##name>::kFallible) found.emplace_back(#name);
    HONEYCOMB_VULKAN_INSTANCE_FUNCTIONS(HONEYCOMB_FALLIBLE)
    HONEYCOMB_VULKAN_DEVICE_FUNCTIONS(HONEYCOMB_FALLIBLE)
#undef HONEYCOMB_FALLIBLE
    return found;
  }();
  return names;
}

std::optional<VkResult> Spy::called(const char* function) {
  const std::lock_guard lock(mutex_);
  ++calls_[function];
  if (!fault_ || fault_->function != function || --fault_->call != 0) return std::nullopt;
  return fault_->result;
}

void Spy::given(const VkAllocationCallbacks* allocator) {
  const std::lock_guard lock(mutex_);
  if (allocator != real_.allocator) ++strangers_;
}

int Spy::strangers() const {
  const std::lock_guard lock(mutex_);
  return strangers_;
}

void Spy::executed(const char* function) {
  const std::lock_guard lock(mutex_);
  alive_ += objectsOf(function);
}

bool Spy::tell(VkPhysicalDeviceMemoryBudgetPropertiesEXT& budget) const {
  if (!budget_) return false;
  for (std::uint32_t heap = 0; heap < VK_MAX_MEMORY_HEAPS; ++heap) {
    budget.heapUsage[heap] = budget_->used;
    budget.heapBudget[heap] = budget_->limit;
  }
  return true;
}

}  // namespace honeycomb::VulkanTests
