#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace honeycomb::Io::Test {

/// Puts a glTF file together: arrays go into one buffer, which is embedded as base64.
class GltfBuilder {
 public:
  /// The number of a new accessor. `type`: "SCALAR", "VEC3" ..; `width` its components.
  template <class Number>
  int add(const std::vector<Number>& values, const std::string& type, std::size_t width) {
    while (bytes_.size() % 4 != 0) bytes_ += '\0';
    const std::size_t offset = bytes_.size(), length = values.size() * sizeof(Number);
    bytes_.resize(offset + length);
    std::memcpy(bytes_.data() + offset, values.data(), length);
    append(views_, R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
                       std::to_string(length) + "}");
    append(accessors_, R"({"bufferView":)" + std::to_string(count_) + R"(,"componentType":)" + component(Number{}) +
                           R"(,"count":)" + std::to_string(values.size() / width) + R"(,"type":")" + type + R"("})");
    return count_++;
  }
  int floats(const std::vector<float>& values, const std::string& type, std::size_t width) {
    return add(values, type, width);
  }

  /// The file; `rest`: its other members, scenes, nodes, meshes, skins and animations.
  std::string file(const std::string& rest) const {
    return fileBeside("data:application/octet-stream;base64," + base64(), rest);
  }
  /// The same with its buffer, bytes(), under another URI.
  std::string fileBeside(const std::string& uri, const std::string& rest) const {
    return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + std::to_string(bytes_.size()) + R"(,"uri":")" +
           uri + R"("}],"bufferViews":[)" + views_ + R"(],"accessors":[)" + accessors_ + "]," + rest + "}";
  }
  const std::string& bytes() const { return bytes_; }

 private:
  static void append(std::string& list, const std::string& item) { list += (list.empty() ? "" : ",") + item; }
  static const char* component(float) { return "5126"; }
  static const char* component(std::uint16_t) { return "5123"; }
  static const char* component(std::uint8_t) { return "5121"; }

  std::string base64() const {
    constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes_.size(); i += 3) {
      std::uint32_t group = 0;
      for (std::size_t k = 0; k < 3; ++k)
        group = group << 8U | (i + k < bytes_.size() ? static_cast<unsigned char>(bytes_[i + k]) : 0U);
      for (std::size_t k = 0; k < 4; ++k) text += k <= bytes_.size() - i ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
  }

  std::string bytes_;
  std::string views_;
  std::string accessors_;
  int count_ = 0;
};

}  // namespace honeycomb::Io::Test
