#include "workplace.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>

namespace honeycomb::Test {

Workplace::Workplace() {
  std::string pattern = (std::filesystem::temp_directory_path() / "honeycomb-cli-XXXXXX").string();
  folder_ = mkdtemp(pattern.data());
}

Workplace::~Workplace() {
  std::filesystem::remove_all(folder_);
}

std::string Workplace::file(const std::string& name, const std::string& text) const {
  std::ofstream(path(name), std::ios::binary) << text;
  return path(name);
}

std::string Workplace::cache(const std::string& name, std::int32_t points, std::int32_t frames,
                             const std::vector<float>& numbers) const {
  std::ofstream out(path(name), std::ios::binary);
  const auto put = [&out](const auto& value) { out.write(reinterpret_cast<const char*>(&value), sizeof value); };
  out.write("POINTCACHE2", 12);
  put(std::int32_t{1});
  put(points);
  put(1.5F);
  put(0.5F);
  put(frames);
  for (const float number : numbers) put(number);
  return path(name);
}

std::string Workplace::read(const std::string& name) const {
  std::ifstream in(path(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::set<std::string> Workplace::listing() const {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) names.insert(entry.path().filename().string());
  return names;
}

std::string Workplace::bentCache(const std::string& name, const std::string& obj, std::int32_t frames) const {
  std::vector<float> numbers;
  for (std::int32_t f = 0; f < frames; ++f) {
    const std::vector<float> frame = bentFrame(obj, f);
    numbers.insert(numbers.end(), frame.begin(), frame.end());
  }
  return cache(name, static_cast<std::int32_t>(numbers.size()) / (3 * frames), frames, numbers);
}

std::string cubeObj() {
  return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
         "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

std::string gridObj(int n) {
  std::string text;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) text += fmt::format("v {} {} 0\n", double(x) / n, double(y) / n);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int v = y * (n + 1) + x + 1;
      text += fmt::format("f {} {} {} {}\n", v, v + 1, v + n + 2, v + n + 1);
    }
  return text;
}

std::string torusObj(int n) {
  std::string text;
  const double step = 2 * std::numbers::pi / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double radius = 2 + std::cos(j * step);
      text += fmt::format("v {} {} {}\n", radius * std::cos(i * step), radius * std::sin(i * step), std::sin(j * step));
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int below = (i + 1) % n, right = (j + 1) % n;
      text +=
          fmt::format("f {} {} {} {}\n", i * n + j + 1, below * n + j + 1, below * n + right + 1, i * n + right + 1);
    }
  return text;
}

std::vector<float> bentFrame(const std::string& obj, int f) {
  std::vector<float> numbers;
  std::istringstream in(obj);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("v ")) continue;
    std::istringstream words(line.substr(2));
    double x = 0, y = 0, z = 0;
    words >> x >> y >> z;
    const double angle = 0.37 * f * (1 + z);
    numbers.push_back(static_cast<float>(x * std::cos(angle) - y * std::sin(angle)));
    numbers.push_back(static_cast<float>(x * std::sin(angle) + y * std::cos(angle)));
    numbers.push_back(static_cast<float>(z + 0.1 * f * x));
  }
  return numbers;
}

std::string withPositions(const std::string& obj, const std::vector<float>& positions) {
  std::string text;
  for (std::size_t i = 0; i < positions.size(); i += 3)
    text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", positions[i], positions[i + 1], positions[i + 2]);
  return text + obj.substr(obj.find("f "));
}

}  // namespace honeycomb::Test
