#include <algorithm>

#include "apps/cli/bench_machine.h"
#include "apps/cli/bench_report.h"
#include "apps/cli/info_machine.h"
#include "apps/cli/json_text.h"
#include "apps/cli/memory.h"
#include "far/base/parallel.h"

namespace honeycomb::Cli {
namespace {

using Json = nlohmann::ordered_json;

/// A device's threads are its own business: 0.
int threadsOf(Bench::Threads threads) {
  if (threads == Bench::Threads::device) return 0;
  return threads == Bench::Threads::one ? 1 : Parallel::threadCount();
}

Json spreadJson(const Bench::Spread& spread) {
  return {{"min", spread.min}, {"median", spread.median}, {"max", spread.max}};
}

Json machineOf() {
  Json caches = Json::array();
  for (const Cache& cache : processorCaches())
    caches.push_back({{"level", cache.level}, {"type", cache.type}, {"bytes", cache.bytes}});
  return {{"processor", processorName()},      {"threads", Parallel::threadCount()}, {"caches", caches},
          {"memory_bytes", availableMemory()}, {"compiler", compilerName()},         {"flags", compilerFlags()},
          {"version", HONEYCOMB_VERSION}};
}

/// The limits of the largest output on all threads, and all that were measured.
Json limitsJson(const BenchReport& report) {
  Json measured = Json::array();
  Json json = Json::object();
  std::int64_t largest = -1;
  for (const BenchedLayout& layout : report.layouts) {
    const bool larger = layout.outputBytes > largest;
    largest = std::max(largest, layout.outputBytes);
    for (const Bench::Limit& limit : layout.comparisons.limits) {
      measured.push_back({{"limit", limit.name},
                          {"level", layout.level},
                          {"layout", layout.layout.name},
                          {"threads", threadsOf(limit.threads)},
                          {"bytes", limit.bytes},
                          {"gb_s", spreadJson(limit.gbPerSecond)}});
      if (larger && limit.threads == Bench::Threads::all) json[std::string(limit.name)] = limit.gbPerSecond.median;
    }
  }
  json["measured"] = measured;
  return json;
}

/// What identifies the runs of a layout.
Json layoutJson(const BenchReport& report, const BenchedLayout& layout, std::string_view evaluator) {
  return {{"evaluator", evaluator},
          {"scheme", report.command.scheme.scheme},
          {"level", layout.level},
          {"mesh", report.mesh},
          {"control_faces", report.controlFaces},
          {"layout", layout.layout.name},
          {"normals", report.command.normals}};
}

/// By a device's own clock.
Json levelsJson(const Bench::Run& run) {
  Json levels = Json::array();
  for (const Bench::LevelSpread& level : run.levels)
    levels.push_back(
        {{"level", level.level}, {"what", level.limits ? "limits" : "points"}, {"ms", spreadJson(level.ms)}});
  return levels;
}

Json runsJson(const BenchReport& report) {
  Json runs = Json::array();
  for (const BenchedLayout& layout : report.layouts) {
    for (const Bench::Run& run : layout.comparisons.runs) {
      Json json = layoutJson(report, layout, run.evaluator);
      json.update({{"refined_vertices", run.vertices},
                   {"threads", threadsOf(run.threads)},
                   {"ns_per_vertex", spreadJson(run.nsPerVertex)},
                   {"cpu_ns_per_vertex", spreadJson(run.cpuNsPerVertex)},
                   {"output_bytes_per_vertex", layout.layout.desc.stride * static_cast<int>(sizeof(float))},
                   {"samples", report.command.sampling.samples},
                   {"frames", run.frames},
                   {"difference", run.difference},
                   {"table_bytes", run.tableBytes},
                   {"build_ms", run.buildMs}});
      if (!run.levels.empty()) json["levels"] = levelsJson(run);
      if (run.host)
        json["host_us"] = {{"record", spreadJson(run.host->recordUs)}, {"submit", spreadJson(run.host->submitUs)}};
      runs.push_back(std::move(json));
    }
  }
  return runs;
}

Json skippedJson(const BenchReport& report) {
  Json skipped = Json::array();
  for (const BenchedLayout& layout : report.layouts) {
    for (const Bench::Skip& skip : layout.comparisons.skips) {
      Json json = layoutJson(report, layout, skip.evaluator);
      json["why"] = skip.why;
      skipped.push_back(std::move(json));
    }
  }
  return skipped;
}

Json buildJson(const BenchReport& report) {
  Json builds = Json::array();
  for (const BuiltLevel& level : report.builds) {
    for (const Bench::BuildTime& time : level.times) {
      builds.push_back({{"library", time.library},
                        {"what", time.what},
                        {"scheme", report.command.scheme.scheme},
                        {"level", level.level},
                        {"mesh", report.mesh},
                        {"control_faces", report.controlFaces},
                        {"refined_vertices", time.vertices},
                        {"threads", time.library == "honeycomb" ? Parallel::threadCount() : 1},
                        {"ns_per_vertex", spreadJson(time.nsPerVertex)},
                        {"bytes", time.bytes}});
    }
  }
  return builds;
}

}  // namespace

std::string benchJson(const BenchReport& report) {
  return jsonText({{"machine", machineOf()},
                   {"limits", limitsJson(report)},
                   {"runs", runsJson(report)},
                   {"skipped", skippedJson(report)},
                   {"build", buildJson(report)}});
}

}  // namespace honeycomb::Cli
