#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/poly_mesh.h"

namespace honeycomb::Test {

/// tests/golden: meshes and arrays made by an independent implementation of the schemes.
std::filesystem::path goldenFolder();

/// A file's bytes; empty where it can't be read.
std::string readFile(const std::filesystem::path& path);

/// v and f statements of a golden OBJ file, in file order.
PolyMesh readGoldenMesh(const std::string& name);

/// The cells of a golden CSV file, line by line. A first line that starts with a letter is a heading and left out.
std::vector<std::vector<std::string>> readGoldenCsv(const std::string& name);

/// A line of MANIFEST.csv.
struct ManifestLine {
  std::string file;
  std::string options;
  std::string vertices, edges, faces, euler, boundaryEdges;  ///< empty for files that aren't refined meshes
  std::string hash;                                          ///< first 16 hexadecimal digits of the file's SHA-256
};
std::vector<ManifestLine> readManifest();

/// akleman/cube_L2.obj in its parts.
struct GoldenMeshName {
  std::string folder;  ///< akleman
  std::string shape;   ///< cube
  int level = 0;       ///< 2
};
GoldenMeshName splitGoldenName(std::string_view file);

}  // namespace honeycomb::Test
