#include "apps/viewer/look.h"

#include <array>
#include <cmath>
#include <mutex>

#include "far/base/parallel.h"

namespace honeycomb::Viewer {
namespace {

constexpr std::array kLooks{
    Look{"shaded", "smooth, by limit normals", Colouring::plain, false, false, false},
    Look{"flat", "each cell by its own normal", Colouring::plain, true, false, false},
    Look{"cells", "cells outlined, coloured by what they descend from", Colouring::descent, false, true, false},
    Look{"sides", "coloured by number of sides", Colouring::sides, true, true, false},
    Look{"planarity", "coloured by how far from flat cells are", Colouring::plain, true, true, true},
    Look{"extraordinary", "where cells are no hexagons, and the rings round them", Colouring::extraordinary, false,
         true, false}};

glm::vec3 pointAt(std::span<const float> points, std::int32_t v) {
  const std::size_t i = 3 * static_cast<std::size_t>(v);
  return {points[i], points[i + 1], points[i + 2]};
}

float bendOf(const Far::Topology& topology, std::span<const float> points, std::int32_t f) {
  const std::int32_t first = topology.faceOffsets()[static_cast<std::size_t>(f)];
  const std::int32_t end = first + topology.sides(f);
  const glm::vec3 origin = pointAt(points, topology.vert(first));
  glm::vec3 sum(0);
  glm::vec3 area(0);
  glm::vec3 last = pointAt(points, topology.vert(end - 1)) - origin;
  for (std::int32_t h = first; h < end; ++h) {
    const glm::vec3 here = pointAt(points, topology.vert(h)) - origin;
    sum += here;
    area += glm::cross(last, here);
    last = here;
  }
  const glm::vec3 middle = origin + sum / static_cast<float>(end - first);
  const glm::vec3 normal = area / std::max(glm::length(area), 1e-30f);
  float away = 0;
  float radius = 0;
  for (std::int32_t h = first; h < end; ++h) {
    const glm::vec3 arm = pointAt(points, topology.vert(h)) - middle;
    away = std::max(away, std::abs(glm::dot(arm, normal)));
    radius = std::max(radius, glm::dot(arm, arm));
  }
  return away / std::max(2 * std::sqrt(radius), 1e-30f);
}

}  // namespace

std::span<const Look> looks() {
  return kLooks;
}

Style styleOf(const Look& look, bool edges) {
  Style style;
  style.faceted = look.faceted;
  style.flatness = look.flatness;
  if (!edges) style.edgeStrength = 0;
  return style;
}

Bend flatness(const Far::Topology& topology, std::span<const float> points) {
  constexpr std::int64_t kFacesAtOnce = 1024;
  Bend worst;
  std::mutex mutex;
  Parallel::forRange(0, topology.faceCount(), kFacesAtOnce, [&](std::int64_t begin, std::int64_t end) {
    Bend own;
    for (auto f = static_cast<std::int32_t>(begin); f < end; ++f) {
      const float bend = bendOf(topology, points, f);
      if (own.face < 0 || bend > own.most) own = {bend, f};
    }
    const std::lock_guard lock(mutex);
    // The first of equals, however the range was cut.
    if (worst.face < 0 || own.most > worst.most || (own.most == worst.most && own.face < worst.face)) worst = own;
  });
  return worst;
}

}  // namespace honeycomb::Viewer
