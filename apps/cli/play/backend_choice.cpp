#include "apps/cli/play/backend_choice.h"

#include <algorithm>

#include "apps/cli/chain.h"
#include "apps/cli/surface_evaluator.h"

namespace honeycomb::Cli::Play {
namespace {

constexpr std::size_t kTrials = 4;  ///< frames of each; the first has caches and pipelines to warm

}  // namespace

Result<BackendChoice> BackendChoice::parse(const std::string& name) {
  if (const auto entry = choose(backends(), "--backend", name); !entry) return tl::unexpected(entry.error());
  BackendChoice choice;
  choice.asked_ = name;
  choice.restart();
  return choice;
}

void BackendChoice::restart() {
  candidates_ = asked_ == "auto" ? std::vector<std::string>{"tbb", "vulkan"} : std::vector<std::string>{asked_};
  times_.clear();
  next_ = 0;
  settled_ = candidates_.size() == 1;
}

std::string BackendChoice::first() const {
  BackendChoice other = *this;
  other.restart();
  return other.current();
}

const std::string& BackendChoice::current() const {
  return candidates_[next_];
}

bool BackendChoice::drop() {
  if (candidates_.size() == 1) return false;
  candidates_.erase(candidates_.begin() + static_cast<std::ptrdiff_t>(next_));
  next_ = 0;
  settled_ = candidates_.size() == 1;
  return true;
}

void BackendChoice::took(double milliseconds) {
  if (settled_) return;
  std::vector<double>& times = times_[current()];
  times.push_back(milliseconds);
  if (times.size() < kTrials) return;
  if (++next_ < candidates_.size()) return;
  // The fastest at its best is the fastest.
  const auto best = [this](const std::string& name) {
    const std::vector<double>& taken = times_[name];
    return *std::min_element(taken.begin(), taken.end());
  };
  next_ = 0;
  for (std::size_t i = 1; i < candidates_.size(); ++i)
    if (best(candidates_[i]) < best(candidates_[next_])) next_ = i;
  settled_ = true;
}

}  // namespace honeycomb::Cli::Play
