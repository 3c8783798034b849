#include "far/base/array.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace honeycomb::Test {
namespace {

/// Numbers of somebody else's, and an array in their place.
struct Borrowed {
  std::shared_ptr<std::vector<int>> keeper = std::make_shared<std::vector<int>>(std::vector<int>{3, 1, 4});
  Array<int> array = Array<int>::inPlaceOf(*keeper, keeper);
};

TEST(ArrayInPlace, IsTheMemoryOfItsKeeper) {
  const Borrowed borrowed;
  EXPECT_TRUE(borrowed.array.inPlace());
  EXPECT_EQ(std::as_const(borrowed.array).data(), borrowed.keeper->data());
  EXPECT_EQ(borrowed.array, (Array<int>{3, 1, 4}));
}

TEST(ArrayInPlace, KeepsItsKeeperWhereItIsMoved) {
  Borrowed borrowed;
  const int* const numbers = borrowed.keeper->data();
  const std::weak_ptr<std::vector<int>> keeper = borrowed.keeper;
  borrowed.keeper.reset();
  {
    const Array<int> moved = std::move(borrowed.array);
    EXPECT_EQ(moved.data(), numbers);
    EXPECT_FALSE(keeper.expired());
  }
  EXPECT_TRUE(keeper.expired());
}

TEST(ArrayInPlace, IsCopiedToMemoryOfItsOwn) {
  const Borrowed borrowed;
  Array<int> copy = borrowed.array;
  EXPECT_FALSE(copy.inPlace());
  copy[0] = 9;
  EXPECT_EQ(borrowed.keeper->front(), 3);
}

TEST(ArrayInPlace, TakesACopyBeforeItGrows) {
  Borrowed borrowed;
  borrowed.array.push_back(1);
  EXPECT_FALSE(borrowed.array.inPlace());
  EXPECT_EQ(borrowed.array, (Array<int>{3, 1, 4, 1}));
  EXPECT_EQ(borrowed.keeper->size(), 3U);
}

TEST(ArrayInPlace, GivesWayToWhatIsAssigned) {
  Borrowed borrowed;
  const std::vector<int> other{2, 7};
  borrowed.array.assign(other.begin(), other.end());
  EXPECT_FALSE(borrowed.array.inPlace());
  EXPECT_EQ(borrowed.array, (Array<int>{2, 7}));
  EXPECT_EQ(borrowed.keeper->front(), 3);
}

// Memory that nobody had before, from the begin of a huge page on.
class FreshMemory {
 public:
  explicit FreshMemory(std::size_t pages)
      : bytes_((pages + 1) * kHugePage),
        memory_(::mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {}
  FreshMemory(const FreshMemory&) = delete;
  FreshMemory& operator=(const FreshMemory&) = delete;
  ~FreshMemory() { ::munmap(memory_, bytes_); }

  std::byte* begin() const {
    const auto address = reinterpret_cast<std::uintptr_t>(memory_);
    return static_cast<std::byte*>(memory_) + (kHugePage - address % kHugePage) % kHugePage;
  }

 private:
  std::size_t bytes_;
  void* memory_;
};

// Does the process's map say so of the mapping that the byte lies in?
bool wantsHugePage(const std::byte* byte) {
  const auto address = reinterpret_cast<std::uintptr_t>(byte);
  std::ifstream map("/proc/self/smaps");
  bool inside = false;
  for (std::string line; std::getline(map, line);) {
    std::uintptr_t begin = 0, end = 0;
    char dash = 0;
    std::istringstream range(line);
    if (range >> std::hex >> begin >> dash >> end && dash == '-') inside = begin <= address && address < end;
    if (inside && line.starts_with("VmFlags:")) return line.find(" hg") != std::string::npos;
  }
  return false;
}

class HugePagesTest : public testing::Test {
  void SetUp() override {
    if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage/enabled")) GTEST_SKIP() << "no such pages";
    const FreshMemory memory(1);
    ::madvise(memory.begin(), kHugePage, MADV_HUGEPAGE);
    if (!wantsHugePage(memory.begin())) GTEST_SKIP() << "advice is not kept, as in qemu";
  }
};

TEST_F(HugePagesTest, AreWantedWhereWholeOnesLieWithin) {
  const FreshMemory memory(4);
  wantHugePages(memory.begin() + 1, 3 * kHugePage);
  EXPECT_FALSE(wantsHugePage(memory.begin()));
  EXPECT_TRUE(wantsHugePage(memory.begin() + kHugePage));
  EXPECT_TRUE(wantsHugePage(memory.begin() + 3 * kHugePage - 1));
  EXPECT_FALSE(wantsHugePage(memory.begin() + 3 * kHugePage));
}

TEST_F(HugePagesTest, AreNotWantedOfBlocksThatHoldNone) {
  const FreshMemory memory(3);
  wantHugePages(memory.begin() + 1, 2 * kHugePage - 2);
  wantHugePages(memory.begin(), 0);
  for (std::size_t page = 0; page < 3; ++page) EXPECT_FALSE(wantsHugePage(memory.begin() + page * kHugePage));
}

}  // namespace
}  // namespace honeycomb::Test
