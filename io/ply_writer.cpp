#include "io/ply_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <string>

#include "far/base/index.h"
#include "io/mesh_content.h"
#include "io/output_file.h"

namespace honeycomb::Io {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they stand in memory");

constexpr std::int32_t kMostInByte = 255;

/// What a file has besides positions and faces.
struct PlyShape {
  std::optional<std::vector<std::int32_t>> vertexTexcoords;  // none: there are seams
  bool texcoords = false;
  bool longLists = false;
};

template <class Real>
PlyShape shapeOf(const ObjContent<Real>& content) {
  PlyShape shape;
  shape.texcoords = !content.cornerTexcoords.empty();
  shape.vertexTexcoords =
      texcoordsOfVertices(content.faceVertices, content.cornerTexcoords, content.positions.size() / 3);
  std::int32_t most = 0;
  for (std::size_t f = 0; f + 1 < content.faceOffsets.size(); ++f)
    most = std::max(most, content.faceOffsets[f + 1] - content.faceOffsets[f]);
  shape.longLists = most > (shape.vertexTexcoords ? kMostInByte : kMostInByte / 2);
  return shape;
}

template <class Real>
std::string plyHeader(const ObjContent<Real>& content, const PlyShape& shape) {
  const std::string_view real = sizeof(Real) == 8 ? "double" : "float", count = shape.longLists ? "uint" : "uchar";
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment honeycomb\n";
  const auto properties = [&text](std::string_view type, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) text += fmt::format("property {} {}\n", type, name);
  };
  text += fmt::format("element vertex {}\n", content.positions.size() / 3);
  properties(real, {"x", "y", "z"});
  if (!content.normals.empty()) properties(real, {"nx", "ny", "nz"});
  if (!content.colours.empty()) properties("uchar", {"red", "green", "blue"});
  if (shape.texcoords && shape.vertexTexcoords) properties(real, {"s", "t"});
  text += fmt::format("element face {}\nproperty list {} int vertex_indices\n", content.faceOffsets.size() - 1, count);
  if (!shape.vertexTexcoords) text += fmt::format("property list {} {} texcoord\n", count, real);
  return text + "end_header\n";
}

/// Puts numbers into the file as they stand.
class PlyBytes {
 public:
  explicit PlyBytes(OutputFile& file) : file_(file) {}

  template <class Number>
  void put(std::span<const Number> numbers) {
    if (failed_) return;
    const Result<void> written = file_.write(std::as_bytes(numbers));
    if (!written) failed_ = written.error();
  }
  template <class Number>
  void put(const Number& number) {
    put(std::span<const Number>(&number, 1));
  }
  Result<void> commit() {
    if (failed_) return tl::unexpected<Error>(*failed_);
    return file_.commit();
  }

 private:
  OutputFile& file_;
  std::optional<Error> failed_;
};

template <class Real>
std::array<Real, 2> texcoordOf(const ObjContent<Real>& content, std::int32_t texcoord) {
  if (texcoord < 0) return {};
  return {content.texcoords[2 * at(texcoord)], content.texcoords[2 * at(texcoord) + 1]};
}

template <class Real>
std::array<std::uint8_t, 3> byteColour(std::span<const Real> rgb) {
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t i = 0; i < 3; ++i)
    bytes[i] = static_cast<std::uint8_t>(std::lround(std::clamp(rgb[i], Real{0}, Real{1}) * 255));
  return bytes;
}

template <class Real>
void putVertices(PlyBytes& bytes, const ObjContent<Real>& content, const PlyShape& shape) {
  for (std::size_t v = 0; v < content.positions.size() / 3; ++v) {
    bytes.put(content.positions.subspan(3 * v, 3));
    if (!content.normals.empty()) bytes.put(content.normals.subspan(3 * v, 3));
    if (!content.colours.empty()) bytes.put(byteColour(content.colours.subspan(3 * v, 3)));
    if (shape.texcoords && shape.vertexTexcoords) bytes.put(texcoordOf(content, (*shape.vertexTexcoords)[v]));
  }
}

void putCount(PlyBytes& bytes, std::int32_t count, bool asLong) {
  if (asLong) return bytes.put(static_cast<std::uint32_t>(count));
  bytes.put(static_cast<std::uint8_t>(count));
}

template <class Real>
void putFaces(PlyBytes& bytes, const ObjContent<Real>& content, const PlyShape& shape) {
  for (std::size_t f = 0; f + 1 < content.faceOffsets.size(); ++f) {
    const std::int32_t first = content.faceOffsets[f], sides = content.faceOffsets[f + 1] - first;
    putCount(bytes, sides, shape.longLists);
    bytes.put(content.faceVertices.subspan(at(first), at(sides)));
    if (shape.vertexTexcoords) continue;
    putCount(bytes, 2 * sides, shape.longLists);
    for (const std::int32_t texcoord : content.cornerTexcoords.subspan(at(first), at(sides)))
      bytes.put(texcoordOf(content, texcoord));
  }
}

}  // namespace

template <class Real>
Result<void> writePly(const std::filesystem::path& path, const ObjContent<Real>& content) {
  if (Result<void> sound = checkContent(path, content); !sound) return sound;
  Result<OutputFile> file = OutputFile::create(path);
  if (!file) return tl::unexpected<Error>(file.error());
  const PlyShape shape = shapeOf(content);
  if (Result<void> written = file->write(plyHeader(content, shape)); !written) return written;
  PlyBytes bytes(*file);
  putVertices(bytes, content, shape);
  putFaces(bytes, content, shape);
  return bytes.commit();
}

template Result<void> writePly(const std::filesystem::path&, const ObjContent<float>&);
template Result<void> writePly(const std::filesystem::path&, const ObjContent<double>&);

}  // namespace honeycomb::Io
