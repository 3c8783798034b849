#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <new>
#include <string>

#include "far/base/index.h"
#include "io/mapped_file.h"
#include "io/ply.h"
#include "io/ply_header.h"

namespace honeycomb::Io {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are turned round where the file's are not");

/// The numbers behind a header, one after another, in any encoding.
class PlyNumbers {
 public:
  PlyNumbers(std::string_view bytes, const PlyHeader& header)
      : bytes_(bytes), encoding_(header.encoding), at_(header.bytes), line_(header.lines + 1) {}

  bool isText() const { return encoding_ == PlyEncoding::ascii; }
  std::size_t byte() const { return at_; }
  std::int64_t line() const { return line_; }
  std::size_t bytesLeft() const { return bytes_.size() - at_; }

  /// False: the file ends, or there is no number.
  bool next(PlyType type, double& value) { return isText() ? nextWord(value) : nextBytes(type, value); }

 private:
  static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  bool nextWord(double& value) {
    for (; at_ < bytes_.size() && isBlank(bytes_[at_]); ++at_) line_ += bytes_[at_] == '\n' ? 1 : 0;
    const char* end = bytes_.data() + bytes_.size();
    const char* first = bytes_.data() + at_;
    if (first != end && *first == '+') ++first;
    const auto [stop, error] = std::from_chars(first, end, value);
    if (error == std::errc::result_out_of_range) value = std::numeric_limits<double>::infinity();
    if (error == std::errc::invalid_argument || (stop != end && !isBlank(*stop))) return false;
    at_ = static_cast<std::size_t>(stop - bytes_.data());
    return true;
  }

  bool nextBytes(PlyType type, double& value) {
    const std::size_t size = plySize(type);
    if (bytesLeft() < size) return false;
    std::array<char, 8> raw{};
    const char* first = bytes_.data() + at_;
    if (encoding_ == PlyEncoding::bigEndian) {
      std::reverse_copy(first, first + size, raw.data());
    } else {
      std::memcpy(raw.data(), first, size);
    }
    value = decoded(type, raw);
    at_ += size;
    return true;
  }

  template <class Number>
  static double as(const std::array<char, 8>& raw) {
    Number number;
    std::memcpy(&number, raw.data(), sizeof number);
    return static_cast<double>(number);
  }
  static double decoded(PlyType type, const std::array<char, 8>& raw) {
    switch (type) {
      case PlyType::int8:
        return as<std::int8_t>(raw);
      case PlyType::uint8:
        return as<std::uint8_t>(raw);
      case PlyType::int16:
        return as<std::int16_t>(raw);
      case PlyType::uint16:
        return as<std::uint16_t>(raw);
      case PlyType::int32:
        return as<std::int32_t>(raw);
      case PlyType::uint32:
        return as<std::uint32_t>(raw);
      case PlyType::float32:
        return as<float>(raw);
      case PlyType::float64:
        return as<double>(raw);
    }
    return 0;
  }

  std::string_view bytes_;
  PlyEncoding encoding_;
  std::size_t at_;
  std::int64_t line_;
};

class PlyParser {
 public:
  PlyParser(std::string_view bytes, std::string_view name, std::int64_t maxElements, PlyHeader header)
      : name_(name), maxElements_(maxElements), header_(std::move(header)), numbers_(bytes, header_) {}

  Result<Mesh> parse() {
    for (const PlyElement& element : header_.elements) {
      const auto read = element.name == "vertex" ? readVertices(element)
                        : element.name == "face" ? readFaces(element)
                                                 : skip(element);
      if (!read) return tl::unexpected(read.error());
    }
    if (mesh_.polygons.vertexCount == 0) return failFile("has no vertices; give a PLY file with a mesh");
    if (mesh_.polygons.faceCount() == 0) return failFile("has no faces; give a mesh of polygons");
    if (const auto sound = checkIndices(); !sound) return tl::unexpected(sound.error());
    if (mesh_.cornerTexcoords.empty() && !mesh_.texcoords.empty()) mesh_.cornerTexcoords = mesh_.polygons.indices;
    return std::move(mesh_);
  }

