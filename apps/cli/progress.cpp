#include "apps/cli/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace honeycomb::Cli {
namespace {

constexpr std::chrono::milliseconds kSilence{1000};  // shorter runs show nothing
constexpr std::chrono::milliseconds kRedraw{100};
constexpr int kBarWidth = 24;

std::string clock(double seconds) {
  const auto whole = static_cast<long>(std::min(std::ceil(seconds), 359999.0));
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string humanRate(double rate) {
  if (rate >= 1e6) return fmt::format("{:.1f} M", rate / 1e6);
  if (rate >= 1e3) return fmt::format("{:.1f} k", rate / 1e3);
  return fmt::format("{:.1f} ", rate);
}

}  // namespace

std::string progressLine(const ProgressState& state) {
  const double fraction = std::clamp(state.fraction, 0.0, 1.0);
  const auto filled = static_cast<int>(fraction * kBarWidth);
  std::string line = fmt::format("{}  [{:#>{}}{:->{}}] {:3.0f}%", state.label, "", filled, "", kBarWidth - filled,
                                 std::floor(fraction * 100));
  if (state.unitsDone > 0 && state.seconds > 0)
    line += fmt::format("  {}{}/s", humanRate(state.unitsDone / state.seconds), state.unit);
  if (fraction > 0) line += fmt::format("  {} left", clock(state.seconds * (1 - fraction) / fraction));
  return line;
}

Progress::Progress(const Session& session, std::string label, std::string unit, double totalUnits)
    : totalUnits_(totalUnits) {
  state_.label = std::move(label);
  state_.unit = std::move(unit);
  if (!session.quiet && stderrIsTerminal()) drawer_ = std::thread([this] { drawUntilStopped(); });
}

Progress::~Progress() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  wake_.notify_all();
  if (drawer_.joinable()) drawer_.join();
}

void Progress::advance(double units) {
  const std::lock_guard lock(mutex_);
  state_.unitsDone += units;
  state_.fraction = totalUnits_ > 0 ? state_.unitsDone / totalUnits_ : 1;
}

void Progress::stage(std::string label) {
  const std::lock_guard lock(mutex_);
  state_.label = std::move(label);
}

void Progress::drawUntilStopped() {
  std::unique_lock lock(mutex_);
  if (wake_.wait_for(lock, kSilence, [this] { return stopped_; })) return;
  do {
    state_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    // Back to the first column, the bar, and away with what is left of a longer one.
    const std::string line = fmt::format("\r{}\x1b[K", progressLine(state_));
    std::fwrite(line.data(), 1, line.size(), stderr);
    std::fflush(stderr);
  } while (!wake_.wait_for(lock, kRedraw, [this] { return stopped_; }));
  std::fputs("\r\x1b[K", stderr);
}

}  // namespace honeycomb::Cli
