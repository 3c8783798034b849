#include "io/mapped_file.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/io/files.h"

namespace honeycomb::Io::Test {
namespace {

std::string mapRefusal(const std::filesystem::path& path) {
  const Result<MappedFile> file = MappedFile::open(path);
  if (!file) {
    EXPECT_EQ(file.error().code, ErrorCode::unreadable);
    return file.error().message;
  }
  ADD_FAILURE() << path << " was opened";
  return {};
}

TEST(MappedFile, ShowsTheBytesOfTheFile) {
  const TemporaryFolder folder;
  writeBytes(folder / "a", "some bytes");
  Result<MappedFile> file = MappedFile::open(folder / "a");
  ASSERT_TRUE(file) << file.error().message;
  const MappedFile moved = *std::move(file);
  EXPECT_EQ(moved.text(), "some bytes");
  EXPECT_EQ(moved.bytes().size(), 10U);
}

TEST(MappedFile, AnEmptyFileHasNoBytes) {
  const TemporaryFolder folder;
  writeBytes(folder / "a", "");
  const Result<MappedFile> file = MappedFile::open(folder / "a");
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_TRUE(file->bytes().empty());
  file->expectSequentialReads();
  file->release(0, 0);
}

TEST(MappedFile, ReleasedBytesStayReadable) {
  const TemporaryFolder folder;
  const std::string bytes(100000, 'x');
  writeBytes(folder / "a", bytes);
  const Result<MappedFile> file = MappedFile::open(folder / "a");
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->text(), bytes);
  file->release(5000, 95000);
  EXPECT_EQ(file->text(), bytes);
}

TEST(MappedFile, RefusesWhatIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(mapRefusal(folder.path()), folder.path().string() + ": cannot be read: Is a directory; name a file");
  EXPECT_EQ(mapRefusal("/dev/zero"), "/dev/zero: is neither a file nor a pipe; name a file");
  EXPECT_EQ(mapRefusal(""), ": cannot be read: No such file or directory; check the path");
  EXPECT_EQ(mapRefusal("/dev/null/a"), "/dev/null/a: cannot be read: Not a directory; check the path");
}

}  // namespace
}  // namespace honeycomb::Io::Test
