#include "apps/viewer/shader_code.h"

namespace honeycomb::Viewer::ShaderCode {
namespace {
#include "shaders/backdrop.frag.h"
#include "shaders/backdrop.vert.h"
#include "shaders/cells.frag.h"
#include "shaders/cells.vert.h"
#include "shaders/lines.frag.h"
#include "shaders/lines.vert.h"
#include "shaders/shadow.vert.h"
}  // namespace

std::span<const std::uint32_t> shadowVertex() {
  return kShadowVert;
}
std::span<const std::uint32_t> cellsVertex() {
  return kCellsVert;
}
std::span<const std::uint32_t> cellsFragment() {
  return kCellsFrag;
}
std::span<const std::uint32_t> linesVertex() {
  return kLinesVert;
}
std::span<const std::uint32_t> linesFragment() {
  return kLinesFrag;
}
std::span<const std::uint32_t> backdropVertex() {
  return kBackdropVert;
}
std::span<const std::uint32_t> backdropFragment() {
  return kBackdropFrag;
}

}  // namespace honeycomb::Viewer::ShaderCode
