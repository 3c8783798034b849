#include "apps/cli/bake_formats.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "apps/cli/chain.h"
#include "apps/cli/formats.h"
#include "io/glb_writer.h"
#include "io/mdd_writer.h"
#include "io/pc2.h"

namespace honeycomb::Cli {
namespace {

using Layout = Result<std::shared_ptr<const Io::FrameLayout>>;

Layout pc2(std::string_view name, const BakedMesh& mesh) {
  return Io::pc2Layout(name, mesh.info);
}

Layout mdd(std::string_view name, const BakedMesh& mesh) {
  return Io::mddLayout(name, mesh.info, mesh.framesPerSecond);
}

/// From 0 on: what plays it begins there.
Layout glb(std::string_view name, const BakedMesh& mesh) {
  Io::FrameInfo info = mesh.info;
  info.start = 0;
  info.rate = static_cast<float>(info.rate / mesh.framesPerSecond);
  return Io::glbLayout(name, mesh.content, info);
}

/// All frames in one file. A new one is one line.
struct SingleFileFormat {
  std::string_view name;
  bool storesMesh;
  Layout (*layout)(std::string_view name, const BakedMesh& mesh);
};
constexpr std::array kSingleFiles{SingleFileFormat{".pc2", false, pc2}, SingleFileFormat{".mdd", false, mdd},
                                  SingleFileFormat{".glb", true, glb}};

/// Null for a sequence, and for what isn't known. A mesh with a place for a number in its name is one of many.
const SingleFileFormat* singleFile(const std::filesystem::path& path) {
  const std::string extension = lowerExtension(path);
  if (Io::FrameNames::parse(path) && meshOutput(path)) return nullptr;
  for (const SingleFileFormat& format : kSingleFiles)
    if (format.name == extension) return &format;
  return nullptr;
}

}  // namespace

Result<void> checkBakeFormat(const std::filesystem::path& path) {
  if (singleFile(path) != nullptr) return {};
  if (Io::FrameNames::parse(path)) return meshOutput(path).map([](const MeshOutput*) {});
  return fail(ErrorCode::invalidOption,
              fmt::format("{}: baked files end in {}, or are a sequence of meshes such as {}; give one of these",
                          path.string(), names(kSingleFiles), "frame_%04d.obj"));
}

bool storesMesh(const std::filesystem::path& path) {
  const SingleFileFormat* single = singleFile(path);
  return single == nullptr || single->storesMesh;
}

Result<BakeFormat> bakeFormat(const std::filesystem::path& path, const BakedMesh& mesh) {
  if (const SingleFileFormat* single = singleFile(path))
    return single->layout(path.string(), mesh).map([](auto layout) { return BakeFormat{std::move(layout), nullptr}; });
  const Result<const MeshOutput*> format = meshOutput(path);
  if (!format) return tl::unexpected(format.error());
  const auto writeFrame = [&mesh, output = *format](const std::filesystem::path& file, std::span<const float> points) {
    Io::ObjContent<float> content = mesh.content;
    content.positions = points;
    return output->write(file, content);
  };
  const std::int32_t first = mesh.firstFrame;
  return BakeFormat{nullptr, std::make_shared<const Io::FrameSequence>(
                                 Io::FrameSequence{*Io::FrameNames::parse(path), first, mesh.info, writeFrame})};
}

BakedMesh bakedTimes(const Io::FrameInfo& animation, std::int32_t begin, std::int32_t frames, std::int32_t points) {
  BakedMesh mesh;
  mesh.firstFrame = begin;
  mesh.framesPerSecond = animation.playedAt();
  const double perUnit = animation.countsSeconds() ? mesh.framesPerSecond : 1;
  mesh.info.pointCount = points;
  mesh.info.frameCount = frames;
  mesh.info.start = static_cast<float>((animation.start + double{animation.rate} * begin) * perUnit);
  mesh.info.rate = static_cast<float>(animation.rate * perUnit);
  mesh.info.framesPerSecond = static_cast<float>(mesh.framesPerSecond);
  return mesh;
}

}  // namespace honeycomb::Cli
