#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "far/base/result.h"
#include "io/frame_source.h"
#include "io/mesh.h"

namespace honeycomb::Io {

/// Does the name stand for several files: `frame_%04d.obj` (a place for a number, with or without a width) or a glob
/// with
/// `*`, `?` or `[..]` in its last part? A file that is there under exactly this name is itself.
bool isSequence(const std::filesystem::path& pattern);

/// The files of a sequence in the order of their numbers. Those of a glob are ordered by the last number in their
/// names, then by the names. Numbers may start anywhere and go in steps of any one size. Errors: unreadable, for a
/// folder that can't be read; invalidOption when no file fits; invalidFile when some are missing between the first and
/// the last, naming them.
Result<std::vector<std::filesystem::path>> sequenceFiles(const std::filesystem::path& pattern);

/// Meshes in files of their own as frames of one: only their positions may differ. A frame is read when it is asked
/// for; nothing of it is kept but what the caller keeps. Thread-safe.
class MeshSequence : public FrameSource {
 public:
  /// Reads one of the files, such as readObj() or readPly().
  using Read = Result<Mesh> (*)(const std::filesystem::path&);

  /// `first`: the mesh of files[0], which isn't empty.
  MeshSequence(std::vector<std::filesystem::path> files, const Mesh& first, Read read);

  /// Rate 1: times count frames.
  const FrameInfo& info() const override { return info_; }
  /// Errors besides those of all sources: those of the reader; invalidFile (element: f) when the file's polygons are
  /// not those of the first, naming both files and what differs.
  Result<std::span<const float>> frame(std::int32_t f, std::vector<float>& storage) const override;

 private:
  Result<void> checkSame(std::size_t f, const Far::Polygons& polygons) const;

  std::vector<std::filesystem::path> files_;
  Far::Polygons polygons_;
  Read read_;
  FrameInfo info_;
};

}  // namespace honeycomb::Io
