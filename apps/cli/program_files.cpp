#include "apps/cli/program_files.h"

#include <system_error>

namespace honeycomb::Cli {
namespace {

std::filesystem::path programFolder() {
  std::error_code unreadable;
  return std::filesystem::read_symlink("/proc/self/exe", unreadable).parent_path();
}

std::filesystem::path firstThatExists(const std::filesystem::path& one, const std::filesystem::path& other) {
  std::error_code ignored;
  return std::filesystem::exists(one, ignored) ? one : other;
}

}  // namespace

std::filesystem::path moduleFile(std::string_view name) {
  const std::filesystem::path folder = programFolder();
  return firstThatExists(folder / name, folder / HONEYCOMB_MODULE_FOLDER / name);
}

std::filesystem::path assetFile(std::string_view name) {
  return firstThatExists(programFolder() / HONEYCOMB_SHARE_FOLDER / name,
                         std::filesystem::path(HONEYCOMB_ASSETS) / name);
}

}  // namespace honeycomb::Cli
