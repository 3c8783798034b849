#include "chain/scheme_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "chain/schemes.h"

namespace honeycomb::Chain {

bool SchemeOptions::given(const SchemeOption& option) const {
  const auto found = values_.find(option.name);
  return found != values_.end() && (found->second.text || found->second.number || found->second.flag);
}

std::string SchemeOptions::text(const SchemeOption& option) const {
  const auto found = values_.find(option.name);
  if (found == values_.end()) return std::string(option.fallback);
  if (found->second.number) return fmt::format("{}", *found->second.number);
  return found->second.text.value_or(std::string(option.fallback));
}

std::optional<double> SchemeOptions::number(const SchemeOption& option) const {
  const auto found = values_.find(option.name);
  return found == values_.end() ? std::nullopt : found->second.number;
}

bool SchemeOptions::set(const SchemeOption& option, const std::string& text) {
  Value value;
  if (option.kind == SchemeOption::Kind::number) {
    value.number = parseNumber(text);
    if (!value.number) return false;
  } else if (option.kind == SchemeOption::Kind::flag) {
    value.flag = true;
  } else {
    value.text = text;
  }
  values_[option.name] = value;
  return true;
}

Result<void> SchemeOptions::set(std::string_view name, const std::string& text) {
  const std::string_view bare = name.substr(name.starts_with("--") ? 2 : 0);
  const std::vector<const SchemeOption*> known = allOptions();
  const auto found = std::find_if(known.begin(), known.end(),
                                  [&](const SchemeOption* option) { return option->name.substr(2) == bare; });
  if (found == known.end()) {
    std::string list;
    for (const SchemeOption* option : known) list += fmt::format("{}{}", list.empty() ? "" : ", ", option->name);
    return fail(ErrorCode::invalidOption,
                fmt::format("--{}: no scheme has such an option; choose from: {}", bare, list));
  }
  if (set(**found, text)) return {};
  return fail(ErrorCode::invalidOption, fmt::format("--{}: '{}' is no number; give one", bare, text));
}

}  // namespace honeycomb::Chain
