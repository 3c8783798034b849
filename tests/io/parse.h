#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/obj.h"

namespace honeycomb::Io::Test {

/// Parses a copy in a buffer of exactly the text's size, so that a sanitizer sees every read past its end.
inline Result<Mesh> parse(std::string_view text, std::int64_t maxElements = 2147483647) {
  const auto exact = std::make_unique<char[]>(text.size());
  std::copy(text.begin(), text.end(), exact.get());
  return parseObj({exact.get(), text.size()}, "mesh.obj", maxElements);
}

inline Mesh parsed(std::string_view text) {
  Result<Mesh> mesh = parse(text);
  if (mesh) return *std::move(mesh);
  ADD_FAILURE() << mesh.error().message;
  return {};
}

inline Error refusal(std::string_view text, std::int64_t maxElements = 2147483647) {
  Result<Mesh> mesh = parse(text, maxElements);
  if (!mesh) return mesh.error();
  ADD_FAILURE() << "accepted: " << text;
  return {};
}

inline std::string message(std::string_view text) {
  return refusal(text).message;
}

/// Three vertices, so that a test can add the face it is about.
constexpr std::string_view kTriangleVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

inline std::string withTriangle(std::string_view rest) {
  return std::string(kTriangleVertices).append(rest);
}

using Indices = std::vector<std::int32_t>;
using Numbers = std::vector<double>;

}  // namespace honeycomb::Io::Test
