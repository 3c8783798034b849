#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "io/table_directory.h"
#include "tests/io/table_files.h"
#include "tests/support/shapes.h"

/// Files that are damaged, cut, or made by somebody who means harm.
namespace honeycomb::Io::Test {
namespace {

using honeycomb::Test::must;
using testing::HasSubstr;

/// A small file with everything in it: loose rows, limits, tiles with normals.
const Bytes& smallTable(Far::TileNormalKind normals) {
  static const auto make = [](Far::TileNormalKind kind) {
    const Far::Refinement refinement =
        honeycomb::Test::refined(honeycomb::Test::grid(2, 2),
                                 honeycomb::Test::schemeCase(honeycomb::Test::NamedTension::paper).scheme, 2, {}, true);
    const Far::TileTable tiles = must(Far::buildTileTable(refinement, {.scratchPoints = 64, .normals = kind}));
    return tableBytes(refinement, &tiles);
  };
  static const Bytes fast = make(Far::TileNormalKind::fast);
  static const Bytes exact = make(Far::TileNormalKind::exact);
  return normals == Far::TileNormalKind::fast ? fast : exact;
}
const Bytes& smallTable() {
  return smallTable(Far::TileNormalKind::exact);
}
/// With exact normals that are found going round faces.
const Bytes& ringTable() {
  static const Bytes bytes = [] {
    const Far::Refinement refinement =
        honeycomb::Test::refined(honeycomb::Test::torus(3, 3),
                                 honeycomb::Test::schemeCase(honeycomb::Test::NamedTension::paper).scheme, 2, {}, true);
    const Far::TileTable tiles = must(Far::buildTileTable(
        refinement, {.scratchPoints = 512, .normals = Far::TileNormalKind::exact, .places = Far::TilePlaces::fours}));
    EXPECT_FALSE(tiles.limits.rings.empty());
    return tableBytes(refinement, &tiles);
  }();
  return bytes;
}

std::string messageOf(const Bytes& bytes) {
  const Result<void> used = useAll(bytes);
  return used ? "" : used.error().message;
}

/// Where a section begins.
std::size_t placeOf(const Bytes& bytes, std::string_view name) {
  for (std::size_t i = 0; i < headerOf(bytes).sectionCount; ++i) {
    if (sectionName(entryOf(bytes, i)) == name) return entryOf(bytes, i).offset;
  }
  ADD_FAILURE() << "no section " << name;
  return 0;
}

TEST(TableFaults, AreNoneInASoundFile) {
  EXPECT_EQ(messageOf(smallTable()), "");
  EXPECT_EQ(messageOf(smallTable(Far::TileNormalKind::fast)), "");
  EXPECT_EQ(messageOf(ringTable()), "");
}

TEST(TableFaults, EveryByteOfHeaderAndDirectoryIsGuarded) {
  const Bytes& sound = smallTable();
  const std::size_t end = sizeof(TableHeader) + headerOf(sound).sectionCount * sizeof(TableEntry);
  Bytes bytes = sound;
  for (std::size_t i = 0; i < end; ++i) {
    bytes[i] ^= std::byte{0x41};
    EXPECT_FALSE(readTable(bytes)) << "byte " << i;
    bytes[i] = sound[i];
  }
}

TEST(TableFaults, EveryByteOfHeaderAndDirectoryMayLieUnderRightChecksums) {
  const Bytes& sound = smallTable();
  const std::size_t end = sizeof(TableHeader) + headerOf(sound).sectionCount * sizeof(TableEntry);
  constexpr std::array kFlips = {std::byte{0x01}, std::byte{0x80}, std::byte{0xff}};
  for (std::size_t i = 0; i < end; ++i) {
    Bytes bytes = sound;
    bytes[i] ^= kFlips[i % kFlips.size()];
    repair(bytes);
    static_cast<void>(useAll(bytes));
  }
}

TEST(TableFaults, CutAtEveryLength) {
  const Bytes& sound = smallTable();
  for (std::size_t length = 0; length < sound.size(); ++length) {
    const auto kept = std::make_shared<const Bytes>(sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(length));
    ASSERT_FALSE(TableFile::read(*kept, kept, "a.hct")) << length << " bytes";
  }
  EXPECT_THAT(readTable({}).error().message, HasSubstr("a.hct: ends within the header"));
}

TEST(TableFaults, AFlippedByteIsFoundByItsSectionsChecksum) {
  const Bytes& sound = smallTable();
  for (std::size_t i = 0; i < headerOf(sound).sectionCount; ++i) {
    const TableEntry entry = entryOf(sound, i);
    Bytes bytes = sound;
    bytes[entry.offset + entry.count * entry.elementBytes - 1] ^= std::byte{0x10};
    const auto file = readTable(bytes);
    if (!file) continue;  // what open() reads is proven there
    const Result<void> checked = file->check();
    ASSERT_FALSE(checked) << sectionName(entry);
    EXPECT_THAT(checked.error().message, HasSubstr(sectionName(entry) + " at byte " + std::to_string(entry.offset)));
  }
}

/// Every word of every section in turn is a number that leads somewhere else; all numbers in all places are tried by
/// the fuzz target (tests/fuzz/table.cpp).
TEST(TableFaults, NoNumberLeadsOutOfTheFile) {
  constexpr std::array<std::int32_t, 3> kElsewhere = {-1, 1 << 20, std::numeric_limits<std::int32_t>::max()};
  std::int64_t refused = 0;
  for (const Bytes* table : {&smallTable(Far::TileNormalKind::fast), &smallTable(), &ringTable()}) {
    const Bytes& sound = *table;
    for (std::size_t i = 0; i < headerOf(sound).sectionCount; ++i) {
      const TableEntry entry = entryOf(sound, i);
      if (sectionName(entry).find("eights") != std::string::npos) continue;
      const std::size_t words = entry.count * entry.elementBytes / sizeof(std::int32_t);
      // The last words of long arrays tell nothing that the first ones don't.
      for (std::size_t w = 0; w < std::min<std::size_t>(words, 48); ++w) {
        const std::int32_t value = kElsewhere[w % kElsewhere.size()];
        Bytes bytes = sound;
        std::memcpy(bytes.data() + entry.offset + w * sizeof(value), &value, sizeof(value));
        if (!useAll(bytes)) ++refused;
      }
    }
  }
  EXPECT_GT(refused, 1000) << "what is refused is the rule";
}

TEST(TableFaults, NameTheFirstIndexThatIsWrong) {
  Bytes bytes = smallTable();
  const std::int32_t nowhere = 1'000'000;
  std::memcpy(bytes.data() + placeOf(bytes, "level 2 indices") + 5 * sizeof(nowhere), &nowhere, sizeof(nowhere));
  EXPECT_THAT(messageOf(bytes), HasSubstr("a.hct: level 2: index 5 is 1000000"));
  EXPECT_THAT(messageOf(bytes), HasSubstr("honeycomb table build"));
  EXPECT_TRUE(must(readTable(bytes, TableFile::Trust::file)).levels()) << "a file that is trusted isn't looked through";
}

TEST(TableFaults, ATileReadsNoPointThatItHasnt) {
  Bytes bytes = smallTable();
  const Far::TilePoint odd = 3;
  std::memcpy(bytes.data() + placeOf(bytes, "tileIndices"), &odd, sizeof(odd));
  EXPECT_THAT(messageOf(bytes), HasSubstr("tiles: tile 0: a step reads a point that the tile hasn't"));
}

TEST(TableFaults, ARingReadsNoPointThatItsTileHasnt) {
  Bytes bytes = ringTable();
  const Far::TilePoint far = 65534;
  std::memcpy(bytes.data() + placeOf(bytes, "exactWindows"), &far, sizeof(far));
  EXPECT_THAT(messageOf(bytes), HasSubstr("tiles: tile 0: a normal is of points that the tile hasn't"));
  bytes = ringTable();
  const std::int32_t elsewhere = 1'000'000;
  std::memcpy(bytes.data() + placeOf(bytes, "exactRings"), &elsewhere, sizeof(elsewhere));
  EXPECT_THAT(messageOf(bytes), HasSubstr("a normal is of a step that isn't there"));
}

TEST(TableFaults, PlacesOfBeforeAreNamed) {
  Bytes bytes = smallTable();
  const std::size_t places = placeOf(bytes, "tileCounts") + offsetof(TileRecord, places);
  for (const auto& [value, message] : {std::pair(kFormerFours, "its tiles keep their points as earlier programs did"),
                                       std::pair(3, "its tiles have counts of no tiles")}) {
    std::memcpy(bytes.data() + places, &value, sizeof(value));
    EXPECT_THAT(messageOf(bytes), HasSubstr(message));
  }
}

TEST(TableFaults, OnlyFoursHavePairs) {
  Bytes bytes = smallTable();
  bytes[placeOf(bytes, "tileSteps") + offsetof(Far::TileStep, pairs)] = std::byte{1};
  EXPECT_THAT(messageOf(bytes), HasSubstr("tiles: tile 0: a step's points are no pairs"));
  bytes[placeOf(bytes, "tileSteps") + offsetof(Far::TileStep, pairs)] = std::byte{2};
  EXPECT_THAT(messageOf(bytes), HasSubstr("tiles: step 0 has no such weights or pairs"));
}

TEST(TableFaults, TilesShareNoSteps) {
  Bytes bytes = smallTable();
  const std::size_t tiles = placeOf(bytes, "tiles");
  ASSERT_GT(placeOf(bytes, "tileSteps") - tiles, sizeof(Far::Tile) + 64) << "two tiles at least";
  std::memcpy(bytes.data() + tiles + sizeof(Far::Tile), bytes.data() + tiles, sizeof(Far::Tile));
  EXPECT_THAT(messageOf(bytes), HasSubstr("tiles: they take more of their arrays than there is"));
}

TEST(TableFaults, HugeCountsAllocateNothing) {
  for (const std::uint64_t count : {std::uint64_t{1} << 31U, std::uint64_t{1} << 40U, ~std::uint64_t{0}}) {
    Bytes bytes = smallTable();
    TableEntry entry = entryOf(bytes, 5);
    entry.count = count;
    setEntry(bytes, 5, entry);
    repair(bytes);
    EXPECT_THAT(messageOf(bytes), HasSubstr("doesn't lie in the file"));
  }
  Bytes bytes = smallTable();
  TableHeader header = headerOf(bytes);
  header.sectionCount = 0xffffffff;
  std::memcpy(bytes.data(), &header, sizeof(header));
  repair(bytes);
  EXPECT_THAT(messageOf(bytes), HasSubstr("ends within its directory"));
  header.fileBytes = std::uint64_t{3} << 30U;
  std::memcpy(bytes.data(), &header, sizeof(header));
  repair(bytes);
  EXPECT_THAT(messageOf(bytes), HasSubstr("should have 3221225472"));
}

TEST(TableFaults, MemoryAtAnOddPlaceIsRefused) {
  const auto kept = std::make_shared<Bytes>(smallTable());
  kept->insert(kept->begin(), std::byte{});
  EXPECT_THAT(TableFile::read(std::span(*kept).subspan(1), kept, "a.hct").error().message,
              HasSubstr("multiple of 8 bytes"));
}

TEST(TableFaults, AnotherFileIsNamed) {
  const TemporaryFolder folder;
  writeBytes(folder / "a.obj", std::string(200, 'v'));
  EXPECT_THAT(TableFile::open(folder / "a.obj").error().message, HasSubstr("is no table file (.hct)"));
}

/// A file with one section more, of kind 1000, in front of the others.
Bytes withNewSection(std::uint32_t flags) {
  Bytes bytes = smallTable();
  TableHeader header = headerOf(bytes);
  TableEntry added;
  added.kind = 1000;
  added.flags = flags;
  added.elementBytes = 1;
  added.neededVersion = 2;
  added.offset = (sizeof(header) + (header.sectionCount + 1) * sizeof(added));
  for (std::size_t i = 0; i < header.sectionCount; ++i) {
    TableEntry entry = entryOf(bytes, i);
    entry.offset += sizeof(TableEntry);
    setEntry(bytes, i, entry);
  }
  const auto* from = reinterpret_cast<const std::byte*>(&added);
  bytes.insert(bytes.begin() + sizeof(header), from, from + sizeof(added));
  ++header.sectionCount;
  header.fileBytes += sizeof(added);
  header.version = 2;
  std::memcpy(bytes.data(), &header, sizeof(header));
  repair(bytes);
  return bytes;
}

TEST(TableVersions, AReaderTakesTheVersionBefore) {
  EXPECT_TRUE(readDirectory(smallTable(), "a.hct", kTableVersion + 1));
  EXPECT_THAT(readDirectory(smallTable(), "a.hct", kTableVersion + 2).error().message,
              HasSubstr("is of version 1, which version 3 no longer reads"));
}

TEST(TableVersions, ANewerFileIsReadWhereItsWriterSaysSo) {
  EXPECT_EQ(messageOf(withNewSection(kOptionalSection)), "");
  EXPECT_THAT(messageOf(withNewSection(0)), HasSubstr("needs a reader of version 2"));
}

TEST(TableVersions, ANewerFileThatSaysNoIsRefused) {
  Bytes bytes = smallTable();
  TableHeader header = headerOf(bytes);
  header.version = header.neededVersion = 2;
  std::memcpy(bytes.data(), &header, sizeof(header));
  repair(bytes);
  EXPECT_THAT(messageOf(bytes), HasSubstr("needs a reader of version 2, this is 1; use a newer honeycomb"));
}

}  // namespace
}  // namespace honeycomb::Io::Test
