#include "apps/gallery/sheet.h"

#include "apps/viewer/contact_sheet.h"
#include "far/base/index.h"

namespace honeycomb::Gallery {
namespace {

/// Drawn this many times as large and averaged down: the grain that soft shadows have goes, and files get small.
constexpr std::int32_t kOversize = 2;

Viewer::Picture averaged(const Viewer::Picture& large) {
  Viewer::Picture small{large.width / kOversize, large.height / kOversize, {}};
  small.rgba.reserve(large.rgba.size() / (kOversize * kOversize));
  for (std::int32_t y = 0; y < small.height; ++y) {
    for (std::int32_t x = 0; x < small.width; ++x) {
      for (std::int32_t channel = 0; channel < 4; ++channel) {
        std::int32_t sum = kOversize * kOversize / 2;
        for (std::int32_t i = 0; i < kOversize * kOversize; ++i) {
          const std::int32_t row = kOversize * y + i / kOversize;
          sum += large.rgba[at(4 * (row * large.width + kOversize * x + i % kOversize) + channel)];
        }
        small.rgba.push_back(static_cast<std::uint8_t>(sum / (kOversize * kOversize)));
      }
    }
  }
  return small;
}

}  // namespace

Sheet::Sheet(const Osd::VulkanDevice& device, Viewer::RendererOptions tile, std::int32_t columns)
    : renderer_(Viewer::Renderer::create(device, {kOversize * tile.width, kOversize * tile.height})),
      aspect_(static_cast<float>(tile.width) / static_cast<float>(tile.height)),
      columns_(columns) {
  if (!renderer_) error_ = renderer_.error();
  view_.style.edgeWidth = kOversize;
  view_.style.ground = false;
  view_.style.backdropCentre = view_.style.backdropRim = Viewer::Rgb{0xf4f2ee};
}

void Sheet::frame(std::span<const float> points, glm::vec3 direction, float margin) {
  view_.bounds = Viewer::boundsOf(points);
  view_.camera = Viewer::frameAll(points, direction, aspect_, 0.35F, margin);
}

void Sheet::add(const Result<Model>& model) {
  if (error_) return;
  const Result<Viewer::Picture> picture = model ? draw(*model) : tl::unexpected(model.error());
  if (picture) {
    pictures_.push_back(*picture);
  } else {
    error_ = picture.error();
  }
}

Result<Viewer::Picture> Sheet::draw(const Model& model) {
  const auto cells = renderer_->upload({model.pointCount(), model.faceOffsets, model.corners, model.colours});
  if (!cells) return tl::unexpected(cells.error());
  const auto points = renderer_->uploadPoints(model.points);
  if (!points) return tl::unexpected(points.error());
  const auto normals = renderer_->uploadPoints(model.normals);
  if (!normals) return tl::unexpected(normals.error());
  Viewer::View view = view_;
  view.style.faceted = model.faceted;
  const auto picture = renderer_->draw(*cells, {points->get(), 0, 3}, {normals->get(), 0, 3}, view);
  return picture ? averaged(*picture) : picture;
}

Result<Viewer::Picture> Sheet::finish() const {
  if (error_) return tl::unexpected(*error_);
  Viewer::SheetLayout layout;
  layout.columns = columns_;
  layout.gap = 6;
  return contactSheet(pictures_, layout);
}

}  // namespace honeycomb::Gallery
