#include "io/obj_points.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "io/mapped_file.h"
#include "io/text_cursor.h"

namespace honeycomb::Io {
namespace {

tl::unexpected<Error> failAt(std::string_view name, std::int64_t line, std::string_view what) {
  return fail(ErrorCode::invalidFile, fmt::format("{}:{}: {}", name, line, what), line);
}

/// The numbers of a v statement, whose keyword has been read.
Result<void> readPoint(TextCursor& cursor, std::string_view name, ObjPoints& points) {
  const std::int64_t line = cursor.line();
  std::array<double, 3> point{};
  std::size_t count = 0;
  for (double excess = 0; !cursor.atStatementEnd(); ++count)
    if (!cursor.number(count < point.size() ? point[count] : excess))
      return failAt(name, cursor.line(), "a coordinate is not a number; write a decimal number such as -0.5 or 1e-3");
  if (count < point.size()) return failAt(name, line, fmt::format("a point has {} numbers; write v x y z", count));
  for (const double coordinate : point)
    if (!std::isfinite(coordinate))
      return fail(ErrorCode::invalidPositions,
                  fmt::format("{}:{}: point {} (counted from 1) has the coordinate {}; give it a finite position", name,
                              line, points.count() + 1, coordinate),
                  points.count());
  points.positions.insert(points.positions.end(), point.begin(), point.end());
  points.lines.push_back(line);
  return {};
}

}  // namespace

Result<ObjPoints> parseObjPoints(std::string_view text, std::string_view name) {
  if (text.find('\0') != std::string_view::npos)
    return fail(
        ErrorCode::invalidFile,
        fmt::format("{}: holds NUL bytes and so is no text; give a Wavefront OBJ file in ASCII or UTF-8", name));
  ObjPoints points;
  for (TextCursor cursor(text); cursor.nextStatement();) {
    if (cursor.word() != "v") {
      cursor.skipStatement();
    } else if (const Result<void> read = readPoint(cursor, name, points); !read) {
      return tl::unexpected(read.error());
    }
  }
  if (points.count() == 0)
    return fail(ErrorCode::invalidFile,
                fmt::format("{}: has no points ('v' statements); give a Wavefront OBJ file with v x y z lines", name));
  return points;
}

Result<ObjPoints> readObjPoints(const std::filesystem::path& path) {
  const Result<MappedFile> file = MappedFile::open(path);
  if (!file) return tl::unexpected(file.error());
  file->expectSequentialReads();
  return parseObjPoints(file->text(), path.string());
}

}  // namespace honeycomb::Io
