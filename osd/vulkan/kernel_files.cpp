#include "osd/vulkan/kernel_files.h"

#include <fmt/format.h>

#include <fstream>
#include <span>
#include <system_error>
#include <utility>

namespace honeycomb::Osd {

namespace {

using FileTime = std::filesystem::file_time_type;

/// Under which name a kernel's file lies in the folder; null: it has none.
const char* fileName(Kernel kernel) {
  switch (kernel) {
    case Kernel::circulant:
      return "circulant.comp.spv";
    case Kernel::projectedBlocks:
      return "projected_blocks.comp.spv";
    case Kernel::projectedSums:
      return "projected_sums.comp.spv";
    case Kernel::projected:
      return "projected.comp.spv";
    case Kernel::dense:
      return "dense.comp.spv";
    case Kernel::loose:
      return "loose.comp.spv";
    case Kernel::limits:
      return "limits.comp.spv";
    case Kernel::normals:
      return "normals.comp.spv";
    case Kernel::tileBuffer:
      return "tile_buffer.comp.spv";
    case Kernel::tileLong:
      return "tile_long.comp.spv";
    case Kernel::tileShared:
      return "tile_shared.comp.spv";
    case Kernel::zipFaceOf:
      return "zip_face_of.comp.spv";
    case Kernel::zipAround:
      return "zip_around.comp.spv";
    case Kernel::zipTurns:
      return "zip_turns.comp.spv";
    case Kernel::least:
      return "least.comp.spv";
    case Kernel::scanSums:
      return "scan_sums.comp.spv";
    case Kernel::scanPieces:
      return "scan_pieces.comp.spv";
    case Kernel::sortCounts:
      return "sort_counts.comp.spv";
    case Kernel::sortPlaces:
      return "sort_places.comp.spv";
    case Kernel::zipPlaces:
      return "zip_places.comp.spv";
    case Kernel::zipLoops:
      return "zip_loops.comp.spv";
    case Kernel::zipNumbers:
      return "zip_numbers.comp.spv";
    case Kernel::zipHexagons:
      return "zip_hexagons.comp.spv";
    case Kernel::zipTwins:
      return "zip_twins.comp.spv";
    default:
      return nullptr;
  }
}

/// The header and whole instructions to the end of a function, with which a module ends: a compiler may still be
/// writing the file.
bool wholeSpirv(std::span<const std::uint32_t> code) {
  constexpr std::uint32_t kSpirvMagic = 0x07230203;
  constexpr std::uint32_t kFunctionEnd = 1U << 16U | 56U;
  constexpr std::size_t kHeaderWords = 5;
  if (code.size() <= kHeaderWords || code.front() != kSpirvMagic || code.back() != kFunctionEnd) return false;
  std::size_t word = kHeaderWords;
  while (word < code.size() && code[word] >> 16U != 0) word += code[word] >> 16U;
  return word == code.size();
}

Result<std::vector<std::uint32_t>> readCode(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  std::vector<std::uint32_t> code(error ? 0 : static_cast<std::size_t>(bytes / sizeof(std::uint32_t)));
  std::ifstream stream(file, std::ios::binary);
  const auto wanted = static_cast<std::streamsize>(code.size() * sizeof(std::uint32_t));
  stream.read(reinterpret_cast<char*>(code.data()), wanted);
  const bool read = stream.good() && bytes % sizeof(std::uint32_t) == 0;
  if (read && wholeSpirv(code)) return code;
  return fail(ErrorCode::invalidFile,
              fmt::format("{}: isn't whole SPIR-V; compile it again with glslangValidator", file.string()));
}

}  // namespace

Result<KernelFiles> KernelFiles::watch(const std::filesystem::path& folder) {
  KernelFiles files;
  files.folder_ = folder;
  return files;
}

Result<std::vector<ChangedKernel>> KernelFiles::changed() {
  std::vector<ChangedKernel> kernels;
  auto times = seen_;
  for (std::uint32_t k = 0; k < kKernelCount && !folder_.empty(); ++k) {
    const char* const name = fileName(static_cast<Kernel>(k));
    if (name == nullptr) continue;
    std::error_code absent;
    const FileTime time = std::filesystem::last_write_time(folder_ / name, absent);
    if (absent || time == seen_[k]) continue;
    times[k] = time;
    auto code = readCode(folder_ / name);
    if (!code) {
      // Said once; what else has changed is found again by the next call.
      seen_[k] = time;
      return tl::unexpected(code.error());
    }
    kernels.push_back({static_cast<Kernel>(k), std::move(*code)});
  }
  seen_ = times;
  return kernels;
}

}  // namespace honeycomb::Osd
