#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/splits/zip_rules.h"
#include "far/topology/splits/zip_slots.h"

/// Akleman and Srinivasan's rules taken literally on an open mesh: only inner vertices give faces, and a face that no
/// such face would touch is left out. The mesh erodes from its boundary.
namespace honeycomb::Far {

namespace {

class DropSlots : public ZipSlots {
 public:
  explicit DropSlots(const Topology& parent) : ZipSlots(parent), kept_(at(parent.faceCount()), 0) {
    Parallel::forEach(0, parent.faceCount(), [&](std::int64_t f) {
      for (const std::int32_t h : parent.halfEdgesOf(static_cast<std::int32_t>(f))) {
        if (!parent.onBoundary(parent.vert(h))) kept_[at(f)] = 1;
      }
    });
  }

  void faceLoop(std::int32_t f, std::vector<std::int32_t>& slots) const override {
    if (!kept_[at(f)]) return;
    for (const std::int32_t h : parent().halfEdgesOf(f)) slots.push_back(slot(h, A));
  }

  void vertexLoop(std::int32_t v, std::vector<std::int32_t>& slots) const override {
    if (parent().onBoundary(v)) return;
    for (const std::int32_t h : parent().halfEdgesFrom(v)) {
      slots.push_back(slot(h, C));
      slots.push_back(slot(parent().prev(h), B));
    }
  }

  std::int32_t start(std::int32_t s) const override { return s / 3; }

  std::int32_t twin(std::int32_t s) const override {
    const std::int32_t h = s / 3;
    switch (s % 3) {
      case A:
        return parent().onBoundary(parent().dest(h)) ? -1 : slot(parent().next(h), C);
      case B:
        return parent().onBoundary(parent().vert(h)) ? -1 : slot(parent().twin(h), B);
      default:
        return slot(parent().prev(h), A);
    }
  }

 private:
  std::vector<std::uint8_t> kept_;
};

}  // namespace

SplitResult zipDrop(const Topology& parent) {
  return assemble(DropSlots(parent));
}

}  // namespace honeycomb::Far
