#include "io/mesh_sequence.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "io/obj.h"
#include "tests/io/files.h"
#include "tests/io/parse.h"

namespace honeycomb::Io::Test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A triangle whose first vertex lies at x.
std::string triangleAt(int x) {
  return "v " + std::to_string(x) + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
}

std::string sequenceNames(const std::filesystem::path& pattern) {
  const auto files = sequenceFiles(pattern);
  if (!files) return files.error().message;
  std::string names;
  for (const auto& file : *files) names += file.filename().string() + " ";
  return names;
}

TEST(SequenceFiles, PatternsAndGlobsGoByNumber) {
  const TemporaryFolder folder;
  for (const char* name : {"a_9.obj", "a_10.obj", "a_11.obj", "b_009.obj", "b_010.obj", "a_10.obj.txt", "a_x.obj"})
    writeBytes(folder / name, "");
  EXPECT_EQ(sequenceNames(folder / "a_%d.obj"), "a_9.obj a_10.obj a_11.obj ");
  EXPECT_EQ(sequenceNames(folder / "b_%03d.obj"), "b_009.obj b_010.obj ");
  EXPECT_EQ(sequenceNames(folder / "a_[0-9]*.obj"), "a_9.obj a_10.obj a_11.obj ");
  EXPECT_EQ(sequenceNames(folder / "a_x*.obj"), "a_x.obj ");
  EXPECT_THAT(sequenceNames(folder / "c_%d.obj"), HasSubstr("no file has such a name"));
  EXPECT_THAT(sequenceNames(folder / "none" / "c_%d.obj"), HasSubstr("can't be read"));
}

TEST(SequenceFiles, NamesAreOnlyPatternsWhereNoFileHasThem) {
  const TemporaryFolder folder;
  writeBytes(folder / "100%d.obj", "");
  EXPECT_FALSE(isSequence(folder / "100%d.obj"));
  EXPECT_TRUE(isSequence(folder / "101%d.obj"));
  EXPECT_TRUE(isSequence(folder / "?.obj"));
  EXPECT_FALSE(isSequence(folder / "plain.obj"));
  EXPECT_FALSE(isSequence(folder / "half%.obj"));
}

TEST(SequenceFiles, MissingFramesAreNamed) {
  const TemporaryFolder folder;
  for (const int number : {1, 2, 4, 13}) writeBytes(folder / ("f" + std::to_string(number) + ".obj"), "");
  for (const char* pattern : {"f%d.obj", "f*.obj"})
    EXPECT_THAT(sequenceNames(folder / pattern),
                HasSubstr("9 frames of the sequence are missing: f3.obj, f5.obj, f6.obj, f7.obj, f8.obj, ..; supply"));
}

TEST(SequenceFiles, StepsOfOneSizeLeaveNothingMissing) {
  const TemporaryFolder folder;
  for (const char* name : {"f0005.obj", "f0010.obj", "f0015.obj"}) writeBytes(folder / name, "");
  EXPECT_EQ(sequenceNames(folder / "f%04d.obj"), "f0005.obj f0010.obj f0015.obj ");
}

class SequenceOfThree : public testing::Test {
 protected:
  SequenceOfThree() {
    for (int f = 0; f < 3; ++f) writeBytes(folder_ / ("f" + std::to_string(f) + ".obj"), triangleAt(f));
  }
  MeshSequence open() const {
    const auto files = sequenceFiles(folder_ / "f%d.obj");
    return {*files, *readObj(files->front()), readObj};
  }
  TemporaryFolder folder_;
};

TEST_F(SequenceOfThree, FramesAreThePositionsOfTheFiles) {
  const MeshSequence sequence = open();
  EXPECT_EQ(sequence.info().frameCount, 3);
  EXPECT_EQ(sequence.info().pointCount, 3);
  std::vector<float> storage;
  EXPECT_THAT(*sequence.frame(2, storage), ElementsAre(2, 0, 0, 1, 0, 0, 0, 1, 0));
  EXPECT_THAT(*sequence.frame(0, storage), ElementsAre(0, 0, 0, 1, 0, 0, 0, 1, 0));
  EXPECT_THAT(sequence.frame(3, storage).error().message, HasSubstr("has no frame 3"));
}

TEST_F(SequenceOfThree, AnotherTopologyNamesTheFrame) {
  const MeshSequence sequence = open();
  std::vector<float> storage;
  writeBytes(folder_ / "f1.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n");
  EXPECT_THAT(sequence.frame(1, storage).error().message,
              HasSubstr("f1.obj: frame 1 (counted from 0) has another face 1 (counted from 1) than"));
  writeBytes(folder_ / "f1.obj", triangleAt(1) + "v 5 5 5\n");
  EXPECT_THAT(sequence.frame(1, storage).error().message,
              HasSubstr("frame 1 (counted from 0) has 4 vertices, not 3 as"));
  writeBytes(folder_ / "f1.obj", triangleAt(1) + "f 1 2 3\n");
  EXPECT_THAT(sequence.frame(1, storage).error().message, HasSubstr("frame 1 (counted from 0) has 2 faces, not 1 as"));
  EXPECT_EQ(sequence.frame(1, storage).error().element, 1);
}

TEST_F(SequenceOfThree, ErrorsOfTheReaderAndOfPositionsName) {
  const MeshSequence sequence = open();
  std::vector<float> storage;
  writeBytes(folder_ / "f2.obj", "v 0 0 x\n");
  EXPECT_THAT(sequence.frame(2, storage).error().message, HasSubstr("f2.obj:1: "));
  writeBytes(folder_ / "f2.obj", "v 0 0 0\nv 1 1e300 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_THAT(sequence.frame(2, storage).error().message, HasSubstr("vertex 1 of frame 2 (both counted from 0)"));
  std::filesystem::remove(folder_ / "f2.obj");
  EXPECT_EQ(sequence.frame(2, storage).error().code, ErrorCode::unreadable);
}

}  // namespace
}  // namespace honeycomb::Io::Test
