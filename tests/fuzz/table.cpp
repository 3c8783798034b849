// Seeds: honeycomb table build MESH OUT --levels 1 --no-index-buffers, with and without --tiles, --limits.
#include <cstring>
#include <vector>

#include "tests/fuzz/targets.h"
#include "tests/io/table_bytes.h"

namespace honeycomb::Fuzz {
namespace {

/// The file with its size and the checksums of header and directory put right.
Io::Test::Bytes repaired(Io::Test::Bytes bytes) {
  if (bytes.size() < sizeof(Io::TableHeader)) return bytes;
  Io::TableHeader header = Io::Test::headerOf(bytes);
  header.fileBytes = bytes.size();
  std::memcpy(bytes.data(), &header, sizeof(header));
  Io::Test::repair(bytes);
  return bytes;
}

bool use(const Io::Test::Bytes& bytes) {
  const Result<void> used = Io::Test::useAll(bytes);
  expect(used || used.error().message.starts_with("a.hct:"), "a refusal names the file");
  if (!used) return false;
  // Wrong checksums of arrays alone are no harm to whoever uses them.
  static_cast<void>(Io::Test::readTable(bytes)->check());
  return true;
}

}  // namespace

bool table(Bytes bytes) {
  const auto* from = reinterpret_cast<const std::byte*>(bytes.data());
  const Io::Test::Bytes file(from, from + bytes.size());
  const bool sound = use(file);
  const bool taken = use(repaired(file));
  expect(taken || !sound, "what was right stays right");
  return taken;
}

}  // namespace honeycomb::Fuzz
