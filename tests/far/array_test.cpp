#include "far/base/array.h"

#include <gtest/gtest.h>

#include <memory>
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

}  // namespace
}  // namespace honeycomb::Test
