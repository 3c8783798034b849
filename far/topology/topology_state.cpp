#include "far/topology/topology_state.h"

#include <utility>

#include "far/base/bytes.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

const HalfEdgeLinks& TopologyState::findLinks() const {
  std::call_once(once_, [this] {
    // Isolated: a thread that waits for the rule's loops must not take up other work, which might ask for these links.
    Parallel::isolated([this] { later_ = loops_.linkRule(loops_); });
    found_.store(&later_, std::memory_order_release);
  });
  return later_;
}

std::int64_t TopologyState::linkBytes() const {
  const HalfEdgeLinks* found = found_.load(std::memory_order_acquire);
  return found == nullptr ? 0 : bytes(found->twin) + bytes(found->face) + bytes(found->outgoing);
}

TopologyArrays TopologyState::copy() const {
  TopologyArrays arrays = loops_;
  static_cast<HalfEdgeLinks&>(arrays) = links();
  arrays.linkRule = nullptr;
  return arrays;
}

TopologyArrays TopologyState::take() {
  (void)links();
  TopologyArrays arrays = std::move(loops_);
  if (arrays.linkRule != nullptr) static_cast<HalfEdgeLinks&>(arrays) = std::move(later_);
  arrays.linkRule = nullptr;
  return arrays;
}

}  // namespace honeycomb::Far
