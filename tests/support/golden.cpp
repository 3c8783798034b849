#include "tests/support/golden.h"

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

namespace honeycomb::Test {

std::filesystem::path goldenFolder() {
  return HONEYCOMB_TEST_DATA;
}

std::string readFile(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

PolyMesh readGoldenMesh(const std::string& name) {
  PolyMesh mesh;
  std::istringstream in(readFile(goldenFolder() / name));
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      std::string x;
      std::string y;
      std::string z;
      words >> x >> y >> z;
      mesh.points.push_back({std::stod(x), std::stod(y), std::stod(z)});
    } else if (kind == "f") {
      Loop loop;
      for (std::size_t number = 0; words >> number;) loop.push_back(number - 1);
      mesh.faces.push_back(loop);
    }
  }
  return mesh;
}

std::vector<std::vector<std::string>> readGoldenCsv(const std::string& name) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream in(readFile(goldenFolder() / name));
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || (lines.empty() && std::isalpha(static_cast<unsigned char>(line[0])) != 0)) continue;
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == ',') {
        cells.emplace_back();
      } else if (c != '\r') {
        cells.back().push_back(c);
      }
    }
    lines.push_back(std::move(cells));
  }
  return lines;
}

std::vector<ManifestLine> readManifest() {
  std::vector<ManifestLine> manifest;
  std::istringstream in(readFile(goldenFolder() / "MANIFEST.csv"));
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::array<std::string, 8> cells;
    std::istringstream rest(line);
    for (std::string& cell : cells) std::getline(rest, cell, ',');
    manifest.push_back({cells[0], cells[1], cells[2], cells[3], cells[4], cells[5], cells[6], cells[7]});
  }
  return manifest;
}

GoldenMeshName splitGoldenName(std::string_view file) {
  const std::size_t slash = file.find('/');
  const std::size_t mark = file.rfind("_L");
  if (slash == std::string_view::npos || mark == std::string_view::npos) return {};
  return {std::string(file.substr(0, slash)), std::string(file.substr(slash + 1, mark - slash - 1)),
          std::atoi(std::string(file.substr(mark + 2)).c_str())};
}

}  // namespace honeycomb::Test
