#include "osd/vulkan/pipeline_cache_file.h"

#include <fmt/format.h>
#include <vulkan/vulkan_core.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

namespace honeycomb::Osd {

namespace {

constexpr std::uint64_t kCacheMagic = 0x0a31434b50434852;  // "RHCPKC1\n", little-endian
constexpr std::uint32_t kFileVersion = 1;
/// Drivers' data for our kernels are some hundred KB: what is larger isn't ours.
constexpr std::uint64_t kMostBytes = std::uint64_t{256} << 20U;

/// The first bytes of a file.
struct FileHeader {
  std::uint64_t magic = kCacheMagic;
  std::uint32_t version = kFileVersion;
  std::uint32_t vendor = 0;
  std::uint32_t device = 0;
  std::uint32_t reserved = 0;
  std::array<std::uint8_t, 16> driverUuid{};
  std::array<std::uint8_t, 16> cacheUuid{};
  std::uint64_t kernels = 0;
  std::uint64_t bytes = 0;  ///< of the data
  std::uint64_t hash = 0;   ///< of the data
  bool operator==(const FileHeader&) const = default;
};
static_assert(sizeof(FileHeader) == 80, "no padding: the header is written as it lies in memory");

/// The header that a file of these data has.
FileHeader headerOf(const PipelineCacheKey& key, std::span<const std::byte> data) {
  FileHeader header;
  header.vendor = key.vendor;
  header.device = key.device;
  header.driverUuid = key.driverUuid;
  header.cacheUuid = key.cacheUuid;
  header.kernels = key.kernels;
  header.bytes = data.size();
  header.hash = contentHash(data);
  return header;
}

/// VkPipelineCacheHeaderVersionOne with a number for its enum, of which not every number is a value.
struct DriverHeader {
  std::uint32_t headerSize = 0, headerVersion = 0, vendor = 0, device = 0;
  std::array<std::uint8_t, VK_UUID_SIZE> cacheUuid{};
};
static_assert(sizeof(DriverHeader) == sizeof(VkPipelineCacheHeaderVersionOne));

/// Drivers should check this themselves; some crash instead.
bool startsWithDriverHeader(std::span<const std::byte> data, const PipelineCacheKey& key) {
  DriverHeader header;
  if (data.size() < sizeof(header)) return false;
  std::memcpy(&header, data.data(), sizeof(header));
  return header.headerSize >= sizeof(header) && header.headerSize <= data.size() &&
         header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE && header.vendor == key.vendor &&
         header.device == key.device && header.cacheUuid == key.cacheUuid;
}

bool readBytes(std::ifstream& stream, void* target, std::size_t bytes) {
  stream.read(static_cast<char*>(target), static_cast<std::streamsize>(bytes));
  return stream.good();
}

/// A name beside `file` that nobody else is writing to.
std::filesystem::path besides(const std::filesystem::path& file) {
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  std::filesystem::path beside = file;
  beside += fmt::format(".{:x}{:x}.part", now, reinterpret_cast<std::uintptr_t>(&beside));
  return beside;
}

}  // namespace

std::uint64_t contentHash(std::span<const std::byte> bytes, std::uint64_t before) {
  std::uint64_t hash = before;
  for (const std::byte byte : bytes) hash = (hash ^ std::to_integer<std::uint64_t>(byte)) * 1099511628211U;
  return hash;
}

std::optional<std::vector<std::byte>> readPipelineCache(const std::filesystem::path& file,
                                                        const PipelineCacheKey& key) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) || error) return std::nullopt;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  FileHeader header;
  std::ifstream stream(file, std::ios::binary);
  if (error || size > kMostBytes || !readBytes(stream, &header, sizeof(header))) return std::nullopt;
  if (header.magic != kCacheMagic || header.bytes != size - sizeof(header)) return std::nullopt;
  std::vector<std::byte> data(static_cast<std::size_t>(header.bytes));
  if (!readBytes(stream, data.data(), data.size())) return std::nullopt;
  if (header != headerOf(key, data) || !startsWithDriverHeader(data, key)) return std::nullopt;
  return data;
}

Result<void> writePipelineCache(const std::filesystem::path& file, const PipelineCacheKey& key,
                                std::span<const std::byte> data) {
  const FileHeader header = headerOf(key, data);
  std::error_code error;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
  const std::filesystem::path beside = besides(file);
  std::ofstream stream(beside, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(&header), sizeof(header));
  stream.write(reinterpret_cast<const char*>(data.data()), static_cast<std::streamsize>(data.size()));
  stream.close();
  if (stream) std::filesystem::rename(beside, file, error);
  if (stream && !error) return {};
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  return fail(
      ErrorCode::unwritable,
      fmt::format("{}: the compiled pipelines can't be written there; choose another file, or none", file.string()));
}

std::filesystem::path pipelineCacheIn(const std::filesystem::path& folder, std::string_view deviceName) {
  if (folder.empty()) return {};
  std::string name = "pipelines-";
  for (const char c : deviceName) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (plain) name += c;
    if (!plain && name.back() != '-') name += '-';
  }
  return folder / (name + ".bin");
}

}  // namespace honeycomb::Osd
