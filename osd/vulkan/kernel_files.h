#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "far/base/result.h"
#include "osd/vulkan/kernels.h"

namespace honeycomb::Osd {

/// A kernel whose code has another content now.
struct ChangedKernel {
  Kernel kernel = Kernel::circulant;
  std::vector<std::uint32_t> code;  ///< SPIR-V
};

/// Watches a folder of kernels while they are tuned: circulant.comp.spv and so on, under the names of shaders/, as
/// `glslangValidator --target-env vulkan1.2 -o circulant.comp.spv circulant.comp` writes them. A kernel without a file
/// is the built-in one. Builds with HONEYCOMB_KERNEL_RELOAD only (debug and sanitizers): others refuse a folder.
class KernelFiles {
 public:
  /// Watches nothing.
  KernelFiles() = default;
  /// Errors: unsupported for a folder in builds without.
  static Result<KernelFiles> watch(const std::filesystem::path& folder);

  /// Kernels whose files are new or have another time than when they were last looked at. Errors: invalidFile for one
  /// that isn't whole SPIR-V; it is tried again when its time changes.
  Result<std::vector<ChangedKernel>> changed();

 private:
  std::filesystem::path folder_;
  std::array<std::filesystem::file_time_type, kKernelCount> seen_{};
};

}  // namespace honeycomb::Osd
