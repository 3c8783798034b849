#include "apps/cli/bench_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>

#include "apps/cli/chain.h"
#include "apps/cli/console.h"
#include "apps/cli/formats.h"
#include "apps/cli/scheme_flags.h"

namespace honeycomb::Cli {
namespace {

constexpr std::string_view kUsualLevels = "3,4";
constexpr std::int32_t kMostSamples = 10000;
constexpr double kLongestSample = 60000;

struct NormalsTimed {
  std::string_view name;
  Bench::Normals normals;
};
constexpr std::array kNormalsTimed{NormalsTimed{"none", Bench::Normals::none},
                                   NormalsTimed{"fast", Bench::Normals::fast},
                                   NormalsTimed{"exact", Bench::Normals::exact}};

/// "3,4" -> a chain for each; a chain that says its levels itself has one.
Result<std::vector<ChainRequest>> readChains(const BenchCommand& command) {
  std::vector<ChainRequest> chains;
  const bool ownLevels = command.scheme.scheme.find(':') != std::string::npos && !command.levels;
  const std::string levels = command.levels.value_or(std::string(kUsualLevels));
  for (const std::string_view word : ownLevels ? std::vector<std::string_view>{""} : commaSeparated(levels)) {
    std::optional<std::int32_t> level;
    if (!ownLevels) {
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), level.emplace(0));
      if (error != std::errc() || end != word.data() + word.size())
        return fail(ErrorCode::invalidOption,
                    fmt::format("--levels {}: '{}' is no number; write levels as in 3,4", levels, word));
    }
    Result<ChainRequest> chain = readChain(command.scheme, level);
    if (!chain) return tl::unexpected(chain.error());
    chains.push_back(std::move(*chain));
  }
  return chains;
}

/// "a,b" -> the entries of these names, each once.
template <class Table>
auto readList(const Table& table, std::string_view option, std::string_view list)
    -> Result<std::vector<decltype(&*std::begin(table))>> {
  std::vector<decltype(&*std::begin(table))> entries;
  for (const std::string_view word : commaSeparated(list)) {
    const auto entry = choose(table, option, word);
    if (!entry) return tl::unexpected(entry.error());
    if (std::find(entries.begin(), entries.end(), *entry) == entries.end()) entries.push_back(*entry);
  }
  return entries;
}

Result<std::vector<const Bench::EvaluatorEntry*>> readEvaluators(const std::string& list) {
  if (list != "all") return readList(Bench::evaluators(), "--evaluators", list);
  std::vector<const Bench::EvaluatorEntry*> all;
  for (const Bench::EvaluatorEntry& entry : Bench::evaluators()) all.push_back(&entry);
  return all;
}

Result<void> checkSampling(const Bench::SamplingOptions& sampling) {
  if (sampling.samples < 1 || sampling.samples > kMostSamples)
    return fail(ErrorCode::invalidOption,
                fmt::format("--samples {}: give a number from 1 to {}", sampling.samples, kMostSamples));
  if (!(sampling.sampleMs >= 0 && sampling.sampleMs <= kLongestSample))
    return fail(ErrorCode::invalidOption,
                fmt::format("--sample-ms {}: give milliseconds from 0 to {}", sampling.sampleMs, kLongestSample));
  return {};
}

/// Central control vertices are at the barycentres: where else they are costs nothing in a frame.
Result<void> checkCentral(const SchemeOptions& scheme) {
  for (const SchemeOption* option : {&kCentralFileOption, &kCentralOffsetOption})
    if (scheme.given(*option))
      return fail(ErrorCode::invalidOption, fmt::format("{}: bench takes the barycentres; leave it out", option->name));
  return {};
}

Result<void> checkJson(const BenchCommand& command) {
  if (command.json.empty()) return {};
  return checkOutput(command.json, std::array{std::filesystem::path(command.input)});
}

}  // namespace

void BenchCommand::addTo(CLI::App& subcommand) {
  subcommand.add_option("IN", input, "Mesh (.obj); without it one is made");
  addMeshOptions(subcommand, *this);
  subcommand.add_option("--levels", levels, "Levels to measure, as in 3,4")->default_str(std::string(kUsualLevels));
  addSchemeFlags(subcommand, scheme);
  subcommand.add_option("--evaluators", evaluators, "Which, as in serial,tbb: all, " + names(Bench::evaluators()))
      ->capture_default_str();
  subcommand.add_option("--layouts", layouts, "Numbers of a point: " + names(Bench::layouts()))->capture_default_str();
  subcommand.add_option("--normals", normals, "Normals of the vertices besides: " + names(kNormalsTimed))
      ->capture_default_str();
  subcommand.add_option("--samples", sampling.samples, "Times that each evaluator has its turn")->capture_default_str();
  subcommand.add_option("--sample-ms", sampling.sampleMs, "Milliseconds a turn takes at least")->capture_default_str();
  subcommand.add_flag("--no-building", withoutBuilding, "Leave out what building tables takes, ours and OpenSubdiv's");
  subcommand.add_option("--json", json, "Write everything that was measured to this file");
}

Result<BenchPlan> readPlan(const BenchCommand& command) {
  if (const auto writable = checkJson(command); !writable) return tl::unexpected(writable.error());
  if (const auto sound = checkSampling(command.sampling); !sound) return tl::unexpected(sound.error());
  if (const auto central = checkCentral(command.scheme); !central) return tl::unexpected(central.error());
  Result<std::vector<ChainRequest>> chains = readChains(command);
  if (!chains) return tl::unexpected(chains.error());
  Result<std::vector<const Bench::EvaluatorEntry*>> evaluators = readEvaluators(command.evaluators);
  if (!evaluators) return tl::unexpected(evaluators.error());
  const auto layouts = readList(Bench::layouts(), "--layouts", command.layouts);
  if (!layouts) return tl::unexpected(layouts.error());
  const auto normals = choose(kNormalsTimed, "--normals", command.normals);
  if (!normals) return tl::unexpected(normals.error());
  BenchPlan plan{std::move(*chains), std::move(*evaluators), {}, (*normals)->normals};
  for (const Bench::Layout* layout : *layouts) plan.layouts.push_back(*layout);
  return plan;
}

}  // namespace honeycomb::Cli
