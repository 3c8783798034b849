#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>

#include "far/topology/topology_arrays.h"

namespace honeycomb::Far {

/// The arrays that the copies of a Topology share, and its links, which are found when first asked for where the split
/// left them out.
class TopologyState {
 public:
  explicit TopologyState(TopologyArrays arrays) : loops_(std::move(arrays)) {
    if (loops_.linkRule == nullptr) found_ = &loops_;
  }
  TopologyState(const TopologyState&) = delete;
  TopologyState& operator=(const TopologyState&) = delete;

  /// All but the links.
  const TopologyArrays& loops() const { return loops_; }
  const HalfEdgeLinks& links() const {
    const HalfEdgeLinks* found = found_.load(std::memory_order_acquire);
    return found != nullptr ? *found : findLinks();
  }
  /// Bytes of the links, as far as they are there.
  std::int64_t linkBytes() const;

  /// The arrays with links, copied and taken away.
  TopologyArrays copy() const;
  /// The same, taken away from this one.
  TopologyArrays take();

 private:
  const HalfEdgeLinks& findLinks() const;

  TopologyArrays loops_;
  mutable HalfEdgeLinks later_;
  mutable std::once_flag once_;
  mutable std::atomic<const HalfEdgeLinks*> found_{nullptr};
};

}  // namespace honeycomb::Far
