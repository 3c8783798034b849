#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace honeycomb::Cli {

/// The JSON the program prints; names that aren't UTF-8 come out with replacement characters.
inline std::string jsonText(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace honeycomb::Cli