 private:
  tl::unexpected<Error> failFile(std::string_view what) const {
    return fail(ErrorCode::invalidFile, fmt::format("{}: {}", name_, what));
  }
  /// "FILE:LINE: ..", or in a binary file "FILE: vertex 3 (counted from 0, byte 120): ..".
  tl::unexpected<Error> failHere(std::string_view element, std::int64_t number, std::string_view what,
                                 ErrorCode code = ErrorCode::invalidFile) const {
    if (numbers_.isText()) return fail(code, fmt::format("{}:{}: {}", name_, numbers_.line(), what), numbers_.line());
    return fail(code,
                fmt::format("{}: {} {} (counted from 0, byte {}): {}", name_, element, number, numbers_.byte(), what),
                number);
  }

  /// The values of an element's properties: one each, or those of a list.
  Result<void> readRow(const PlyElement& element, std::int64_t number, std::vector<std::vector<double>>& row) {
    row.resize(element.properties.size());
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      double count = 1;
      if (property.isList && !numbers_.next(property.countType, count)) return failValue(element, number, property);
      // Each value takes a byte at least: a hostile count can't ask for more memory than the file has.
      if (!(count >= 0) || count != std::floor(count) || count > static_cast<double>(numbers_.bytesLeft()))
        return failValue(element, number, property);
      row[p].resize(static_cast<std::size_t>(count));
      for (double& value : row[p])
        if (!numbers_.next(property.type, value)) return failValue(element, number, property);
    }
    return {};
  }

  tl::unexpected<Error> failValue(const PlyElement& element, std::int64_t number, const PlyProperty& property) const {
    return failHere(
        element.name, number,
        fmt::format("the file ends, or '{}' is no number; export it again or copy it whole", property.name));
  }

  Result<void> skip(const PlyElement& element) {
    std::vector<std::vector<double>> row;
    for (std::int64_t i = 0; i < element.count && !element.properties.empty(); ++i)
      if (auto read = readRow(element, i, row); !read) return read;
    return {};
  }

  tl::unexpected<Error> failTooLarge(std::string_view what) const {
    return fail(ErrorCode::tooLarge, fmt::format("{}: more than {} {}; split the mesh", name_, maxElements_, what));
  }

  static int findEither(const PlyElement& element, std::initializer_list<std::string_view> names, bool isList) {
    for (const std::string_view name : names)
      if (const int place = element.find(name, isList); place >= 0) return place;
    return -1;
  }

