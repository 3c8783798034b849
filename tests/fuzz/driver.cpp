// The fuzz targets without libFuzzer: every seed, then mutations of them, the same in every run.
//     fuzz_test TARGET SEEDS ROUNDS     SEEDS: a folder of files, or one file
// What is being tried lies in TARGET.input, so that it can be tried again if the program ends there.
#include <fcntl.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "io/file_descriptor.h"
#include "tests/fuzz/mutate.h"
#include "tests/fuzz/targets.h"

namespace honeycomb::Fuzz {
namespace {

struct Target {
  const char* name;
  bool (*run)(Bytes);
};
constexpr Target kTargets[] = {{"obj", obj},      {"ply", ply},     {"pc2", pc2},
                               {"mdd", mdd},      {"table", table}, {"pipelines", pipelines},
                               {"arrays", arrays}};

File readFile(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The files of a folder, by name: in the same order on every machine.
std::vector<std::filesystem::path> filesOf(const std::filesystem::path& seeds) {
  if (!std::filesystem::is_directory(seeds)) return {seeds};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(seeds)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// Tries a target on one file after another.
class Trial {
 public:
  explicit Trial(const Target& target)
      : target_(target), input_(::open((std::string(target.name) + ".input").c_str(), O_CREAT | O_RDWR, 0644)) {}

  bool isTaken(const File& file) const {
    expect(::ftruncate(input_.get(), 0) == 0 && Io::writeAllAt(input_.get(), 0, std::as_bytes(std::span(file))),
           "what is tried can be written");
    // A copy of exactly its size: a mutated vector has room behind its end.
    return target_.run(File(file.begin(), file.end()));
  }

 private:
  const Target& target_;
  Io::FileDescriptor input_;
};

/// Files named sound* must be taken; what the others were found for is that they once did harm.
int drive(const Target& target, const std::filesystem::path& folder, std::uint64_t rounds) {
  const Trial trial(target);
  std::vector<File> seeds;
  for (const std::filesystem::path& path : filesOf(folder)) {
    seeds.push_back(readFile(path));
    const bool taken = trial.isTaken(seeds.back());
    if (taken || !path.filename().string().starts_with("sound")) continue;
    std::cerr << path << " is refused: if its format has changed, make it anew\n";
    return 1;
  }
  Test::Random random(1);
  std::uint64_t taken = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) taken += trial.isTaken(mutated(seeds, random)) ? 1 : 0;
  std::cout << target.name << ": " << seeds.size() << " seeds, " << rounds << " mutations, " << taken
            << " of them taken\n";
  // Where everything is refused at once, or nothing is, nothing is tried.
  return rounds == 0 || (taken > 0 && taken < rounds) ? 0 : 1;
}

}  // namespace
}  // namespace honeycomb::Fuzz

int main(int argc, char** argv) {
  for (const auto& target : honeycomb::Fuzz::kTargets) {
    if (argc == 4 && std::string(target.name) == argv[1])
      return honeycomb::Fuzz::drive(target, argv[2], std::stoull(argv[3]));
  }
  std::cerr << "usage: fuzz_test TARGET SEEDS ROUNDS\n";
  return 2;
}
