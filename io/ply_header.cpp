#include "io/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "far/base/index.h"

namespace honeycomb::Io {
namespace {

constexpr std::size_t kMostHeaderBytes = std::size_t{1} << 20U;
constexpr std::size_t kMostProperties = 4096;

struct PlyTypeEntry {
  std::string_view name;
  std::string_view other;
  PlyType type;
  std::size_t size;
  double white;
};
constexpr std::array kPlyTypes{PlyTypeEntry{"char", "int8", PlyType::int8, 1, 127},
                               PlyTypeEntry{"uchar", "uint8", PlyType::uint8, 1, 255},
                               PlyTypeEntry{"short", "int16", PlyType::int16, 2, 32767},
                               PlyTypeEntry{"ushort", "uint16", PlyType::uint16, 2, 65535},
                               PlyTypeEntry{"int", "int32", PlyType::int32, 4, 2147483647},
                               PlyTypeEntry{"uint", "uint32", PlyType::uint32, 4, 4294967295},
                               PlyTypeEntry{"float", "float32", PlyType::float32, 4, 1},
                               PlyTypeEntry{"double", "float64", PlyType::float64, 8, 1}};

const PlyTypeEntry* plyType(std::string_view name) {
  const auto found = std::find_if(kPlyTypes.begin(), kPlyTypes.end(),
                                  [&](const PlyTypeEntry& e) { return e.name == name || e.other == name; });
  return found == kPlyTypes.end() ? nullptr : &*found;
}

std::vector<std::string_view> wordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(" \t"); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(" \t", end);
  }
  return words;
}

class PlyHeaderReader {
 public:
  PlyHeaderReader(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  Result<PlyHeader> read() {
    if (bytes_.empty()) return fail(ErrorCode::invalidFile, fmt::format("{}: is empty; give a PLY file", name_));
    bool formatSeen = false;
    for (std::string_view line; nextLine(line);) {
      const std::vector<std::string_view> words = wordsOf(line);
      if (header_.lines == 1 && (words.size() != 1 || words[0] != "ply"))
        return failLine("does not begin with 'ply'; give a PLY file");
      if (header_.lines == 1 || words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") {
        if (!formatSeen) return failLine("the header names no format; write 'format ascii 1.0' or a binary one");
        header_.bytes = at_;
        return std::move(header_);
      }
      formatSeen = formatSeen || words[0] == "format";
      if (const auto done = statement(words); !done) return tl::unexpected(done.error());
    }
    return failLine("the header has no end ('end_header'); give a PLY file that is whole");
  }

 private:
  tl::unexpected<Error> failLine(std::string_view what) const {
    const auto line = std::max<std::int64_t>(header_.lines, 1);  // the first may have no end
    return fail(ErrorCode::invalidFile, fmt::format("{}:{}: {}", name_, line, what), line);
  }

  /// A line without its end, which may be any of the three.
  bool nextLine(std::string_view& line) {
    const std::size_t end = bytes_.substr(0, kMostHeaderBytes).find_first_of("\r\n", at_);
    if (end == std::string_view::npos) return false;
    line = bytes_.substr(at_, end - at_);
    at_ = bytes_.substr(end, 2) == "\r\n" ? end + 2 : end + 1;
    ++header_.lines;
    return true;
  }

  Result<void> statement(const std::vector<std::string_view>& words) {
    if (words[0] == "format") return format(words);
    if (words[0] == "element") return element(words);
    if (words[0] == "property") return property(words);
    return failLine("is no statement of a PLY header; write element, property or comment");
  }

  Result<void> format(const std::vector<std::string_view>& words) {
    const std::string_view kind = words.size() == 3 && words[2] == "1.0" ? words[1] : "";
    header_.encoding = kind == "ascii"                  ? PlyEncoding::ascii
                       : kind == "binary_little_endian" ? PlyEncoding::littleEndian
                                                        : PlyEncoding::bigEndian;
    if (kind == "ascii" || kind == "binary_little_endian" || kind == "binary_big_endian") return {};
    return failLine("is an unknown format; write 'format ascii 1.0', 'binary_little_endian' or 'binary_big_endian'");
  }

  Result<void> element(const std::vector<std::string_view>& words) {
    PlyElement element;
    const bool three = words.size() == 3;
    const auto parsed = three ? std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count)
                              : std::from_chars_result{nullptr, std::errc::invalid_argument};
    if (!three || parsed.ec != std::errc() || parsed.ptr != words[2].data() + words[2].size() || element.count < 0)
      return failLine("is no element; write 'element NAME COUNT'");
    const auto named = [&](const PlyElement& other) { return other.name == words[1]; };
    if (std::ranges::any_of(header_.elements, named))
      return failLine(fmt::format("is a second element '{}'; write all of a kind as one", words[1]));
    element.name = words[1];
    header_.elements.push_back(std::move(element));
    return {};
  }

  Result<void> property(const std::vector<std::string_view>& words) {
    PlyProperty property;
    property.isList = words.size() == 5 && words[1] == "list";
    const PlyTypeEntry* type = words.size() == 3 || property.isList ? plyType(words[words.size() - 2]) : nullptr;
    const PlyTypeEntry* count = property.isList ? plyType(words[2]) : type;
    if (!type || !count || header_.elements.empty() || count->white == 1.0 * property.isList)
      return failLine("is no property; write 'property TYPE NAME' or 'property list TYPE TYPE NAME' behind an element");
    property.type = type->type;
    property.countType = count->type;
    property.name = words.back();
    std::vector<PlyProperty>& properties = header_.elements.back().properties;
    if (properties.size() == kMostProperties) return failLine("is one property too many; remove some");
    properties.push_back(std::move(property));
    return {};
  }

  std::string_view bytes_;
  std::string_view name_;
  std::size_t at_ = 0;
  PlyHeader header_;
};

}  // namespace

std::size_t plySize(PlyType type) {
  return kPlyTypes[static_cast<std::size_t>(type)].size;
}

double plyWhite(PlyType type) {
  return kPlyTypes[static_cast<std::size_t>(type)].white;
}

int PlyElement::find(std::string_view property, bool isList) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property && properties[i].isList == isList) return static_cast<int>(i);
  return -1;
}

Result<PlyHeader> readPlyHeader(std::string_view bytes, std::string_view name) {
  return PlyHeaderReader(bytes, name).read();
}

}  // namespace honeycomb::Io
