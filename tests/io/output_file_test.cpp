#include "io/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "io/file_descriptor.h"
#include "tests/io/files.h"

namespace honeycomb::Io::Test {
namespace {

namespace fs = std::filesystem;

OutputFile created(const fs::path& path) {
  Result<OutputFile> file = OutputFile::create(path);
  if (!file) throw std::runtime_error(file.error().message);
  return *std::move(file);
}

void writeWhole(const fs::path& path, std::string_view text) {
  OutputFile file = created(path);
  ASSERT_TRUE(file.write(text));
  const Result<void> committed = file.commit();
  ASSERT_TRUE(committed) << committed.error().message;
}

std::string openRefusal(const fs::path& path) {
  const Result<OutputFile> file = OutputFile::create(path);
  if (!file) {
    EXPECT_EQ(file.error().code, ErrorCode::unwritable);
    return file.error().message;
  }
  ADD_FAILURE() << path << " was opened";
  return {};
}

TEST(OutputFile, AppearsWithCommitOnly) {
  const TemporaryFolder folder;
  OutputFile file = created(folder / "a");
  ASSERT_TRUE(file.write("some "));
  EXPECT_FALSE(fs::exists(folder / "a"));
  ASSERT_TRUE(file.write("text"));
  ASSERT_TRUE(file.commit());
  EXPECT_EQ(readBytes(folder / "a"), "some text");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(OutputFile, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  writeBytes(folder / "a", "before");
  { ASSERT_TRUE(created(folder / "a").write("half")); }
  EXPECT_EQ(readBytes(folder / "a"), "before");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(OutputFile, KeepsTheOrderOfSmallAndLargePieces) {
  const TemporaryFolder folder;
  OutputFile file = created(folder / "a");
  std::string expected;
  for (const std::size_t size : {1U, 1000000U, 7U, 262143U, 1U, 1U, 262144U, 100000U, 100000U, 100000U}) {
    const std::string piece(size, static_cast<char>('a' + expected.size() % 26));
    ASSERT_TRUE(file.write(piece));
    expected += piece;
  }
  ASSERT_TRUE(file.commit());
  EXPECT_TRUE(readBytes(folder / "a") == expected);
}

TEST(OutputFile, NewFilesFollowTheUmask) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  writeWhole(folder / "a", "x");
  ::umask(before);
  EXPECT_EQ(permissions(folder / "a"), 0640U);
}

TEST(OutputFile, ReplacedFilesKeepTheirPermissions) {
  const TemporaryFolder folder;
  writeBytes(folder / "a", "before");
  ASSERT_EQ(::chmod((folder / "a").c_str(), 0600), 0);
  writeWhole(folder / "a", "after");
  EXPECT_EQ(readBytes(folder / "a"), "after");
  EXPECT_EQ(permissions(folder / "a"), 0600U);
}

TEST(OutputFile, WritesThroughSymbolicLinks) {
  const TemporaryFolder folder;
  ASSERT_TRUE(fs::create_directory(folder / "real"));
  writeBytes(folder / "real/a", "before");
  fs::create_symlink("real/a", folder / "link");
  fs::create_symlink("link", folder / "linkToLink");
  writeWhole(folder / "linkToLink", "after");
  EXPECT_EQ(readBytes(folder / "real/a"), "after");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_TRUE(fs::is_symlink(folder / "linkToLink"));
  EXPECT_FALSE(fs::is_symlink(folder / "real/a"));
}

TEST(OutputFile, CreatesWhatADanglingLinkPointsAt) {
  const TemporaryFolder folder;
  fs::create_symlink(folder / "a", folder / "link");
  writeWhole(folder / "link", "new");
  EXPECT_EQ(readBytes(folder / "a"), "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
}

TEST(OutputFile, TakesNamesAsLongAsTheSystemDoes) {
  const TemporaryFolder folder;
  const std::string longest(255, 'n');
  writeWhole(folder / longest, "x");
  EXPECT_EQ(readBytes(folder / longest), "x");
  const std::string path = (folder / (longest + "n")).string();
  EXPECT_EQ(openRefusal(path), path + ": cannot be written: File name too long; check the path");
}

TEST(OutputFile, TakesNamesInTheCurrentFolder) {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  writeWhole("a", "x");
  fs::current_path(before);
  EXPECT_EQ(readBytes(folder / "a"), "x");
}

TEST(OutputFile, WritesOpenFilesInPlace) {
  const TemporaryFolder folder;
  const FileDescriptor open(::open((folder / "a").c_str(), O_RDWR | O_CREAT, 0600));
  ASSERT_EQ(::write(open.get(), "head ", 5), 5);
  writeWhole("/proc/self/fd/" + std::to_string(open.get()), "tail");
  std::array<char, 16> text{};
  ASSERT_EQ(::pread(open.get(), text.data(), text.size(), 0), 9);
  EXPECT_STREQ(text.data(), "head tail");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(OutputFile, WritesDevicesInPlace) {
  writeWhole("/dev/null", "x");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(OutputFile, FullDeviceIsAnErrorAtCommit) {
  OutputFile file = created("/dev/full");
  ASSERT_TRUE(file.write("little"));
  const Result<void> committed = file.commit();
  ASSERT_FALSE(committed);
  EXPECT_EQ(committed.error().code, ErrorCode::unwritable);
  EXPECT_EQ(committed.error().message,
            "/dev/full: cannot be written: No space left on device; free some space or choose another place");
}

TEST(OutputFile, FullDiskIsAnErrorAtWriteAndEverAfter) {
  const TemporaryFolder folder;
  writeBytes(folder / "a", "before");
  OutputFile file = created(folder / "a");
  const std::string expected =
      (folder / "a").string() + ": cannot be written: File too large; free some space or choose another place";
  {
    const FileSizeLimit limit(1000);
    const Result<void> written = file.write(std::string(1000000, 'x'));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().message, expected);
  }
  const Result<void> committed = file.commit();
  ASSERT_FALSE(committed);
  EXPECT_EQ(committed.error().message, expected);
  EXPECT_EQ(readBytes(folder / "a"), "before");
  file = created(folder / "b");
  EXPECT_FALSE(fs::exists(folder / "b"));
  EXPECT_EQ(folder.entries(), 2) << "the failed file's temporary is gone, that of the new one is there";
}

TEST(OutputFile, NothingCanBeWrittenAfterCommit) {
  const TemporaryFolder folder;
  OutputFile file = created(folder / "a");
  ASSERT_TRUE(file.commit());
  EXPECT_FALSE(file.write("x"));
  EXPECT_FALSE(file.commit());
  EXPECT_EQ(readBytes(folder / "a"), "");
}

TEST(OutputFile, RefusesFolders) {
  const TemporaryFolder folder;
  const std::string path = folder.path().string();
  EXPECT_EQ(openRefusal(path), path + ": cannot be written: Is a directory; name a file");
  EXPECT_EQ(openRefusal(path + "/new/"), path + "/new/: cannot be written: Is a directory; name a file");
}

TEST(OutputFile, RefusesPathsThatLeadNowhere) {
  const TemporaryFolder folder;
  const std::string missing = (folder / "no/a").string();
  EXPECT_EQ(openRefusal(missing), missing + ": cannot be written: No such file or directory; check the path");
  fs::create_symlink("loop", folder / "loop");
  const std::string loop = (folder / "loop").string();
  EXPECT_EQ(openRefusal(loop), loop + ": cannot be written: Too many levels of symbolic links; check the path");
  EXPECT_EQ(openRefusal("/dev/null/a"), "/dev/null/a: cannot be written: Not a directory; check the path");
  EXPECT_EQ(openRefusal(""), ": cannot be written: No such file or directory; check the path");
}

TEST(OutputFile, RefusesProtectedFilesAndFolders) {
  const TemporaryFolder folder;
  const std::string file = (folder / "a").string();
  writeBytes(file, "before");
  ASSERT_EQ(::chmod(file.c_str(), 0444), 0);
  ASSERT_TRUE(fs::create_directory(folder / "closed"));
  ASSERT_EQ(::chmod((folder / "closed").c_str(), 0555), 0);
  const std::string inside = (folder / "closed/a").string();
  {
    const Unprivileged guard;
    EXPECT_EQ(openRefusal(file), file + ": cannot be written: Permission denied; check the permissions");
    EXPECT_EQ(openRefusal(inside), inside + ": cannot be written: Permission denied; check the permissions");
  }
  EXPECT_EQ(readBytes(file), "before");
}

}  // namespace
}  // namespace honeycomb::Io::Test
