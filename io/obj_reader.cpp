#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <string>

#include "io/mapped_file.h"
#include "io/obj.h"
#include "io/obj_tags.h"
#include "io/text_cursor.h"

namespace honeycomb::Io {
namespace {

constexpr std::size_t kHeadBytes = 4096;  // looked at to tell text from binary data
constexpr std::size_t kQuotedBytes = 40;  // of a word in a message
constexpr double kWhite = 1;              // each part of the colour of a vertex that has none where others do

// All statements of the format; a file that begins with anything else is something else.
constexpr std::array<std::string_view, 45> kStatements{
    "v",     "vt",         "vn",        "vp",     "f",      "fo",     "l",        "p",        "g",
    "o",     "s",          "mg",        "usemtl", "mtllib", "usemap", "maplib",   "cstype",   "deg",
    "bmat",  "step",       "curv",      "curv2",  "surf",   "parm",   "trim",     "hole",     "scrv",
    "sp",    "end",        "con",       "bevel",  "lod",    "maxlod", "d_interp", "c_interp", "ctech",
    "stech", "shadow_obj", "trace_obj", "call",   "csh",    "bsp",    "bzp",      "cdc",      "t"};

// What a face corner can name: the words for messages, and how many the file has.
struct Element {
  std::string_view one;
  std::string_view many;
  std::int64_t count = 0;
  std::int64_t highest = -1;  // 0-based index named so far
};

bool isControl(char c) {
  return static_cast<unsigned char>(c) < 0x20;
}
bool isPrintable(char c) {
  return c >= 0x20 && c < 0x7F;
}

// A word of the file, made fit for one line on any terminal.
std::string quoted(std::string_view word) {
  std::string text(word.substr(0, kQuotedBytes));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return !isPrintable(c); }, '?');
  return fmt::format("'{}{}'", text, word.size() > kQuotedBytes ? "..." : "");
}

class ObjParser {
 public:
  ObjParser(std::string_view text, std::string_view name, std::int64_t maxElements)
      : text_(text), name_(name), maxElements_(maxElements), cursor_(text), tags_(name) {}

  Result<Mesh> parse() {
    if (Result<void> head = checkHead(); !head) return tl::unexpected<Error>(head.error());
    while (cursor_.nextStatement()) {
      statementLine_ = cursor_.line();
      if (Result<void> read = statement(cursor_.word()); !read) return tl::unexpected<Error>(read.error());
    }
    if (Result<void> whole = checkWhole(); !whole) return tl::unexpected<Error>(whole.error());
    mesh_.polygons.vertexCount = static_cast<std::int32_t>(vertices_.count);
    if (!mesh_.colours.empty()) mesh_.colours.resize(mesh_.positions.size(), kWhite);
    if (Result<void> tagged = tags_.finish(mesh_); !tagged) return tl::unexpected<Error>(tagged.error());
    return std::move(mesh_);
  }

 private:
  tl::unexpected<Error> failAt(std::int64_t line, std::string_view what) const {
    return fail(ErrorCode::invalidFile, fmt::format("{}:{}: {}", name_, line, what), line);
  }
  tl::unexpected<Error> failFile(std::string_view what) const {
    return fail(ErrorCode::invalidFile, fmt::format("{}: {}", name_, what));
  }

  Result<void> checkHead() const;
  Result<void> checkWhole() const;
  Result<void> statement(std::string_view keyword);
  Result<void> checkUnknown(std::string_view keyword) const;
  Result<void> vertex();
  Result<void> colour(std::span<const double> rgb);
  Result<void> texcoord();
  Result<void> normal();
  Result<void> face();
  Result<void> corner();
  Result<std::size_t> numbers(std::span<double> values);
  Result<std::int32_t> resolve(std::int64_t written, Element& element) const;
  Result<void> addOptional(std::int64_t written, bool given, Element& element,
                           std::vector<std::int32_t>& corners) const;
  Result<void> checkIndices(const Element& element, std::span<const std::int32_t> corners) const;

  std::string_view text_;
  std::string_view name_;
  std::int64_t maxElements_;
  TextCursor cursor_;
  ObjTags tags_;
  std::int64_t statementLine_ = 0;
  bool begun_ = false;  // a statement of the format was seen
  Element vertices_{"vertex", "vertices"};
  Element texcoords_{"texture coordinate", "texture coordinates"};
  Element normals_{"normal", "normals"};
  Mesh mesh_;
};

Result<void> ObjParser::checkHead() const {
  if (text_.empty()) return failFile("is empty; give a Wavefront OBJ file");
  const std::size_t nul = text_.substr(0, kHeadBytes).find('\0');
  if (nul == std::string_view::npos) return {};
  const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
  return failAt(line, "holds NUL bytes and so is no text; give a Wavefront OBJ file in ASCII or UTF-8");
}

