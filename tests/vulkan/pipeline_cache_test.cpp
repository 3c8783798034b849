// Compiled pipelines kept in a file, which may be missing, damaged, somebody else's or not to be written.
#include "osd/vulkan/pipeline_cache.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "fixture.h"
#include "runs.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using Osd::PipelineCacheKey;
using Test::randomTable;
using testing::ElementsAre;

constexpr std::size_t kHeaderBytes = 80;

class PipelineCacheTest : public VulkanTest {
 protected:
  void SetUp() override {
    VulkanTest::SetUp();
    folder = std::filesystem::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    file = folder / "pipelines.bin";
  }
  void TearDown() override {
    std::filesystem::remove_all(folder);
    VulkanTest::TearDown();
  }

  std::vector<char> content() const {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void put(const std::vector<char>& bytes) const {
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  std::vector<std::string> listing() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
    return names;
  }

  const std::vector<Far::LevelTable> levels{randomTable({.sourceCount = 300, .circulants = {{6, 60}}}, 1)};

  /// Compiles what the table needs with the cache in `file`. Returns whether it began from the file.
  bool startsFromFile() {
    auto evaluator = makeEvaluator({.pipelineCache = file});
    EXPECT_TRUE(agrees(evaluator, levels, {}, {}));
    return evaluator.pipelinesFromFile();
  }

  std::filesystem::path folder, file;
};

TEST_F(PipelineCacheTest, TheSecondStartIsFromTheFile) {
  EXPECT_FALSE(startsFromFile());
  EXPECT_THAT(listing(), ElementsAre("pipelines.bin"));
  const std::vector<char> written = content();
  EXPECT_GE(written.size(), kHeaderBytes + sizeof(VkPipelineCacheHeaderVersionOne));
  EXPECT_TRUE(startsFromFile());
  EXPECT_EQ(content(), written);
}

TEST_F(PipelineCacheTest, MakesItsFolder) {
  file = folder / "a" / "b" / "pipelines.bin";
  EXPECT_FALSE(startsFromFile());
  EXPECT_TRUE(startsFromFile());
}

TEST_F(PipelineCacheTest, AFileThatIsDamagedAnywhereIsIgnoredAndWrittenAnew) {
  startsFromFile();
  const std::vector<char> good = content();
  for (std::size_t place = 0; place < kHeaderBytes + sizeof(VkPipelineCacheHeaderVersionOne); place += 3) {
    std::vector<char> bad = good;
    bad[place] = static_cast<char>(bad[place] ^ 0x10);
    put(bad);
    EXPECT_FALSE(startsFromFile()) << "byte " << place;
    EXPECT_EQ(content(), good) << "byte " << place;
  }
}

TEST_F(PipelineCacheTest, AFileOfAnotherLengthIsIgnoredAndWrittenAnew) {
  startsFromFile();
  const std::vector<char> good = content();
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, kHeaderBytes, good.size() - 1, good.size() + 1}) {
    std::vector<char> bad = good;
    bad.resize(size);
    put(bad);
    EXPECT_FALSE(startsFromFile()) << size << " bytes";
    EXPECT_EQ(content(), good) << size << " bytes";
  }
}

TEST_F(PipelineCacheTest, WhereNothingCanBeWrittenEvaluatorsWorkAndSayItWhenAsked) {
  std::filesystem::create_directories(file / "in the way");
  auto evaluator = makeEvaluator({.pipelineCache = file});
  EXPECT_TRUE(agrees(evaluator, levels, {}, {}));
  const auto refused = evaluator.savePipelines();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unwritable);
  EXPECT_THAT(refused.error().message, testing::HasSubstr(file.string()));
  EXPECT_THAT(listing(), ElementsAre("pipelines.bin"));
  file = file / "in the way" / "";
}

TEST_F(PipelineCacheTest, WithoutAFileThereIsNone) {
  auto evaluator = makeEvaluator();
  EXPECT_TRUE(agrees(evaluator, levels, {}, {}));
  EXPECT_FALSE(evaluator.pipelinesFromFile());
  EXPECT_TRUE(evaluator.savePipelines());
  EXPECT_THAT(listing(), ElementsAre());
}

/// Data that begin as the key's driver begins them.
std::vector<std::byte> driverData(const PipelineCacheKey& key, std::uint32_t headerSize = 32,
                                  VkPipelineCacheHeaderVersion version = VK_PIPELINE_CACHE_HEADER_VERSION_ONE) {
  VkPipelineCacheHeaderVersionOne header{headerSize, version, key.vendor, key.device, {}};
  std::ranges::copy(key.cacheUuid, header.pipelineCacheUUID);
  const auto bytes = std::as_bytes(std::span(&header, 1));
  std::vector<std::byte> data(bytes.begin(), bytes.end());
  data.resize(100, std::byte{7});
  return data;
}

PipelineCacheKey someKey() {
  PipelineCacheKey key{.vendor = 1, .device = 2, .driverUuid = {}, .cacheUuid = {}, .kernels = 5};
  key.driverUuid[15] = 3;
  key.cacheUuid[0] = 4;
  return key;
}

TEST_F(PipelineCacheTest, AFileIsGoodForItsOwnKeyAlone) {
  const PipelineCacheKey key = someKey();
  const auto data = driverData(key);
  ASSERT_TRUE(writePipelineCache(file, key, data));
  EXPECT_EQ(readPipelineCache(file, key), data);
  std::vector<PipelineCacheKey> others(5, key);
  ++others[0].vendor;
  ++others[1].device;
  ++others[2].driverUuid[15];
  ++others[3].cacheUuid[0];
  ++others[4].kernels;
  for (const PipelineCacheKey& other : others) EXPECT_FALSE(readPipelineCache(file, other));
}

TEST_F(PipelineCacheTest, TheDriversOwnHeaderIsCheckedAsWell) {
  const PipelineCacheKey key = someKey();
  PipelineCacheKey foreign = key;
  ++foreign.cacheUuid[3];
  const auto other = static_cast<VkPipelineCacheHeaderVersion>(2);
  for (const auto& data : {driverData(key, 31), driverData(key, 101), driverData(key, 32, other), driverData(foreign),
                           std::vector<std::byte>(31), std::vector<std::byte>()}) {
    ASSERT_TRUE(writePipelineCache(file, key, data));
    EXPECT_FALSE(readPipelineCache(file, key));
  }
}

TEST(PipelineCacheName, KeepsDevicesApartAndIsAFileName) {
  const auto name = [](std::string_view device) { return Osd::pipelineCacheIn("cache", device); };
  EXPECT_EQ(name("llvmpipe (LLVM 15.0.6, 256 bits)"), "cache/pipelines-llvmpipe-LLVM-15-0-6-256-bits-.bin");
  EXPECT_EQ(name("../../etc"), "cache/pipelines-etc.bin");
  EXPECT_EQ(Osd::pipelineCacheIn({}, "llvmpipe"), "");
}

}  // namespace
}  // namespace honeycomb::VulkanTests
