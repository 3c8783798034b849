#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string_view>
#include <system_error>

namespace honeycomb::Io {

/// Walks through a text of statements as OBJ has them: words between blanks, lines that end in LF, CRLF or CR, a
/// backslash before a line's end to continue it, '#' before a comment. Never reads past the text's end.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {
    if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;  // UTF-8's byte order mark
  }

  /// 1-based line of the cursor.
  std::int64_t line() const { return line_; }

  /// Moves past empty lines and comments to the first word of the next statement; false at the end of the text.
  bool nextStatement() {
    while (atStatementEnd()) {
      skipComment();
      if (at_ == end_) return false;
      passLineEnd(lineEndAt(at_));
    }
    return true;
  }

  /// Passes blanks; whether the statement has no further word.
  bool atStatementEnd() {
    passBlanks();
    return at_ == end_ || *at_ == '#' || lineEndAt(at_) != 0;
  }

  bool atWordEnd() const { return isWordEnd(at_); }

  /// The word at the cursor, without moving.
  std::string_view peekWord() const {
    const char* stop = at_;
    while (!isWordEnd(stop)) ++stop;
    return {at_, static_cast<std::size_t>(stop - at_)};
  }

  std::string_view word() {
    const std::string_view read = peekWord();
    at_ += read.size();
    return read;
  }

  bool take(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  /// Reads a whole number with an optional sign, at most up to the range of 64 bits; stays where it is if there is
  /// none.
  bool integer(std::int64_t& value) {
    const char* first = pastPlus();
    const auto [stop, error] = std::from_chars(first, end_, value);
    if (error == std::errc::invalid_argument) return false;
    if (error == std::errc::result_out_of_range) value = *first == '-' ? kLeast : kMost;
    at_ = stop;
    return true;
  }

  /// Reads a word that is a decimal number, nan or inf included; stays where it is if the word is anything else.
  /// What is too large for a double becomes infinity, what is too small zero.
  bool number(double& value) {
    const char* first = pastPlus();
    const auto [stop, error] = std::from_chars(first, end_, value);
    if (error == std::errc::invalid_argument || !isWordEnd(stop)) return false;
    if (error == std::errc::result_out_of_range) {
      value = leadingPlace({first, static_cast<std::size_t>(stop - first)}) < 0 ? 0.0 : kInfinity;
      if (*first == '-') value = -value;
    }
    at_ = stop;
    return true;
  }

  /// Passes the rest of the statement, its continued lines too.
  void skipStatement() {
    while (!atStatementEnd()) word();
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  static constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

  // The length of the line end at p, 0 where there is none.
  int lineEndAt(const char* p) const {
    if (p == end_) return 0;
    if (*p == '\n') return 1;
    if (*p != '\r') return 0;
    return p + 1 != end_ && p[1] == '\n' ? 2 : 1;
  }

  bool isContinuation(const char* p) const { return *p == '\\' && (p + 1 == end_ || lineEndAt(p + 1) != 0); }

  static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

  bool isWordEnd(const char* p) const {
    return p == end_ || isBlank(*p) || *p == '\n' || *p == '\r' || isContinuation(p);
  }

  void passLineEnd(int length) {
    at_ += length;
    line_ += length != 0 ? 1 : 0;
  }

  void passBlanks() {
    for (; at_ != end_; ++at_) {
      while (at_ != end_ && isContinuation(at_)) {
        ++at_;
        passLineEnd(lineEndAt(at_));
      }
      if (at_ == end_ || !isBlank(*at_)) return;
    }
  }

  // A backslash doesn't continue a comment: many end in the name of a Windows folder.
  void skipComment() {
    while (at_ != end_ && *at_ != '\n' && *at_ != '\r') ++at_;
  }

  // from_chars knows no plus sign.
  const char* pastPlus() const {
    const bool plus = end_ - at_ > 1 && *at_ == '+' && at_[1] != '-';
    return plus ? at_ + 1 : at_;
  }

  // The power of ten of a decimal number's first digit that isn't zero, give or take one: from_chars doesn't tell
  // overflow from underflow.
  static std::int64_t leadingPlace(std::string_view number) {
    std::int64_t place = 0;
    bool leading = false;
    bool fraction = false;
    std::size_t i = 0;
    for (; i < number.size() && number[i] != 'e' && number[i] != 'E'; ++i) {
      if (number[i] == '.') fraction = true;
      if (number[i] >= '1' && number[i] <= '9') leading = true;
      if (number[i] < '0' || number[i] > '9') continue;
      if (leading && !fraction) ++place;
      if (!leading && fraction) --place;
    }
    std::int64_t exponent = 0;
    if (i < number.size()) {
      TextCursor cursor(number.substr(i + 1));
      cursor.integer(exponent);
    }
    // Half the range: no place in a text outweighs it, and the sum can't overflow.
    return place + std::clamp(exponent, kLeast / 2, kMost / 2);
  }

  const char* at_;
  const char* end_;
  std::int64_t line_ = 1;
};

}  // namespace honeycomb::Io
