#include "osd/vulkan/kernel_files.h"

namespace honeycomb::Osd {

Result<KernelFiles> KernelFiles::watch(const std::filesystem::path& folder) {
  if (folder.empty()) return KernelFiles();
  return fail(
      ErrorCode::unsupported,
      "this build keeps its kernels: configure a debug build, or -DHONEYCOMB_KERNEL_RELOAD=ON, to load them from "
      "a folder");
}

Result<std::vector<ChangedKernel>> KernelFiles::changed() {
  return std::vector<ChangedKernel>();
}

}  // namespace honeycomb::Osd
