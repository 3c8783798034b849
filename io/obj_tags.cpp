#include "io/obj_tags.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "far/base/index.h"

namespace honeycomb::Io {

tl::unexpected<Error> ObjTags::failAt(std::int64_t line, std::string_view what) const {
  return fail(ErrorCode::invalidFile, fmt::format("{}:{}: {}", file_, line, what), line);
}

Result<void> ObjTags::read(TextCursor& cursor) {
  const std::string_view name = cursor.atStatementEnd() ? std::string_view() : cursor.word();
  if (name != "crease" && name != "corner") {
    cursor.skipStatement();
    return {};
  }
  Result<Tag> read = tag(cursor, name);
  if (!read) return tl::unexpected<Error>(read.error());
  (name == "crease" ? creases_ : corners_).push_back(std::move(*read));
  return {};
}

/// The word ints/floats/strings.
Result<ObjTags::Counts> ObjTags::counts(TextCursor& cursor) const {
  Counts counts;
  const bool whole = !cursor.atStatementEnd() && cursor.integer(counts.integers) && cursor.take('/') &&
                     cursor.integer(counts.reals) && cursor.take('/') && cursor.integer(counts.strings) &&
                     cursor.atWordEnd();
  if (whole && counts.integers >= 0 && counts.reals >= 0 && counts.strings >= 0) return counts;
  return failAt(cursor.line(), "a tag's counts can't be read; write t NAME integers/reals/strings, such as 2/1/0");
}

Result<ObjTags::Tag> ObjTags::tag(TextCursor& cursor, std::string_view name) const {
  Tag tag;
  tag.line = cursor.line();
  const Result<Counts> announced = counts(cursor);
  if (!announced) return tl::unexpected<Error>(announced.error());
  for (std::int64_t i = 0; i < announced->integers; ++i) {
    std::int64_t vertex = 0;
    if (cursor.atStatementEnd() || !cursor.integer(vertex) || !cursor.atWordEnd()) {
      return failAt(cursor.line(), fmt::format("a {} tag announces {} vertex numbers, and number {} can't be read; "
                                               "write whole numbers that count from 0",
                                               name, announced->integers, i + 1));
    }
    tag.vertices.push_back(vertex);
  }
  for (std::int64_t i = 0; i < announced->reals; ++i) {
    double sharpness = 0;
    if (cursor.atStatementEnd() || !cursor.number(sharpness) || !std::isfinite(sharpness) || sharpness < 0) {
      return failAt(cursor.line(), fmt::format("a {} tag announces {} sharpnesses, and number {} can't be read; write "
                                               "numbers that aren't negative",
                                               name, announced->reals, i + 1));
    }
    tag.sharpness.push_back(sharpness);
  }
  std::int64_t words = 0;
  for (; !cursor.atStatementEnd(); ++words) cursor.word();
  if (words != announced->strings) {
    return failAt(tag.line, fmt::format("a {} tag has {} words behind its numbers and announces {}; correct its counts",
                                        name, words, announced->strings));
  }
  return checkCounts(tag, name).map([&] { return std::move(tag); });
}

Result<void> ObjTags::checkCounts(const Tag& tag, std::string_view name) const {
  const bool crease = name == "crease";
  const std::size_t elements = crease ? tag.vertices.size() / 2 : tag.vertices.size();
  const bool paired = !crease || tag.vertices.size() % 2 == 0;
  if (elements > 0 && paired && (tag.sharpness.size() == 1 || tag.sharpness.size() == elements)) return {};
  return failAt(tag.line, fmt::format("a {} tag has {} vertex numbers and {} sharpnesses; write {}", name,
                                      tag.vertices.size(), tag.sharpness.size(),
                                      crease ? "t crease 2/1/0 a b sharpness, with two vertices an edge"
                                             : "t corner 1/1/0 v sharpness"));
}

Result<void> ObjTags::checkVertices(const Tag& tag, std::int64_t vertexCount) const {
  for (const std::int64_t v : tag.vertices) {
    if (v >= 0 && v < vertexCount) continue;
    return failAt(tag.line, fmt::format("a tag names vertex {} (counted from 0), but the file has {} vertices; correct "
                                        "the number",
                                        v, vertexCount));
  }
  return {};
}

Result<void> ObjTags::finish(Mesh& mesh) const {
  for (const std::vector<Tag>* tags : {&creases_, &corners_}) {
    for (const Tag& tag : *tags) {
      if (auto sound = checkVertices(tag, mesh.polygons.vertexCount); !sound) return sound;
    }
  }
  addCreases(mesh);
  return addCorners(mesh);
}

void ObjTags::addCreases(Mesh& mesh) const {
  for (const Tag& tag : creases_) {
    for (std::size_t i = 0; i + 1 < tag.vertices.size(); i += 2) {
      mesh.polygons.creases.push_back({static_cast<std::int32_t>(tag.vertices[i]),
                                       static_cast<std::int32_t>(tag.vertices[i + 1]), tag.sharpnessOf(i / 2)});
      mesh.creaseLines.push_back(tag.line);
    }
  }
}

Result<void> ObjTags::addCorners(Mesh& mesh) const {
  for (const Tag& tag : corners_) {
    for (std::size_t i = 0; i < tag.vertices.size(); ++i) {
      if (tag.sharpnessOf(i) < Far::kSharp) {
        return failAt(tag.line, fmt::format("vertex {} (counted from 0) can't be a corner of sharpness {}; corners are "
                                            "of sharpness {} or more, on a boundary or a crease",
                                            tag.vertices[i], tag.sharpnessOf(i), Far::kSharp));
      }
      mesh.polygons.corners.push_back(static_cast<std::int32_t>(tag.vertices[i]));
      mesh.cornerLines.push_back(tag.line);
    }
  }
  return {};
}

}  // namespace honeycomb::Io
