#pragma once

#include <string_view>
#include <vector>

namespace honeycomb::Chain {

/// "a,b" -> "a", "b"; of an empty text one empty word.
inline std::vector<std::string_view> commaSeparated(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',')) {
    words.push_back(text.substr(0, comma));
    text.remove_prefix(comma + 1);
  }
  words.push_back(text);
  return words;
}

}  // namespace honeycomb::Chain
