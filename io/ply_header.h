#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "far/base/result.h"

namespace honeycomb::Io {

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyEncoding : std::uint8_t { ascii, littleEndian, bigEndian };

/// Bytes of a number.
std::size_t plySize(PlyType type);
/// What a colour of a type is divided by: the largest of a whole type, 1 of others.
double plyWhite(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;  ///< of the value or of each of the list's
  bool isList = false;
  PlyType countType = PlyType::uint8;
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;

  /// The place of the property of that name, -1 where there is none.
  int find(std::string_view property, bool isList) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;   ///< of the header itself
  std::int64_t lines = 0;  ///< the same
};

/// Errors: invalidFile, naming the line.
Result<PlyHeader> readPlyHeader(std::string_view bytes, std::string_view name);

}  // namespace honeycomb::Io
