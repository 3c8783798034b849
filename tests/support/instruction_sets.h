#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace honeycomb::Test {

/// Makes the kernels use one of Highway's targets while it lives.
class TargetInUse {
 public:
  explicit TargetInUse(std::int64_t target) { use(target); }
  ~TargetInUse() {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
  TargetInUse(const TargetInUse&) = delete;
  TargetInUse& operator=(const TargetInUse&) = delete;

 private:
  static void use(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
  }
};

/// Those of this machine, and none of them: the plain kernels.
inline std::vector<std::int64_t> targets() {
  std::vector<std::int64_t> result{HWY_SCALAR};
  for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    if (target != HWY_SCALAR) result.push_back(target);
  }
  return result;
}

/// Calls body() once for each of them.
template <class Body>
void forEachTarget(const Body& body) {
  for (const std::int64_t target : targets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    const TargetInUse use(target);
    body();
    if (testing::Test::HasFatalFailure()) return;
  }
}

}  // namespace honeycomb::Test
