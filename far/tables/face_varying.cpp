#include "far/tables/face_varying.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/face_varying_level.h"

namespace honeycomb::Far {

namespace {

Result<void> check(const Topology& control, const FaceVaryingChannel& channel) {
  if (channel.length < 1 || channel.values.size() % at(channel.length) != 0) {
    return fail(ErrorCode::invalidOption, fmt::format("{} numbers are no values of length {}; give whole values",
                                                      channel.values.size(), channel.length));
  }
  if (channel.corners.size() != at(control.halfEdgeCount())) {
    return fail(ErrorCode::invalidOption,
                fmt::format("a face-varying channel names {} corners, but the mesh has {}; give each corner a value",
                            channel.corners.size(), control.halfEdgeCount()));
  }
  const auto wrong =
      std::find_if(channel.values.begin(), channel.values.end(), [](double x) { return !std::isfinite(x); });
  if (wrong == channel.values.end()) return {};
  const auto value = (wrong - channel.values.begin()) / channel.length;
  return fail(ErrorCode::invalidOption,
              fmt::format("face-varying value {} (counted from 0) holds {}; give finite numbers", value, *wrong),
              value);
}

/// The place of each control face's first corner in the caller's order of faces.
std::vector<std::int32_t> inputOffsets(const Topology& control) {
  std::vector<std::int32_t> offsets(at(control.faceCount()));
  for (std::int32_t f = 0; f < control.faceCount(); ++f) offsets[at(control.inputFace(f))] = control.sides(f);
  Parallel::exclusiveScan(offsets);
  return offsets;
}

Result<std::vector<std::int32_t>> halfEdgeValues(const Topology& control, const FaceVaryingChannel& channel) {
  const std::vector<std::int32_t> offsets = inputOffsets(control);
  const auto valueCount = static_cast<std::int64_t>(channel.values.size()) / channel.length;
  std::vector<std::int32_t> corners(at(control.halfEdgeCount()));
  for (std::int32_t h = 0; h < control.halfEdgeCount(); ++h) {
    const std::int32_t f = control.face(h);
    const std::int32_t place = h - control.faceOffsets()[at(f)];
    const std::int32_t value = channel.corners[at(offsets[at(control.inputFace(f))] + place)];
    if (value < 0 || value >= valueCount) {
      return fail(ErrorCode::invalidOption,
                  fmt::format("corner {} of face {} (counted from 0) has the face-varying value {} of {}; give every "
                              "corner a value",
                              place, control.inputFace(f), value, valueCount),
                  control.inputFace(f));
    }
    corners[at(h)] = value;
  }
  return corners;
}

/// Lets neighbouring corners of a vertex that have equal values have the same value: many files name a value anew for
/// every face.
void shareEqualValues(const Topology& control, const FaceVaryingChannel& channel, std::vector<std::int32_t>& corners) {
  const auto equal = [&](std::int32_t a, std::int32_t b) {
    const auto value = [&](std::int32_t h) {
      return channel.values.begin() + std::ptrdiff_t{corners[at(h)]} * channel.length;
    };
    return std::equal(value(a), value(a) + channel.length, value(b));
  };
  Parallel::forEach(0, control.vertexCount(), [&](std::int64_t v) {
    const std::int32_t first = control.outgoing(static_cast<std::int32_t>(v));
    std::int32_t last = first;
    for (std::int32_t h = control.nextOutgoing(first); h >= 0 && h != first; h = control.nextOutgoing(h)) {
      if (equal(last, h)) corners[at(h)] = corners[at(last)];
      last = h;
    }
    if (control.nextOutgoing(last) < 0 || !equal(last, first)) return;
    const std::int32_t before = corners[at(last)];
    for (std::int32_t h = last; h != first && corners[at(h)] == before; h = control.next(control.twin(h))) {
      corners[at(h)] = corners[at(first)];
    }
  });
}

}  // namespace

Result<FaceVarying> FaceVarying::build(const Refinement& refinement, const FaceVaryingChannel& channel) {
  const Topology& control = refinement.level(0).topology;
  if (const auto sound = check(control, channel); !sound) return tl::unexpected(sound.error());
  Result<std::vector<std::int32_t>> corners = halfEdgeValues(control, channel);
  if (!corners) return tl::unexpected(corners.error());
  shareEqualValues(control, channel, *corners);
  std::vector<FaceVaryingLevel> levels(1);
  levels[0].valueCount = static_cast<std::int32_t>(channel.values.size() / at(channel.length));
  levels[0].corners = std::move(*corners);
  std::vector<double> values(channel.values.begin(), channel.values.end());
  bool seams = true;
  bool anySeams = false;
  for (std::int32_t k = 0; k < refinement.levelCount(); ++k) {
    const Level& parent = refinement.level(k);
    const bool central = parent.central == CentralPoints::byFace;
    const Charts charts(parent.topology, levels.back().corners, values, channel.length,
                        central ? parent.topology.vertexCount() : -1, seams);
    seams = charts.hasSeams();
    if (k == 0) anySeams = seams;
    levels.push_back(buildFaceVaryingLevel(parent, refinement.level(k + 1), charts, levels.back().valueCount,
                                           channel.length, values));
  }
  return FaceVarying(std::move(levels), anySeams);
}

std::int64_t FaceVarying::byteCount() const {
  std::size_t bytes = 0;
  for (const FaceVaryingLevel& level : levels_) {
    bytes += level.corners.size() * sizeof(std::int32_t) + at(level.table.byteCount());
  }
  return static_cast<std::int64_t>(bytes);
}

}  // namespace honeycomb::Far
