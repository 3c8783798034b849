#include "apps/cli/bench_report.h"

#include <fmt/format.h>

#include <iterator>

#include "apps/cli/console.h"
#include "apps/cli/info_machine.h"
#include "far/base/parallel.h"

namespace honeycomb::Cli {
namespace {

std::string threadsText(Bench::Threads threads) {
  if (threads == Bench::Threads::device) return "device";
  return counted(threads == Bench::Threads::one ? 1 : Parallel::threadCount(), "thread");
}

std::string differenceText(double difference) {
  return difference == 0 ? "same bits" : fmt::format("{:.1e}", difference);
}

/// What each level took, by a device's own clock; empty where none tells.
std::string levelsText(const Bench::Run& run) {
  std::string text;
  for (const Bench::LevelSpread& level : run.levels)
    fmt::format_to(std::back_inserter(text), "{} {} {:.3f} ms", text.empty() ? "    of which" : ",",
                   level.limits ? "limits" : fmt::format("level {}", level.level), level.ms.median);
  return text.empty() ? text : text + "\n";
}

std::string hostText(const Bench::Run& run) {
  if (!run.host) return "";
  return fmt::format("    of the calling thread {:.1f} us to record, {:.1f} us to submit\n", run.host->recordUs.median,
                     run.host->submitUs.median);
}

/// GB/s of output from ns per vertex.
double rate(const BenchedLayout& measured, const Bench::Run& run) {
  const double bytes = static_cast<double>(measured.layout.desc.stride) * sizeof(float);
  return bytes / run.nsPerVertex.median;
}

}  // namespace

std::string benchHeading(const BenchReport& report) {
  return fmt::format("{}: {} faces, {} vertices; {} with {} on {}\n", report.mesh, grouped(report.controlFaces),
                     grouped(report.controlVertices), report.command.scheme.scheme,
                     counted(Parallel::threadCount(), "thread"), processorName());
}

std::string benchTable(const BenchedLayout& measured) {
  std::string text = fmt::format("\n{:<32} {:>11} {:>10} {:>23} {:>8} {:>7} {:>9} {:>9}  {}\n",
                                 fmt::format("level {}, {}", measured.level, measured.layout.name), "vertices",
                                 "ns/vertex", "(least - most)", "cpu ns", "GB/s", "build ms", "tables", "difference");
  for (const Bench::Run& run : measured.comparisons.runs) {
    fmt::format_to(std::back_inserter(text),
                   "  {:<20} {:<9} {:>11} {:>10.3f} {:>10.3f} - {:<10.3f} {:>8.3f} {:>7.2f} {:>9.1f} {:>9}  {}\n",
                   run.evaluator, threadsText(run.threads), grouped(run.vertices), run.nsPerVertex.median,
                   run.nsPerVertex.min, run.nsPerVertex.max, run.cpuNsPerVertex.median, rate(measured, run),
                   run.buildMs, humanBytes(run.tableBytes), differenceText(run.difference));
    text += levelsText(run);
    text += hostText(run);
  }
  for (const Bench::Skip& skip : measured.comparisons.skips)
    fmt::format_to(std::back_inserter(text), "  {:<20} skipped: {}\n", skip.evaluator, skip.why);
  for (const Bench::Limit& limit : measured.comparisons.limits)
    fmt::format_to(std::back_inserter(text), "  {:<20} {:<9} {:>64.2f}\n", limit.name, threadsText(limit.threads),
                   limit.gbPerSecond.median);
  return text;
}

std::string benchTable(const BuiltLevel& built) {
  std::string text = fmt::format("\nlevel {}, building\n", built.level);
  for (const Bench::BuildTime& time : built.times) {
    fmt::format_to(std::back_inserter(text), "  {:<11} {:<18} {:>11} {:>10.3f} {:>10.3f} - {:<10.3f} {:>36}\n",
                   time.library, time.what, grouped(time.vertices), time.nsPerVertex.median, time.nsPerVertex.min,
                   time.nsPerVertex.max, time.bytes == 0 ? "" : humanBytes(time.bytes));
  }
  return text;
}

}  // namespace honeycomb::Cli
