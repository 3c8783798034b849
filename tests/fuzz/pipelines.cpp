#include <algorithm>
#include <cstring>
#include <vector>

#include "osd/vulkan/pipeline_cache_file.h"
#include "tests/fuzz/memory_file.h"

namespace honeycomb::Fuzz {
namespace {

// The file's layout (osd/vulkan/pipeline_cache_file.h).
constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kBytesAt = 64;
constexpr std::size_t kHashAt = 72;

/// Of the seeds.
Osd::PipelineCacheKey key() {
  Osd::PipelineCacheKey key{.vendor = 0x10005, .device = 7, .kernels = 0x0123456789abcdef};
  key.driverUuid.fill(0x11);
  key.cacheUuid.fill(0x22);
  return key;
}

/// The file with the size and the hash of its data put right.
std::vector<std::uint8_t> repaired(Bytes bytes) {
  std::vector<std::uint8_t> file(bytes.begin(), bytes.end());
  if (file.size() < kHeaderBytes) return file;
  const Bytes data = Bytes(file).subspan(kHeaderBytes);
  const std::uint64_t count = data.size();
  const std::uint64_t hash = Osd::contentHash(std::as_bytes(data));
  std::memcpy(file.data() + kBytesAt, &count, sizeof(count));
  std::memcpy(file.data() + kHashAt, &hash, sizeof(hash));
  return file;
}

bool read(Bytes bytes) {
  const MemoryFile file(bytes);
  const auto data = Osd::readPipelineCache(file.path(), key());
  if (!data) return false;
  expect(std::ranges::equal(*data, std::as_bytes(bytes.subspan(kHeaderBytes))), "the data are the file's");
  expect(data->size() >= 32, "a driver's header is there");
  std::uint32_t header[4];
  std::memcpy(header, data->data(), sizeof(header));
  expect(header[0] >= 32 && header[0] <= data->size(), "the driver's header ends within the data");
  expect(header[2] == key().vendor && header[3] == key().device, "the data are of the same device");
  return true;
}

}  // namespace

bool pipelines(Bytes bytes) {
  const bool sound = read(bytes);
  const bool taken = read(repaired(bytes));
  expect(taken || !sound, "what was right stays right");
  return taken;
}

}  // namespace honeycomb::Fuzz
