#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "far/base/result.h"

namespace honeycomb::Chain {

/// An option that some schemes have; which ones is said by the entries of schemes().
struct SchemeOption {
  /// What is written behind it; a flag has nothing.
  enum class Kind { text, number, flag };
  std::string_view name;      ///< "--tension"
  Kind kind = Kind::text;     ///< text may be a number too
  std::string_view fallback;  ///< its value when it isn't given; empty where that depends
  std::string_view help;
};

/// Options of more than one scheme.
inline constexpr SchemeOption kBoundaryOption{
    "--boundary", SchemeOption::Kind::text, "",
    "Boundary rule: brick, eq16, drop, natural, clamped (the default depends on the scheme)"};
inline constexpr SchemeOption kBoundaryWeightOption{"--sn", SchemeOption::Kind::number, "0.25",
                                                    "Weight of the neighbours in an eq16 boundary point, in [0, 1]"};
inline constexpr SchemeOption kCornersOption{"--corners", SchemeOption::Kind::text, "none",
                                             "Boundary vertices that stay where they are: none, valence2"};

/// The scheme and its options, as the user wrote them.
class SchemeOptions {
 public:
  std::string scheme = "akleman";  ///< a name, or a chain such as "akleman:1,half-box:2"

  /// Did the user write it?
  bool given(const SchemeOption& option) const;
  /// What was given, or the option's fallback.
  std::string text(const SchemeOption& option) const;
  /// Of a number.
  std::optional<double> number(const SchemeOption& option) const;

  /// Takes `text` as what the user wrote. False for a number that is none.
  bool set(const SchemeOption& option, const std::string& text);
  /// The same by the option's name, "tension" or "--tension". Errors: invalidOption for a name that no scheme has,
  /// listing those there are, and for a text that is no number where one is needed.
  Result<void> set(std::string_view name, const std::string& text);
  /// As if it had not been given.
  void reset(const SchemeOption& option) { values_.erase(option.name); }

  /// What was given, to be written by a parser; at most one of the three is set.
  struct Value {
    std::optional<std::string> text;
    std::optional<double> number;
    bool flag = false;
  };
  /// The option's place, which stays where it is as long as the options do.
  Value& value(const SchemeOption& option) { return values_[option.name]; }

 private:
  std::map<std::string_view, Value> values_;
};

}  // namespace honeycomb::Chain
