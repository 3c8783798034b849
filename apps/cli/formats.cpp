#include "apps/cli/formats.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "apps/cli/chain.h"
#include "io/mdd.h"
#include "io/pc2.h"

namespace honeycomb::Cli {
namespace {

template <class Reader>
Result<std::shared_ptr<const Io::FrameSource>> openReader(const std::filesystem::path& path) {
  Result<Reader> reader = Reader::open(path);
  if (!reader) return tl::unexpected(reader.error());
  return std::make_shared<const Reader>(std::move(*reader));
}

constexpr std::array kCacheInputs{CacheInput{".pc2", openReader<Io::Pc2Reader>},
                                  CacheInput{".mdd", openReader<Io::MddReader>}};

template <class Table>
auto byExtension(const Table& table, std::string_view kind, const std::filesystem::path& path)
    -> Result<decltype(&table[0])> {
  const std::string extension = lowerExtension(path);
  for (const auto& format : table)
    if (format.name == extension) return &format;
  return fail(ErrorCode::invalidOption,
              fmt::format("{}: {} files end in {}; give a file of that kind", path.string(), kind, names(table)));
}

bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;
  if (std::filesystem::equivalent(a, b, ignored)) return true;
  return std::filesystem::absolute(a, ignored).lexically_normal() ==
         std::filesystem::absolute(b, ignored).lexically_normal();
}

}  // namespace

std::string animatedInputHelp() {
  return fmt::format("Control mesh ({}), or a mesh a frame: 'name_%04d.obj', 'name_*.ply'", meshInputNames());
}

Result<const CacheInput*> cacheInput(const std::filesystem::path& path) {
  return byExtension(kCacheInputs, "point cache", path);
}

Result<void> checkOutput(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs) {
  for (const std::filesystem::path& input : inputs) {
    if (sameFile(output, input))
      return fail(ErrorCode::invalidOption,
                  fmt::format("{}: would be written over what is read from it; give another output", output.string()));
  }
  std::error_code ignored;
  if (std::filesystem::is_directory(output, ignored))
    return fail(ErrorCode::unwritable, fmt::format("{}: is a folder; name a file in it", output.string()));
  const std::filesystem::path folder = output.has_parent_path() ? output.parent_path() : ".";
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    return fail(ErrorCode::unwritable,
                fmt::format("{}: can't be created: {}: {}; choose a folder that is there and can be written",
                            output.string(), folder.string(), std::generic_category().message(errno)));
  return {};
}

}  // namespace honeycomb::Cli
