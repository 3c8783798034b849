#include "apps/demo/pictures.h"

#include <fmt/format.h>

#include <array>

#include "apps/viewer/contact_sheet.h"
#include "apps/viewer/surface_painter.h"
#include "io/png.h"

namespace honeycomb::Demo {
namespace {

constexpr Viewer::RendererOptions kPictureSize{1600, 1000};
constexpr Viewer::RendererOptions kTileSize{640, 400};

/// Where the cameras of the single pictures stand, as directions from the animal, which looks along x.
const std::array kSides{glm::vec3(1.0F, 0.50F, 0.80F), glm::vec3(0.12F, 1.0F, 0.30F), glm::vec3(0.35F, 0.28F, -1.0F),
                        glm::vec3(-0.85F, 0.60F, 0.75F)};
const glm::vec3 kSheetSide(0.75F, 0.62F, 0.80F);

float aspectOf(const Viewer::RendererOptions& size) {
  return static_cast<float>(size.width) / static_cast<float>(size.height);
}

Result<void> save(const std::filesystem::path& path, const Viewer::Picture& picture) {
  return Io::writePng(path, picture.width, picture.height, picture.rgba);
}

/// What is painted, kept together.
struct Studio {
  const Osd::VulkanDevice& device;
  const Osd::VulkanEvaluatorOptions& evaluation;
  const Animation& animation;
  const Far::Topology& control;
  const Far::Scheme& scheme;
  std::int32_t frameCount;

  std::int32_t frameAt(std::size_t i, std::size_t of) const {
    return static_cast<std::int32_t>(i * static_cast<std::size_t>(frameCount) / of);
  }
  Result<Viewer::SurfacePainter> painter(std::int32_t levels, const Viewer::RendererOptions& size) const {
    const auto refinement = Far::refine(control, scheme, levels, {.limits = true, .memoryLimit = 0});
    if (!refinement) return tl::unexpected(refinement.error());
    return Viewer::SurfacePainter::create(device, *refinement, size, evaluation);
  }
  Result<void> pose(Viewer::SurfacePainter& painter, std::int32_t frame) const {
    const auto points = animation.cache.frame(frame);
    return points ? painter.pose(*points) : Result<void>(tl::unexpected(points.error()));
  }
};

Result<std::vector<std::filesystem::path>> paintFrames(const Studio& studio, const PictureOptions& options) {
  auto painter = studio.painter(options.levels, kPictureSize);
  if (!painter) return tl::unexpected(painter.error());
  std::vector<std::filesystem::path> files;
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    const std::int32_t frame = studio.frameAt(i, kSides.size());
    if (const auto posed = studio.pose(*painter, frame); !posed) return tl::unexpected(posed.error());
    Viewer::View view;
    view.bounds = painter->bounds();
    view.camera = Viewer::frameAll(painter->points(), kSides[i], aspectOf(kPictureSize));
    const auto picture = painter->surface(view);
    if (!picture) return tl::unexpected(picture.error());
    files.push_back(options.folder / fmt::format("frame_{:03}.png", frame));
    if (const auto saved = save(files.back(), *picture); !saved) return tl::unexpected(saved.error());
  }
  return files;
}

/// The first frame's control mesh, then its surface at every level.
Result<std::vector<Viewer::Picture>> paintLevels(const Studio& studio, const Viewer::View& view, std::int32_t levels) {
  std::vector<Viewer::Picture> pictures;
  for (std::int32_t level = 1; level <= levels; ++level) {
    auto painter = studio.painter(level, kTileSize);
    if (!painter) return tl::unexpected(painter.error());
    if (const auto posed = studio.pose(*painter, 0); !posed) return tl::unexpected(posed.error());
    if (level == 1) {
      auto cage = painter->cage(view);
      if (!cage) return tl::unexpected(cage.error());
      pictures.push_back(std::move(*cage));
    }
    auto surface = painter->surface(view);
    if (!surface) return tl::unexpected(surface.error());
    pictures.push_back(std::move(*surface));
  }
  return pictures;
}

/// `count` frames of the last level, after the first one.
Result<void> addMotion(const Studio& studio, const Viewer::View& view, std::int32_t levels, std::size_t count,
                       std::vector<Viewer::Picture>& pictures) {
  auto painter = studio.painter(levels, kTileSize);
  if (!painter) return tl::unexpected(painter.error());
  for (std::size_t i = 0; i < count; ++i) {
    if (auto posed = studio.pose(*painter, studio.frameAt(i + 1, count + 1)); !posed) return posed;
    auto picture = painter->surface(view);
    if (!picture) return tl::unexpected(picture.error());
    pictures.push_back(std::move(*picture));
  }
  return {};
}

Result<std::filesystem::path> paintSheet(const Studio& studio, const PictureOptions& options) {
  const auto points = allPoints(studio.animation, studio.frameCount);
  if (!points) return tl::unexpected(points.error());
  Viewer::View view;
  view.bounds = Viewer::boundsOf(*points);
  view.camera = Viewer::frameAll(*points, kSheetSide, aspectOf(kTileSize), 0.45F, 0.025F);
  view.style.edgeWidth = 1.0F;
  auto pictures = paintLevels(studio, view, options.levels);
  if (!pictures) return tl::unexpected(pictures.error());
  const std::size_t columns = pictures->size();
  const auto moved = addMotion(studio, view, options.levels, columns, *pictures);
  if (!moved) return tl::unexpected(moved.error());
  Viewer::SheetLayout layout;
  layout.columns = static_cast<std::int32_t>(columns);
  const std::filesystem::path file = options.folder / "sheet.png";
  if (const auto saved = save(file, contactSheet(*pictures, layout)); !saved) return tl::unexpected(saved.error());
  return file;
}

}  // namespace

Result<std::vector<std::filesystem::path>> paintPictures(const Osd::VulkanDevice& device,
                                                         const Osd::VulkanEvaluatorOptions& evaluation,
                                                         const Animation& animation, const Far::Topology& control,
                                                         const Far::Scheme& scheme, const PictureOptions& options) {
  const Studio studio{device, evaluation, animation, control, scheme, options.frameCount};
  auto files = paintFrames(studio, options);
  if (!files) return files;
  const auto sheet = paintSheet(studio, options);
  if (!sheet) return tl::unexpected(sheet.error());
  files->push_back(*sheet);
  return files;
}

}  // namespace honeycomb::Demo
