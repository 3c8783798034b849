#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/io/scene/gltf_builder.h"

namespace honeycomb::Io::Test {

/// A closed box of six quads, cut into triangles that share no vertex, as exporters split seams: bent by six joints, of
/// which every corner of it has five (JOINTS_0 and JOINTS_1), and swollen by a morph target. Joint k hangs on joint
/// k - 1, turns about z and moves: see angle() and shift(). Corner c of the box is (c & 1, c >> 1 & 1, c >> 2).
struct Character {
  static constexpr int kJoints = 6;
  static constexpr double kSeconds = 2;

  static std::array<double, 3> corner(int c) { return {double(c & 1), double(c >> 1 & 1), double(c >> 2)}; }
  /// The weight of joint k at a corner: five of six, sum 1.
  static double weight(int c, int k) { return k == c % kJoints ? 0 : (1 + (c * 3 + k * 2) % 4) / sum(c); }
  /// At the end of the clip; at its start 0.
  static double angle(int k) { return 0.2 + 0.1 * k; }
  static double shift(int k) { return 0.5 - 0.25 * k; }
  static double bindShift(int k) { return 0.125 * k; }
  static std::array<double, 3> morph(int c) { return {0.25 * c, -0.5, 1.0 / (1 + c)}; }

  static std::string gltf();

 private:
  static double sum(int c) {
    double total = 0;
    for (int k = 0; k < kJoints; ++k) total += k == c % kJoints ? 0 : 1 + (c * 3 + k * 2) % 4;
    return total;
  }
};

inline std::string Character::gltf() {
  // Corners of the quads, counter-clockwise from outside, and their triangles.
  constexpr std::array<std::array<int, 4>, 6> kSides{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  std::vector<float> points, weights0, weights1, morphs, uvs;
  std::vector<std::uint8_t> joints0, joints1;
  std::vector<std::uint16_t> indices;
  for (const auto& side : kSides) {
    for (const int k : {0, 1, 2, 0, 2, 3}) {
      const int c = side[static_cast<std::size_t>(k)];
      indices.push_back(static_cast<std::uint16_t>(indices.size()));
      for (const double x : corner(c)) points.push_back(static_cast<float>(x));
      for (const double x : morph(c)) morphs.push_back(static_cast<float>(x));
      uvs.insert(uvs.end(), {k == 1 || k == 2 ? 1.0F : 0.0F, k >= 2 ? 1.0F : 0.0F});
      for (int j = 0; j < 8; ++j) {
        (j < 4 ? joints0 : joints1).push_back(static_cast<std::uint8_t>(j < kJoints ? j : 0));
        (j < 4 ? weights0 : weights1).push_back(j < kJoints ? static_cast<float>(weight(c, j)) : 0.0F);
      }
    }
  }
  GltfBuilder file;
  const auto text = [](int number) { return std::to_string(number); };
  std::string attributes = R"("POSITION":)" + text(file.floats(points, "VEC3", 3));
  attributes += R"(,"TEXCOORD_0":)" + text(file.floats(uvs, "VEC2", 2));
  attributes += R"(,"JOINTS_0":)" + text(file.add(joints0, "VEC4", 4));
  attributes += R"(,"JOINTS_1":)" + text(file.add(joints1, "VEC4", 4));
  attributes += R"(,"WEIGHTS_0":)" + text(file.floats(weights0, "VEC4", 4));
  attributes += R"(,"WEIGHTS_1":)" + text(file.floats(weights1, "VEC4", 4));
  const std::string index = text(file.add(indices, "SCALAR", 1)), target = text(file.floats(morphs, "VEC3", 3));
  std::vector<float> matrices;  // columns, as glTF has them: the inverse of bindShift along x
  for (int k = 0; k < kJoints; ++k) {
    double whole = 0;
    for (int j = 0; j <= k; ++j) whole += bindShift(j);
    matrices.insert(matrices.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, static_cast<float>(-whole), 0, 0, 1});
  }
  const std::string inverse = text(file.floats(matrices, "MAT4", 16));
  const std::string times = text(file.floats({0, static_cast<float>(kSeconds)}, "SCALAR", 1));
  std::string nodes = R"({"name":"body","mesh":0,"skin":0,"translation":[100,200,300]})", joints, channels, samplers;
  const auto channel = [&](const std::string& node, const std::string& path, int output) {
    const std::string number = text(static_cast<int>(std::count(samplers.begin(), samplers.end(), '{')));
    channels += (channels.empty() ? "" : ",") + std::string(R"({"sampler":)") + number + R"(,"target":{"node":)" +
                node + R"(,"path":")" + path + R"("}})";
    samplers +=
        (samplers.empty() ? "" : ",") + std::string(R"({"input":)") + times + R"(,"output":)" + text(output) + "}";
  };
  for (int k = 0; k < kJoints; ++k) {
    const auto bind = static_cast<float>(bindShift(k)), half = static_cast<float>(angle(k) / 2);
    nodes += R"(,{"name":"joint)" + text(k) + R"(","translation":[)" + std::to_string(bind) + ",0,0]" +
             (k + 1 < kJoints ? R"(,"children":[)" + text(k + 2) + "]" : "") + "}";
    joints += (k == 0 ? "" : ",") + text(k + 1);
    channel(text(k + 1), "rotation", file.floats({0, 0, 0, 1, 0, 0, std::sin(half), std::cos(half)}, "VEC4", 4));
    channel(text(k + 1), "translation", file.floats({bind, 0, 0, bind, static_cast<float>(shift(k)), 0}, "VEC3", 3));
  }
  channel("0", "weights", file.floats({0, 1}, "SCALAR", 1));
  return file.file(
      R"("scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[)" + nodes + R"(],"skins":[{"joints":[)" + joints +
      R"(],"inverseBindMatrices":)" + inverse + R"(}],"meshes":[{"name":"box","primitives":[{"attributes":{)" +
      attributes + R"(},"indices":)" + index + R"(,"targets":[{"POSITION":)" + target +
      R"(}]}]}],"animations":[{"name":"bend","channels":[)" + channels + R"(],"samplers":[)" + samplers + "]}]");
}

}  // namespace honeycomb::Io::Test
