#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "far/base/result.h"
#include "io/obj.h"
#include "io/text_cursor.h"

namespace honeycomb::Io {

/// The tags of an OBJ file in OpenSubdiv's notation,
///     t NAME ints/floats/strings  int ..  float ..  string ..
/// with vertices counted from 0. Read are
///     t crease 2/1/0 a b sharpness      or 2n numbers for n edges, with one sharpness for all or one for each
///     t corner 1/1/0 v sharpness        or n vertices; of sharpness 10 or more
/// All others (interpolateboundary, facevaryinginterpolateboundary, ..) are passed over.
class ObjTags {
 public:
  /// `file` stands for the file in messages and must outlive this.
  explicit ObjTags(std::string_view file) : file_(file) {}

  /// Reads a statement whose first word, t, is passed already. Errors: invalidFile, "FILE:LINE: ...".
  Result<void> read(TextCursor& cursor);

  /// Hands the tags over to a mesh that is complete otherwise. Errors: the same for vertices that it hasn't, and for
  /// corners that are less sharp. Whether creases lie on edges, and corners on a boundary or a crease, is
  /// Far::Topology's business.
  Result<void> finish(Mesh& mesh) const;

 private:
  struct Counts {
    std::int64_t integers = 0, reals = 0, strings = 0;
  };
  struct Tag {
    std::int64_t line = 0;
    std::vector<std::int64_t> vertices;
    std::vector<double> sharpness;  ///< one for all, or one for each
    double sharpnessOf(std::size_t i) const { return sharpness.size() == 1 ? sharpness.front() : sharpness[i]; }
  };

  tl::unexpected<Error> failAt(std::int64_t line, std::string_view what) const;
  Result<Counts> counts(TextCursor& cursor) const;
  Result<Tag> tag(TextCursor& cursor, std::string_view name) const;
  Result<void> checkCounts(const Tag& tag, std::string_view name) const;
  Result<void> checkVertices(const Tag& tag, std::int64_t vertexCount) const;
  void addCreases(Mesh& mesh) const;
  Result<void> addCorners(Mesh& mesh) const;

  std::string_view file_;
  std::vector<Tag> creases_, corners_;
};

}  // namespace honeycomb::Io