Result<void> ObjParser::checkWhole() const {
  if (vertices_.count == 0) return failFile("has no vertices ('v' statements); give a Wavefront OBJ file with a mesh");
  if (mesh_.polygons.faceCount() == 0) return failFile("has no faces ('f' statements); give a mesh of polygons");
  return checkIndices(vertices_, mesh_.polygons.indices)
      .and_then([this] { return checkIndices(texcoords_, mesh_.cornerTexcoords); })
      .and_then([this] { return checkIndices(normals_, mesh_.cornerNormals); });
}

Result<void> ObjParser::statement(std::string_view keyword) {
  if (keyword == "v") return vertex();
  if (keyword == "f" || keyword == "fo") return face();  // fo: a face in files of the format's first version
  if (keyword == "vn") return normal();
  if (keyword == "vt") return texcoord();
  if (keyword == "t") {
    begun_ = true;
    return tags_.read(cursor_);
  }
  if (Result<void> sound = checkUnknown(keyword); !sound) return sound;
  begun_ = true;
  cursor_.skipStatement();
  return {};
}

Result<void> ObjParser::checkUnknown(std::string_view keyword) const {
  if (std::any_of(keyword.begin(), keyword.end(), isControl)) {
    return failAt(statementLine_, "holds binary data; give a Wavefront OBJ file in ASCII or UTF-8");
  }
  if (begun_ || std::find(kStatements.begin(), kStatements.end(), keyword) != kStatements.end()) return {};
  return failAt(statementLine_, fmt::format("{} begins no OBJ statement; give a Wavefront OBJ file", quoted(keyword)));
}

// The numbers up to the statement's end, those that fit into `values`; returns how many there are.
Result<std::size_t> ObjParser::numbers(std::span<double> values) {
  begun_ = true;
  std::size_t count = 0;
  for (double excess = 0; !cursor_.atStatementEnd(); ++count) {
    if (cursor_.number(count < values.size() ? values[count] : excess)) continue;
    return failAt(cursor_.line(), fmt::format("{} is not a number; write a decimal number such as -0.5 or 1e-3",
                                              quoted(cursor_.peekWord())));
  }
  return count;
}

// x y z, then nothing, a weight w, a colour r g b, or both.
Result<void> ObjParser::vertex() {
  std::array<double, 7> values{};
  const std::span<const double> point(values.data(), 3);
  const Result<std::size_t> count = numbers(values);
  if (!count) return tl::unexpected<Error>(count.error());
  if (*count != 3 && *count != 4 && *count != 6 && *count != 7) {
    return failAt(statementLine_, fmt::format("a vertex has {} numbers; write v x y z", *count));
  }
  for (const double coordinate : point) {
    if (std::isfinite(coordinate)) continue;
    return fail(ErrorCode::invalidPositions,
                fmt::format("{}:{}: vertex {} (counted from 1) has the coordinate {}; give it a finite position", name_,
                            statementLine_, vertices_.count + 1, coordinate),
                vertices_.count);
  }
  if (vertices_.count == maxElements_) {
    return fail(ErrorCode::tooLarge,
                fmt::format("{}:{}: more than {} vertices; split the mesh", name_, statementLine_, maxElements_));
  }
  if (*count >= 6) {
    if (Result<void> read = colour(std::span(values).subspan(*count - 3, 3)); !read) return read;
  }
  mesh_.positions.insert(mesh_.positions.end(), point.begin(), point.end());
  mesh_.vertexLines.push_back(statementLine_);
  ++vertices_.count;
  return {};
}

// Vertices from before the first with a colour become white when that one comes.
Result<void> ObjParser::colour(std::span<const double> rgb) {
  if (!std::all_of(rgb.begin(), rgb.end(), [](double x) { return std::isfinite(x); })) {
    return failAt(statementLine_, "a colour is not finite; give it finite numbers or remove it");
  }
  mesh_.colours.resize(mesh_.positions.size(), kWhite);
  mesh_.colours.insert(mesh_.colours.end(), rgb.begin(), rgb.end());
  return {};
}

Result<void> ObjParser::texcoord() {
  std::array<double, 3> uvw{};
  const Result<std::size_t> count = numbers(uvw);
  if (!count) return tl::unexpected<Error>(count.error());
  if (*count < 1 || *count > 3) {
    return failAt(statementLine_, fmt::format("a texture coordinate has {} numbers; write vt u v", *count));
  }
  if (!std::isfinite(uvw[0]) || !std::isfinite(uvw[1])) {
    return failAt(statementLine_, "a texture coordinate is not finite; give it finite numbers or remove it");
  }
  mesh_.texcoords.insert(mesh_.texcoords.end(), uvw.begin(), uvw.begin() + 2);
  ++texcoords_.count;
  return {};
}

Result<void> ObjParser::normal() {
  std::array<double, 3> direction{};
  const Result<std::size_t> count = numbers(direction);
  if (!count) return tl::unexpected<Error>(count.error());
  if (*count != 3) return failAt(statementLine_, fmt::format("a normal has {} numbers; write vn x y z", *count));
  if (!std::all_of(direction.begin(), direction.end(), [](double x) { return std::isfinite(x); })) {
    return failAt(statementLine_, "a normal is not finite; give it finite numbers or remove it");
  }
  mesh_.normals.insert(mesh_.normals.end(), direction.begin(), direction.end());
  ++normals_.count;
  return {};
}

