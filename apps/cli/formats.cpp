#include "apps/cli/formats.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace honeycomb::Cli {
namespace {

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
