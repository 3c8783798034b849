#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/golden.h"
#include "tests/support/sha256.h"

namespace honeycomb::Test {
namespace {

TEST(Sha256, GivesTheStandardsExamples) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(GoldenFiles, AreWhatTheManifestSays) {
  const auto manifest = readManifest();
  ASSERT_GE(manifest.size(), 77U);
  for (const ManifestLine& line : manifest) {
    const std::string bytes = readFile(goldenFolder() / line.file);
    ASSERT_FALSE(bytes.empty()) << line.file << " is missing or empty";
    EXPECT_EQ(sha256(bytes).substr(0, 16), line.hash) << line.file << " has changed";
  }
}

TEST(GoldenFiles, AreAllInTheManifest) {
  std::set<std::string> listed;
  for (const ManifestLine& line : readManifest()) listed.insert(line.file);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(goldenFolder())) {
    const std::string name = entry.path().lexically_relative(goldenFolder()).generic_string();
    if (!entry.is_regular_file() || name == "MANIFEST.csv") continue;
    EXPECT_TRUE(listed.contains(name)) << name << " is not in MANIFEST.csv";
  }
}

}  // namespace
}  // namespace honeycomb::Test
