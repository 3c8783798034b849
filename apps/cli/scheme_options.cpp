#include "apps/cli/scheme_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "apps/cli/choice.h"
#include "apps/cli/schemes.h"

namespace honeycomb::Cli {

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

void SchemeOptions::add(CLI::App& subcommand, const SchemeOption& option) {
  if (values_.contains(option.name)) return;
  Value& value = values_[option.name];
  const std::string name(option.name), help = fmt::format("{} [{}]", option.help, ownersOf(option));
  if (option.kind == SchemeOption::Kind::flag) {
    subcommand.add_flag(name, value.flag, help);
    return;
  }
  CLI::Option* added = option.kind == SchemeOption::Kind::number ? subcommand.add_option(name, value.number, help)
                                                                 : subcommand.add_option(name, value.text, help);
  if (!option.fallback.empty()) added->default_str(std::string(option.fallback));
}

void SchemeOptions::addTo(CLI::App& subcommand) {
  subcommand
      .add_option("--scheme", scheme,
                  "Subdivision scheme: " + names(schemes()) + "; or a chain with levels, as akleman:1,half-box:2")
      ->capture_default_str();
  for (const SchemeEntry& entry : schemes())
    for (const SchemeOption* option : entry.options) add(subcommand, *option);
}

}  // namespace honeycomb::Cli