Result<void> ObjParser::face() {
  begun_ = true;
  const std::size_t first = mesh_.polygons.indices.size();
  while (!cursor_.atStatementEnd()) {
    if (Result<void> read = corner(); !read) return read;
  }
  const std::size_t last = mesh_.polygons.indices.size();
  if (last - first < 3) {
    return failAt(statementLine_, fmt::format("a face has {} corner{}; write three or more, or remove the face",
                                              last - first, last - first == 1 ? "" : "s"));
  }
  if (static_cast<std::int64_t>(last) > maxElements_) {
    return fail(ErrorCode::tooLarge,
                fmt::format("{}:{}: more than {} face corners; split the mesh", name_, statementLine_, maxElements_));
  }
  mesh_.polygons.faceOffsets.push_back(static_cast<std::int64_t>(last));
  mesh_.faceLines.push_back(statementLine_);
  return {};
}

// v, v/vt, v//vn or v/vt/vn; a slash with nothing behind it is let pass.
Result<void> ObjParser::corner() {
  const TextCursor start = cursor_;
  std::int64_t v = 0;
  std::int64_t vt = 0;
  std::int64_t vn = 0;
  const bool named = cursor_.integer(v);
  const bool textured = named && cursor_.take('/') && cursor_.integer(vt);
  const bool normalled = named && cursor_.take('/') && cursor_.integer(vn);
  if (!named || !cursor_.atWordEnd()) {
    return failAt(cursor_.line(), fmt::format("{} is no face corner; write v, v/vt, v//vn or v/vt/vn in whole numbers",
                                              quoted(start.peekWord())));
  }
  const Result<std::int32_t> index = resolve(v, vertices_);
  if (!index) return tl::unexpected<Error>(index.error());
  if (Result<void> added = addOptional(vt, textured, texcoords_, mesh_.cornerTexcoords); !added) return added;
  if (Result<void> added = addOptional(vn, normalled, normals_, mesh_.cornerNormals); !added) return added;
  mesh_.polygons.indices.push_back(*index);
  return {};
}

// The 0-based index of a number of the file. A positive one may name what is still to come: see checkIndices.
Result<std::int32_t> ObjParser::resolve(std::int64_t written, Element& element) const {
  if (written == 0) {
    return failAt(cursor_.line(), fmt::format("a face names {} 0; count from 1, or from -1 backwards", element.one));
  }
  if (written < -element.count) {
    return failAt(cursor_.line(),
                  fmt::format("a face names {} {}, but only {} {} read so far; correct the index", element.one, written,
                              element.count, element.count == 1 ? "was" : "were"));
  }
  if (written > std::numeric_limits<std::int32_t>::max()) {
    return failAt(cursor_.line(), fmt::format("a face names {} {}, more than a file can hold; correct the index",
                                              element.one, written));
  }
  const std::int64_t index = written > 0 ? written - 1 : element.count + written;
  element.highest = std::max(element.highest, index);
  return static_cast<std::int32_t>(index);
}

// Corners from before the first that names such an element get -1 when that one comes.
Result<void> ObjParser::addOptional(std::int64_t written, bool given, Element& element,
                                    std::vector<std::int32_t>& corners) const {
  if (!given && corners.empty()) return {};
  std::int32_t value = -1;
  if (given) {
    const Result<std::int32_t> index = resolve(written, element);
    if (!index) return tl::unexpected<Error>(index.error());
    value = *index;
  }
  corners.resize(mesh_.polygons.indices.size(), -1);
  corners.push_back(value);
  return {};
}

Result<void> ObjParser::checkIndices(const Element& element, std::span<const std::int32_t> corners) const {
  if (element.highest < element.count) return {};
  const auto beyond = [&element](std::int32_t index) { return index >= element.count; };
  const auto first = std::find_if(corners.begin(), corners.end(), beyond);
  const auto others = std::count_if(first + 1, corners.end(), beyond);
  const auto& offsets = mesh_.polygons.faceOffsets;
  const auto face = std::upper_bound(offsets.begin(), offsets.end(), first - corners.begin()) - offsets.begin() - 1;
  return failAt(mesh_.faceLines[static_cast<std::size_t>(face)],
                fmt::format("a face names {} {}, but the file has {} {}; correct the index{}", element.one,
                            std::int64_t{*first} + 1, element.count, element.count == 1 ? element.one : element.many,
                            others == 0 ? "" : fmt::format(" (and {} more)", others)));
}

}  // namespace

Result<Mesh> parseObj(std::string_view text, std::string_view name, std::int64_t maxElements) {
  try {
    return ObjParser(text, name, maxElements).parse();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::outOfMemory, fmt::format("{}: the mesh does not fit into memory; split it", name));
  }
}

Result<Mesh> readObj(const std::filesystem::path& path) {
  const Result<MappedFile> file = MappedFile::open(path);
  if (!file) return tl::unexpected<Error>(file.error());
  file->expectSequentialReads();
  return parseObj(file->text(), path.string());
}

}  // namespace honeycomb::Io
