#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "far/base/result.h"

namespace honeycomb::Osd {

/// What a file of compiled pipelines is good for: one driver of one device, and one set of kernels.
struct PipelineCacheKey {
  std::uint32_t vendor = 0, device = 0;
  std::array<std::uint8_t, 16> driverUuid{};
  std::array<std::uint8_t, 16> cacheUuid{};  ///< VkPhysicalDeviceProperties::pipelineCacheUUID
  std::uint64_t kernels = 0;                 ///< contentHash of all kernels' code: our own version
  bool operator==(const PipelineCacheKey&) const = default;
};

/// FNV-1a, 64 bits, of some bytes behind others that gave `before`.
std::uint64_t contentHash(std::span<const std::byte> bytes, std::uint64_t before = 14695981039346656037U);

/// The driver's data in a file, if it is sound and made for `key`; nothing otherwise, whatever the file is.
///     | magic 8 | file version 4 | vendor 4 | device 4 | 0 4 | driver 16 | cache 16 | kernels 8 | bytes 8 | hash 8 |
///     data
/// Numbers as this machine has them: a file of another order has another magic. `data` must begin with a
/// VkPipelineCacheHeaderVersionOne of the same device.
std::optional<std::vector<std::byte>> readPipelineCache(const std::filesystem::path& file, const PipelineCacheKey& key);

/// Writes the file beside its place and renames it, so that a reader finds the old one or the new one. Makes its
/// folder. Errors: unwritable.
Result<void> writePipelineCache(const std::filesystem::path& file, const PipelineCacheKey& key,
                                std::span<const std::byte> data);

/// The file for a device's pipelines in a folder for such files, named after the device: several don't overwrite each
/// other's. Empty when there is no folder.
std::filesystem::path pipelineCacheIn(const std::filesystem::path& folder, std::string_view deviceName);

}  // namespace honeycomb::Osd
