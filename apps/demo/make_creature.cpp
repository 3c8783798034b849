// make_creature OUT.obj OUT.pc2: writes the demo's animal, its cage in its first frame and all its frames.

#include <filesystem>
#include <iostream>
#include <span>

#include "apps/demo/creature.h"
#include "io/obj.h"
#include "io/pc2.h"

namespace honeycomb::Demo {
namespace {

Result<void> writeCage(const Creature& creature, const std::filesystem::path& path) {
  const Far::Polygons& polygons = creature.polygons();
  const std::vector<float> points = creature.frame(0);
  const std::vector<std::int32_t> offsets(polygons.faceOffsets.begin(), polygons.faceOffsets.end());
  return Io::writeObj<float>(path, {points, {}, offsets, polygons.indices});
}

Result<void> writeFrames(const Creature& creature, const std::filesystem::path& path) {
  const Io::FrameInfo info{creature.polygons().vertexCount, Creature::kFrameCount, 0.0F, 1.0F, 0.0F};
  Result<Io::Pc2Writer> writer = Io::Pc2Writer::create(path, info);
  if (!writer) return tl::unexpected(writer.error());
  for (std::int32_t i = 0; i < Creature::kFrameCount; ++i) {
    if (Result<void> written = writer->write(creature.frame(i)); !written) return written;
  }
  return writer->finish();
}

}  // namespace
}  // namespace honeycomb::Demo

int main(int argumentCount, char** arguments) {
  const std::span given(arguments, static_cast<std::size_t>(argumentCount));
  if (given.size() != 3) {
    std::cerr << "error: two files are needed: make_creature OUT.obj OUT.pc2\n";
    return 2;
  }
  const honeycomb::Demo::Creature creature;
  const honeycomb::Result<void> done = honeycomb::Demo::writeCage(creature, given[1]).and_then([&] {
    return honeycomb::Demo::writeFrames(creature, given[2]);
  });
  if (!done) {
    std::cerr << "error: " << done.error().message << '\n';
    return 1;
  }
  return 0;
}
