#include "io/text_cursor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace honeycomb::Io {
namespace {

std::optional<double> number(std::string_view word) {
  TextCursor cursor(word);
  double value = 0;
  if (!cursor.number(value)) return std::nullopt;
  EXPECT_TRUE(cursor.atWordEnd());
  return value;
}

std::optional<std::int64_t> integer(std::string_view word) {
  TextCursor cursor(word);
  std::int64_t value = 0;
  if (!cursor.integer(value)) return std::nullopt;
  return value;
}

TEST(TextCursor, ReadsDecimalNumbersInEveryNotation) {
  EXPECT_EQ(number("1"), 1.0);
  EXPECT_EQ(number("+1.5"), 1.5);
  EXPECT_EQ(number("-1."), -1.0);
  EXPECT_EQ(number(".5"), 0.5);
  EXPECT_EQ(number("1e-3"), 1e-3);
  EXPECT_EQ(number("+2.5E+2"), 250.0);
  EXPECT_EQ(number("0.1"), 0.1);
  EXPECT_EQ(number("5e-324"), 5e-324);
  EXPECT_TRUE(std::signbit(*number("-0")));
}

TEST(TextCursor, TellsOverflowFromUnderflow) {
  EXPECT_EQ(number("1e400"), HUGE_VAL);
  EXPECT_EQ(number("-1e400"), -HUGE_VAL);
  EXPECT_EQ(number("1e99999999999999999999"), HUGE_VAL);
  EXPECT_EQ(number("1" + std::string(400, '0')), HUGE_VAL);
  EXPECT_EQ(number("1" + std::string(400, '0') + "e-5"), HUGE_VAL);
  EXPECT_EQ(number("1e-400"), 0.0);
  EXPECT_EQ(number("1e-99999999999999999999"), 0.0);
  EXPECT_EQ(number("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(number("0." + std::string(400, '0') + "1e+5"), 0.0);
  EXPECT_TRUE(std::signbit(*number("-1e-400")));
}

TEST(TextCursor, ReadsNanAndInfinityAsSuch) {
  EXPECT_TRUE(std::isnan(*number("nan")));
  EXPECT_TRUE(std::isnan(*number("-nan(ind)")));
  EXPECT_EQ(number("inf"), HUGE_VAL);
  EXPECT_EQ(number("-INFINITY"), -HUGE_VAL);
}

TEST(TextCursor, RefusesWordsThatOnlyBeginLikeNumbers) {
  for (const char* word : {"1e", "1.2.3", "1,5", "0x10", "1.#INF", "--1", "+-1", "-+1", "+", "-", ".", "e5", "abc"}) {
    EXPECT_EQ(number(word), std::nullopt) << word;
  }
}

TEST(TextCursor, SaturatesWholeNumbersPast64Bits) {
  EXPECT_EQ(integer("+7"), 7);
  EXPECT_EQ(integer("-7"), -7);
  EXPECT_EQ(integer("99999999999999999999"), INT64_MAX);
  EXPECT_EQ(integer("-99999999999999999999"), INT64_MIN);
  EXPECT_EQ(integer("+-7"), std::nullopt);
  EXPECT_EQ(integer("x"), std::nullopt);
}

TEST(TextCursor, CountsLinesAcrossAllLineEnds) {
  TextCursor cursor("a\nb\r\nc\rd\\\r\ne\n\n# f\ng");
  std::vector<std::pair<std::string_view, std::int64_t>> found;
  while (cursor.nextStatement()) {
    found.emplace_back(cursor.peekWord(), cursor.line());
    cursor.skipStatement();
  }
  const std::vector<std::pair<std::string_view, std::int64_t>> expected{
      {"a", 1}, {"b", 2}, {"c", 3}, {"d", 4}, {"g", 8}};
  EXPECT_EQ(found, expected);
}

TEST(TextCursor, EmptyTextHasNoStatement) {
  EXPECT_FALSE(TextCursor(std::string_view()).nextStatement());
}

}  // namespace
}  // namespace honeycomb::Io
