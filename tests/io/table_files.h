#pragma once

#include <span>
#include <string>

#include "tests/io/files.h"
#include "tests/io/table_bytes.h"
#include "tests/support/refined.h"

/// Table files that are written and read back.
namespace honeycomb::Io::Test {

/// A step a level, and positions.
inline TableInfo infoOf(const Far::Refinement& refinement) {
  TableInfo info;
  info.meshHash = 0x0123456789abcdef;
  info.inputVertices = refinement.level(0).topology.vertexCount();
  info.inputFaces = refinement.level(0).topology.faceCount();
  info.steps.assign(at(refinement.levelCount()), "akleman --tension paper");
  info.primvars = {{"positions", 3}, {"texture coordinates", 2}};
  return info;
}

/// The bytes of the file that is written.
inline Bytes tableBytes(const Far::Refinement& refinement, const Far::TileTable* tiles = nullptr) {
  const TemporaryFolder folder;
  honeycomb::Test::must(writeTableFile(folder / "a.hct", {refinement, tiles, infoOf(refinement)}));
  const std::string text = readBytes(folder / "a.hct");
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

}  // namespace honeycomb::Io::Test
