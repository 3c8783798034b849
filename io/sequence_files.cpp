#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <string>
#include <system_error>
#include <tuple>

#include "far/base/index.h"
#include "io/frame_names.h"
#include "io/mesh_sequence.h"

namespace honeycomb::Io {
namespace {

constexpr std::int64_t kMissingNamed = 5;  // in a message

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool isGlob(const std::string& name) {
  return name.find_first_of("*?[") != std::string::npos;
}

/// A name with its last number; -1: it has none.
struct NumberedFile {
  std::int64_t number = -1;
  std::string name;
  std::string before;  // of the number
  std::string after;
  std::size_t width = 0;  // of the number's digits

  explicit NumberedFile(const std::string& file) : name(file) {
    std::size_t end = name.find_last_of("0123456789");
    if (end == std::string::npos) return;
    std::size_t begin = ++end;
    while (begin > 0 && isDigit(name[begin - 1])) --begin;
    if (std::from_chars(name.data() + begin, name.data() + end, number).ec != std::errc()) number = -1;
    before = name.substr(0, begin);
    after = name.substr(end);
    width = end - begin;
  }
};

Result<std::vector<std::string>> listFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::string> names;
  for (std::filesystem::directory_iterator i(folder, error), end; !error && i != end; i.increment(error))
    names.push_back(i->path().filename().string());
  if (!error) return names;
  return fail(ErrorCode::unreadable,
              fmt::format("{}: can't be read: {}; name a folder that is there", folder.string(), error.message()));
}

/// Errors: invalidFile, when numbers between the first and the last are missing. `name` makes the name of a number.
template <class Name>
Result<void> checkGaps(const std::filesystem::path& pattern, const std::vector<std::int64_t>& numbers,
                       const Name& name) {
  std::int64_t step = 0;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const std::int64_t difference = numbers[i] - numbers[i - 1];
    step = step == 0 ? difference : std::min(step, difference);
  }
  std::int64_t missing = 0;
  std::string list;
  for (std::size_t i = 1; i < numbers.size() && step > 0; ++i) {
    for (std::int64_t n = numbers[i - 1] + step, shown = missing; n < numbers[i] && shown < kMissingNamed; n += step)
      ++shown, list += (list.empty() ? "" : ", ") + name(n);
    missing += (numbers[i] - numbers[i - 1] - 1) / step;
  }
  if (missing == 0) return {};
  const bool more = missing > kMissingNamed;
  return fail(
      ErrorCode::invalidFile,
      fmt::format("{}: {} {} missing: {}{}; supply them or number the files without gaps", pattern.string(), missing,
                  missing == 1 ? "frame of the sequence is" : "frames of the sequence are", list, more ? ", .." : ""));
}

Result<std::vector<std::string>> patternFiles(const std::filesystem::path& path, const FrameNames& pattern,
                                              const std::vector<std::string>& names) {
  std::vector<std::int64_t> numbers;
  for (const std::string& name : names)
    if (const auto number = pattern.frameOf(name)) numbers.push_back(*number);
  std::sort(numbers.begin(), numbers.end());
  const auto name = [&pattern](std::int64_t number) { return pattern.name(number); };
  if (const auto whole = checkGaps(path, numbers, name); !whole) return tl::unexpected(whole.error());
  std::vector<std::string> files;
  files.reserve(numbers.size());
  for (const std::int64_t number : numbers) files.push_back(name(number));
  return files;
}

Result<std::vector<std::string>> globFiles(const std::filesystem::path& path, const std::vector<std::string>& names) {
  std::vector<NumberedFile> files;
  for (const std::string& name : names)
    if (::fnmatch(path.filename().c_str(), name.c_str(), FNM_PERIOD) == 0) files.emplace_back(name);
  std::sort(files.begin(), files.end(), [](const NumberedFile& a, const NumberedFile& b) {
    return std::tie(a.number, a.name) < std::tie(b.number, b.name);
  });
  std::vector<std::int64_t> numbers;
  std::vector<std::string> sorted;
  for (const NumberedFile& file : files) {
    if (file.number >= 0 && file.before == files[0].before && file.after == files[0].after)
      numbers.push_back(file.number);
    sorted.push_back(file.name);
  }
  // Only where the number is all that differs.
  if (numbers.size() < files.size()) return sorted;
  const auto name = [&files](std::int64_t number) {
    return fmt::format("{}{:0{}}{}", files[0].before, number, files[0].width, files[0].after);
  };
  if (const auto whole = checkGaps(path, numbers, name); !whole) return tl::unexpected(whole.error());
  return sorted;
}

}  // namespace

bool isSequence(const std::filesystem::path& pattern) {
  const std::string name = pattern.filename().string();
  std::error_code ignored;
  return (FrameNames::parse(name) || isGlob(name)) && !std::filesystem::exists(pattern, ignored);
}

Result<std::vector<std::filesystem::path>> sequenceFiles(const std::filesystem::path& pattern) {
  const std::filesystem::path folder = pattern.has_parent_path() ? pattern.parent_path() : ".";
  const Result<std::vector<std::string>> names = listFolder(folder);
  if (!names) return tl::unexpected(names.error());
  const auto numbered = FrameNames::parse(pattern);
  const auto files = numbered ? patternFiles(pattern, *numbered, *names) : globFiles(pattern, *names);
  if (!files) return tl::unexpected(files.error());
  if (files->empty())
    return fail(ErrorCode::invalidOption,
                fmt::format("{}: no file has such a name; name a sequence that is there, such "
                            "as frame_%04d.obj or 'frame_*.obj'",
                            pattern.string()));
  std::vector<std::filesystem::path> paths;
  for (const std::string& name : *files) paths.push_back(pattern.parent_path() / name);
  return paths;
}

}  // namespace honeycomb::Io
