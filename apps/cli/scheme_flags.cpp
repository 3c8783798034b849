#include "apps/cli/scheme_flags.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

namespace honeycomb::Cli {
namespace {

void addFlag(CLI::App& subcommand, const SchemeOption& option, SchemeOptions::Value& value) {
  const std::string name(option.name), help = fmt::format("{} [{}]", option.help, ownersOf(option));
  if (option.kind == SchemeOption::Kind::flag) {
    subcommand.add_flag(name, value.flag, help);
    return;
  }
  CLI::Option* added = option.kind == SchemeOption::Kind::number ? subcommand.add_option(name, value.number, help)
                                                                 : subcommand.add_option(name, value.text, help);
  if (!option.fallback.empty()) added->default_str(std::string(option.fallback));
}

}  // namespace

void addSchemeFlags(CLI::App& subcommand, SchemeOptions& options) {
  subcommand
      .add_option("--scheme", options.scheme,
                  "Subdivision scheme: " + names(schemes()) + "; or a chain with levels, as akleman:1,half-box:2")
      ->capture_default_str();
  for (const SchemeOption* option : allOptions()) addFlag(subcommand, *option, options.value(*option));
}

}  // namespace honeycomb::Cli
