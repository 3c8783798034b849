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
  const bool fit = content.positions.size() % 3 == 0 &&
                   (content.normals.empty() || content.normals.size() == content.positions.size()) &&
                   !offsets.empty() && offsets.front() == 0 && std::is_sorted(offsets.begin(), offsets.end()) &&
                   static_cast<std::size_t>(offsets.back()) == content.faceVertices.size();
  if (fit) return {};
  return fail(ErrorCode::invalidOption,
              "the arrays of an OBJ do not fit together; give 3 numbers a vertex and faces + 1 ascending offsets");
}

template <class Real>
Result<void> checkIndices(const ObjContent<Real>& content) {
  const auto vertexCount = static_cast<std::int64_t>(content.positions.size() / 3);
  const auto& corners = content.faceVertices;
  const auto wrong = std::find_if(corners.begin(), corners.end(), [=](auto v) { return v < 0 || v >= vertexCount; });
  if (wrong == corners.end()) return {};
  const auto& offsets = content.faceOffsets;
  const auto face = std::upper_bound(offsets.begin(), offsets.end(), wrong - corners.begin()) - offsets.begin() - 1;
  return fail(ErrorCode::invalidMesh,
              fmt::format("face {} names vertex {} of {}; correct the index", face, *wrong, vertexCount), face);
}

template <class Real>
Result<void> checkFinite(const std::filesystem::path& path, std::string_view what, std::span<const Real> values) {
  const auto wrong = std::find_if(values.begin(), values.end(), [](Real value) { return !std::isfinite(value); });
  if (wrong == values.end()) return {};
  const auto vertex = (wrong - values.begin()) / 3;
  return fail(ErrorCode::invalidPositions,
              fmt::format("{}: not written: the {} of vertex {} (counted from 0) has the coordinate {}; scale the mesh "
                          "down or compute in double precision",
                          path.string(), what, vertex, *wrong),
              vertex);
}

template <class Real>
Result<void> writePoints(LineWriter& line, std::string_view statement, std::span<const Real> values) {
  for (std::size_t i = 0; i < values.size(); i += 3) {
    line.text(statement);
    for (std::size_t k = 0; k < 3; ++k) {
      line.text(" ");
      line.real(values[i + k]);
    }
    line.text("\n");
    if (Result<void> written = line.flush(); !written) return written;
  }
  return {};
}

// The normal of a vertex has the vertex's number.
template <class Real>
Result<void> writeFaces(LineWriter& line, const ObjContent<Real>& content) {
  for (std::size_t f = 0; f + 1 < content.faceOffsets.size(); ++f) {
    line.text("f");
    for (std::int32_t c = content.faceOffsets[f]; c < content.faceOffsets[f + 1]; ++c) {
      const std::int64_t number = std::int64_t{content.faceVertices[static_cast<std::size_t>(c)]} + 1;
      line.text(" ");
      line.integer(number);
      if (!content.normals.empty()) {
        line.text("//");
        line.integer(number);
      }
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
  return writePoints(line, "v", content.positions)
      .and_then([&] { return writePoints(line, "vn", content.normals); })
      .and_then([&] { return writeFaces(line, content); })
      .and_then([&] { return file.commit(); });
}

}  // namespace

template <class Real>
Result<void> writeObj(const std::filesystem::path& path, const ObjContent<Real>& content) {
  Result<void> sound = checkSizes(content)
                           .and_then([&] { return checkIndices(content); })
                           .and_then([&] { return checkFinite(path, "position", content.positions); })
                           .and_then([&] { return checkFinite(path, "normal", content.normals); });
  if (!sound) return sound;
  Result<OutputFile> file = OutputFile::create(path);
  if (!file) return tl::unexpected<Error>(file.error());
  return writeTo(*file, content);
}

template Result<void> writeObj(const std::filesystem::path&, const ObjContent<float>&);
template Result<void> writeObj(const std::filesystem::path&, const ObjContent<double>&);

}  // namespace honeycomb::Io
