#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "far/base/result.h"

namespace honeycomb::Chain {

/// "akleman, zhang-wang": the names of a table whose entries have a `name`.
template <class Table>
std::string names(const Table& table) {
  std::string list;
  for (const auto& entry : table) list += (list.empty() ? "" : ", ") + std::string(entry.name);
  return list;
}

/// The entry of that name. `option` is what the user wrote the name behind, such as "--scheme".
/// Errors: invalidOption, listing what there is.
template <class Table>
auto choose(const Table& table, std::string_view option, std::string_view name)
    -> Result<decltype(&*std::begin(table))> {
  for (const auto& entry : table)
    if (entry.name == name) return &entry;
  return fail(ErrorCode::invalidOption,
              fmt::format("{}: there is no '{}'; choose from: {}", option, name, names(table)));
}

}  // namespace honeycomb::Chain
