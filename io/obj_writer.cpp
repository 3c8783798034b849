#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "io/obj.h"
#include "io/output_file.h"

namespace honeycomb::Io {
namespace {

constexpr std::size_t kNumberBytes = 32;  // the longest: "-2.2250738585072014e-308"

/// A line under construction, handed to the file whole or, when long, in pieces.
class LineWriter {
 public:
  explicit LineWriter(OutputFile& file) : file_(file) {}

  void text(std::string_view piece) { end_ = std::copy(piece.begin(), piece.end(), end_); }
  template <class Real>
  void real(Real value) {
    end_ = std::to_chars(end_, limit(), value, std::chars_format::general, std::numeric_limits<Real>::max_digits10).ptr;
  }
  void integer(std::int64_t value) { end_ = std::to_chars(end_, limit(), value).ptr; }

  bool nearlyFull() { return limit() - end_ < static_cast<std::ptrdiff_t>(4 * kNumberBytes); }
  Result<void> flush() {
    const std::string_view line(line_.data(), static_cast<std::size_t>(end_ - line_.data()));
    end_ = line_.data();
    return file_.write(line);
  }

 private:
  char* limit() { return line_.data() + line_.size(); }

  OutputFile& file_;
  std::array<char, 16 * kNumberBytes> line_{};
  char* end_ = line_.data();
};

template <class Real>
Result<void> checkSizes(const ObjContent<Real>& content) {
  const auto& offsets = content.faceOffsets;
  const auto onePerVertex = [&](std::span<const Real> values) {
    return values.empty() || values.size() == content.positions.size();
  };
  const auto& cornerTexcoords = content.cornerTexcoords;
  const bool fit = content.positions.size() % 3 == 0 && onePerVertex(content.normals) &&
                   onePerVertex(content.colours) && content.texcoords.size() % 2 == 0 &&
                   (cornerTexcoords.empty() || cornerTexcoords.size() == content.faceVertices.size()) &&
                   !offsets.empty() && offsets.front() == 0 && std::is_sorted(offsets.begin(), offsets.end()) &&
                   static_cast<std::size_t>(offsets.back()) == content.faceVertices.size();
  if (fit) return {};
  return fail(ErrorCode::invalidOption,
              "the arrays of an OBJ do not fit together; give 3 numbers a vertex, 2 a texture coordinate, one texture "
              "coordinate a corner and faces + 1 ascending offsets");
}

/// Are all numbers of corners at least `least` and less than `count`?
Result<void> checkIndices(std::string_view what, std::span<const std::int32_t> corners, std::int32_t least,
                          std::size_t count, std::span<const std::int32_t> offsets) {
  const auto wrong = std::find_if(corners.begin(), corners.end(),
                                  [=](std::int32_t i) { return i < least || i >= static_cast<std::int64_t>(count); });
  if (wrong == corners.end()) return {};
  const auto face = std::upper_bound(offsets.begin(), offsets.end(), wrong - corners.begin()) - offsets.begin() - 1;
  return fail(ErrorCode::invalidMesh,
              fmt::format("face {} names {} {} of {}; correct the index", face, what, *wrong, count), face);
}

template <class Real>
Result<void> checkFinite(const std::filesystem::path& path, std::string_view what, std::span<const Real> values,
                         std::ptrdiff_t width) {
  const auto wrong = std::find_if(values.begin(), values.end(), [](Real value) { return !std::isfinite(value); });
  if (wrong == values.end()) return {};
  const auto element = (wrong - values.begin()) / width;
  return fail(ErrorCode::invalidPositions,
              fmt::format("{}: not written: the {} {} (counted from 0) has the coordinate {}; scale the mesh down or "
                          "compute in double precision",
                          path.string(), what, element, *wrong),
              element);
}

template <class Real>
Result<void> check(const std::filesystem::path& path, const ObjContent<Real>& c) {
  return checkSizes(c)
      .and_then([&] { return checkIndices("vertex", c.faceVertices, 0, c.positions.size() / 3, c.faceOffsets); })
      .and_then([&] {
        return checkIndices("texture coordinate", c.cornerTexcoords, -1, c.texcoords.size() / 2, c.faceOffsets);
      })
      .and_then([&] { return checkFinite(path, "position of vertex", c.positions, 3); })
      .and_then([&] { return checkFinite(path, "normal of vertex", c.normals, 3); })
      .and_then([&] { return checkFinite(path, "colour of vertex", c.colours, 3); })
      .and_then([&] { return checkFinite(path, "texture coordinate", c.texcoords, 2); });
}

/// Lines of `width` numbers behind a statement; `more` has three further numbers for each line, or none.
template <class Real>
Result<void> writeValues(LineWriter& line, std::string_view statement, std::span<const Real> values, std::size_t width,
                         std::span<const Real> more = {}) {
  for (std::size_t i = 0; i < values.size() / width; ++i) {
    line.text(statement);
    const auto put = [&line](std::span<const Real> numbers) {
      for (const Real number : numbers) {
        line.text(" ");
        line.real(number);
      }
    };
    put(values.subspan(i * width, width));
    if (!more.empty()) put(more.subspan(3 * i, 3));
    line.text("\n");
    if (Result<void> written = line.flush(); !written) return written;
  }
  return {};
}

/// v, v/vt, v//vn or v/vt/vn; the normal of a vertex has the vertex's number.
template <class Real>
void putCorner(LineWriter& line, const ObjContent<Real>& content, std::size_t c) {
  const std::int64_t vertex = std::int64_t{content.faceVertices[c]} + 1;
  const std::int64_t texcoord = content.cornerTexcoords.empty() ? 0 : std::int64_t{content.cornerTexcoords[c]} + 1;
  line.text(" ");
  line.integer(vertex);
  if (texcoord > 0 || !content.normals.empty()) line.text("/");
  if (texcoord > 0) line.integer(texcoord);
  if (content.normals.empty()) return;
  line.text("/");
  line.integer(vertex);
}

template <class Real>
Result<void> writeFaces(LineWriter& line, const ObjContent<Real>& content) {
  for (std::size_t f = 0; f + 1 < content.faceOffsets.size(); ++f) {
    line.text("f");
    for (std::int32_t c = content.faceOffsets[f]; c < content.faceOffsets[f + 1]; ++c) {
      putCorner(line, content, static_cast<std::size_t>(c));
      if (!line.nearlyFull()) continue;
      if (Result<void> written = line.flush(); !written) return written;
    }
    line.text("\n");
    if (Result<void> written = line.flush(); !written) return written;
  }
  return {};
}

template <class Real>
Result<void> writeTo(OutputFile& file, const ObjContent<Real>& content) {
  LineWriter line(file);
  return writeValues(line, "v", content.positions, 3, content.colours)
      .and_then([&] { return writeValues(line, "vt", content.texcoords, 2); })
      .and_then([&] { return writeValues(line, "vn", content.normals, 3); })
      .and_then([&] { return writeFaces(line, content); })
      .and_then([&] { return file.commit(); });
}

}  // namespace

template <class Real>
Result<void> writeObj(const std::filesystem::path& path, const ObjContent<Real>& content) {
  Result<void> sound = check(path, content);
  if (!sound) return sound;
  Result<OutputFile> file = OutputFile::create(path);
  if (!file) return tl::unexpected<Error>(file.error());
  return writeTo(*file, content);
}

template Result<void> writeObj(const std::filesystem::path&, const ObjContent<float>&);
template Result<void> writeObj(const std::filesystem::path&, const ObjContent<double>&);

}  // namespace honeycomb::Io
