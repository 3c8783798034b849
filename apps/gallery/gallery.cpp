#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "apps/gallery/plates.h"
#include "io/output_file.h"
#include "io/png.h"
#include "osd/vulkan/context.h"

namespace honeycomb::Gallery {
namespace {

std::vector<Plate> allPlates() {
  std::vector<Plate> plates;
  for (const auto& some :
       {aklemanPlates(), configurationPlates(), halfBoxPlates(), zhangWangPlates(), finnPlates(), texturedPlates()}) {
    plates.insert(plates.end(), some.begin(), some.end());
  }
  return plates;
}

/// 32 levels a channel: too few to see the difference, and a third of the file.
void coarsen(Viewer::Picture& picture) {
  for (std::uint8_t& byte : picture.rgba) {
    const unsigned level = (byte + 4U - byte / 64U) / 8U;
    byte = static_cast<std::uint8_t>(std::min(255U, level * 255U / 31U));
  }
}

std::string fileName(const Plate& plate) {
  return std::string(plate.name) + ".png";
}

Result<void> draw(const Osd::VulkanDevice& device, const Plate& plate, const std::filesystem::path& folder) {
  auto picture = plate.draw(device);
  if (!picture) return tl::unexpected(picture.error());
  coarsen(*picture);
  const std::filesystem::path file = folder / fileName(plate);
  auto saved = Io::writePng(file, picture->width, picture->height, picture->rgba);
  if (saved) std::cout << "wrote " << file.string() << '\n';
  return saved;
}

Result<void> writeCaptions(std::span<const Plate> plates, const std::filesystem::path& folder) {
  std::string text =
      "# Gallery\n\nThe papers' figures, all schemes on one mesh, and a textured character, drawn by this library. "
      "`./gallery` at the\nroot of the repository draws them and writes this page. What is drawn follows the papers' "
      "texts.\n\nTiles are named row by row. Colours tell the sides of faces, where there is no texture: triangles "
      "amber, quads orange,\npentagons red, hexagons green, heptagons blue, all larger ones dark blue. Hexagons of "
      "refined meshes are tinted by the\ncontrol face they descend from, and pale round control vertices.\n";
  for (const Plate& plate : plates) {
    text += fmt::format("\n## {0}\n\n![{0}]({1})\n\n{2}\n", plate.title, fileName(plate), plate.caption);
  }
  auto file = Io::OutputFile::create(folder / "README.md");
  if (!file) return tl::unexpected(file.error());
  return file->write(std::string_view(text)).and_then([&file] { return file->commit(); });
}

/// All plates, or those named.
Result<void> run(const std::filesystem::path& folder, std::span<const std::string> names) {
  const std::vector<Plate> plates = allPlates();
  for (const std::string& name : names) {
    if (std::ranges::none_of(plates, [&](const Plate& plate) { return plate.name == name; })) {
      return fail(ErrorCode::invalidOption,
                  fmt::format("there is no picture '{}'; the README of the gallery lists all", name));
    }
  }
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) {
    return fail(ErrorCode::unwritable, fmt::format("{}: {}; give another folder", folder.string(), failure.message()));
  }
  const auto context = Osd::VulkanContext::create();
  if (!context) return tl::unexpected(context.error());
  if (!context->supportsGraphics()) {
    return fail(ErrorCode::unsupported, context->deviceName() + " computes but does not draw; choose another device");
  }
  for (const Plate& plate : plates) {
    if (!names.empty() && std::ranges::find(names, plate.name) == names.end()) continue;
    if (auto drawn = draw(context->device(), plate, folder); !drawn) return drawn;
  }
  return writeCaptions(plates, folder);
}

}  // namespace
}  // namespace honeycomb::Gallery

int main(int argumentCount, char** arguments) {
  if (argumentCount < 2) {
    std::cerr << "usage: honeycomb_gallery OUTDIR [PICTURE...]\n";
    return 2;
  }
  try {
    const std::vector<std::string> names(arguments + 2, arguments + argumentCount);
    const auto done = honeycomb::Gallery::run(arguments[1], names);
    if (done) return 0;
    std::cerr << "error: " << done.error().message << '\n';
  } catch (const std::exception& failure) {
    std::cerr << "error: " << failure.what() << '\n';
  }
  return 1;
}
