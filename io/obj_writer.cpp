#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string_view>

#include "io/mesh_content.h"
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
  Result<void> sound = checkContent(path, content);
  if (!sound) return sound;
  Result<OutputFile> file = OutputFile::create(path);
  if (!file) return tl::unexpected<Error>(file.error());
  return writeTo(*file, content);
}

template Result<void> writeObj(const std::filesystem::path&, const ObjContent<float>&);
template Result<void> writeObj(const std::filesystem::path&, const ObjContent<double>&);

}  // namespace honeycomb::Io