  Result<void> readVertices(const PlyElement& element) {
    if (element.count > maxElements_) return failTooLarge("vertices");
    std::array<int, 3> xyz{}, rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
      xyz[i] = element.find(std::array{"x", "y", "z"}[i], false);
      rgb[i] = element.find(std::array{"red", "green", "blue"}[i], false);
      if (xyz[i] < 0) return failFile("its vertices have no x, y and z; give a PLY file with a mesh");
    }
    const bool coloured = *std::min_element(rgb.begin(), rgb.end()) >= 0;
    const int s = findEither(element, {"s", "u", "texture_u"}, false),
              t = findEither(element, {"t", "v", "texture_v"}, false);
    std::vector<std::vector<double>> row;
    for (std::int64_t v = 0; v < element.count; ++v) {
      if (auto read = readRow(element, v, row); !read) return read;
      if (numbers_.isText()) mesh_.vertexLines.push_back(numbers_.line());
      for (const int p : xyz) {
        const double coordinate = row[at(p)][0];
        if (!std::isfinite(coordinate))
          return failHere("vertex", v,
                          fmt::format("vertex {} (counted from 1) has the coordinate {}; give it a finite "
                                      "position",
                                      v + 1, coordinate),
                          ErrorCode::invalidPositions);
        mesh_.positions.push_back(coordinate);
      }
      for (const int p : rgb)
        if (coloured) mesh_.colours.push_back(row[at(p)][0] / plyWhite(element.properties[at(p)].type));
      if (s >= 0 && t >= 0) mesh_.texcoords.insert(mesh_.texcoords.end(), {row[at(s)][0], row[at(t)][0]});
    }
    mesh_.polygons.vertexCount = static_cast<std::int32_t>(element.count);
    return checkPrimvars();
  }

  Result<void> checkPrimvars() const {
    for (const auto* values : {&mesh_.colours, &mesh_.texcoords})
      if (!std::all_of(values->begin(), values->end(), [](double x) { return std::isfinite(x); }))
        return failFile("a colour or texture coordinate is not finite; give it finite numbers or remove it");
    return {};
  }

  Result<void> readFaces(const PlyElement& element) {
    const int indices = findEither(element, {"vertex_indices", "vertex_index"}, true);
    const int texcoords = element.find("texcoord", true);
    if (indices < 0) return failFile("its faces have no list vertex_indices; give a PLY file with a mesh");
    if (texcoords >= 0) mesh_.texcoords.clear();
    std::vector<std::vector<double>> row;
    for (std::int64_t f = 0; f < element.count; ++f) {
      if (auto read = readRow(element, f, row); !read) return read;
      const std::vector<double>& loop = row[at(indices)];
      if (loop.size() < 3)
        return failHere("face", f, fmt::format("a face has {} corners; write three or more", loop.size()));
      if (std::ssize(mesh_.polygons.indices) + std::ssize(loop) > maxElements_) return failTooLarge("face corners");
      if (numbers_.isText()) mesh_.faceLines.push_back(numbers_.line());
      for (const double v : loop) {
        if (!(v >= 0) || v != std::floor(v) || v >= static_cast<double>(maxElements_))
          return failHere("face", f, fmt::format("a face names vertex {}; count from 0", v));
        mesh_.polygons.indices.push_back(static_cast<std::int32_t>(v));
      }
      mesh_.polygons.faceOffsets.push_back(std::ssize(mesh_.polygons.indices));
      if (texcoords >= 0) addTexcoords(row[at(texcoords)], loop.size());
    }
    return checkPrimvars();
  }

  /// u v of each corner; corners have none where the list is of another length.
  void addTexcoords(const std::vector<double>& uv, std::size_t corners) {
    for (std::size_t k = 0; k < corners; ++k) {
      const bool has = uv.size() == 2 * corners;
      mesh_.cornerTexcoords.push_back(has ? static_cast<std::int32_t>(mesh_.texcoords.size() / 2) : -1);
      if (has) mesh_.texcoords.insert(mesh_.texcoords.end(), {uv[2 * k], uv[2 * k + 1]});
    }
  }

  Result<void> checkIndices() const {
    const Far::Polygons& polygons = mesh_.polygons;
    for (std::int64_t f = 0; f < polygons.faceCount(); ++f) {
      for (std::int64_t c = polygons.faceOffsets[at(f)]; c < polygons.faceOffsets[at(f) + 1]; ++c) {
        if (polygons.indices[at(c)] < polygons.vertexCount) continue;
        const std::int64_t line = mesh_.faceLines.empty() ? 0 : mesh_.faceLines[at(f)];
        return fail(
            ErrorCode::invalidFile,
            fmt::format("{}{}: face {} (counted from 0) names vertex {}, but there are {}; correct the index", name_,
                        line > 0 ? fmt::format(":{}", line) : "", f, polygons.indices[at(c)], polygons.vertexCount),
            line > 0 ? line : f);
      }
    }
    return {};
  }

  std::string_view name_;
  std::int64_t maxElements_;
  PlyHeader header_;
  PlyNumbers numbers_;
  Mesh mesh_;
};

}  // namespace

Result<Mesh> parsePly(std::string_view bytes, std::string_view name, std::int64_t maxElements) {
  try {
    Result<PlyHeader> header = readPlyHeader(bytes, name);
    if (!header) return tl::unexpected(header.error());
    return PlyParser(bytes, name, maxElements, std::move(*header)).parse();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::outOfMemory, fmt::format("{}: the mesh does not fit into memory; split it", name));
  }
}

Result<Mesh> readPly(const std::filesystem::path& path) {
  const Result<MappedFile> file = MappedFile::open(path);
  if (!file) return tl::unexpected(file.error());
  file->expectSequentialReads();
  return parsePly(file->text(), path.string());
}

}  // namespace honeycomb::Io
