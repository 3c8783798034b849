#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>

#include "capi/failure.h"

/// Structs of callers whose header may be older or newer than the library.
namespace honeycomb::Capi {

/// More than any struct will ever have: a struct_size that was never set is told from one of a newer header.
constexpr std::size_t kLargestStruct = 1024;

/// Is struct_size that of this header, or of a newer one? Errors: invalidOption.
/// (When a struct grows, its first size is what is compared with.)
inline Result<void> checkStructSize(std::size_t given, std::size_t known, const char* name) {
  if (given >= known && given <= kLargestStruct) return {};
  return refuse(fmt::format("{}.struct_size is {}; set it to sizeof({})", name, given, name));
}

/// A copy of the caller's struct; of null all defaults. Errors: invalidOption for a struct_size that makes no sense;
/// unsupported for members behind those that are known, unless they are 0.
template <class Struct>
Result<Struct> readStruct(const Struct* given, const char* name) {
  Struct copy{};
  if (given == nullptr) return copy;
  if (const auto sized = checkStructSize(given->struct_size, sizeof(Struct), name); !sized)
    return tl::unexpected(sized.error());
  const char* bytes = reinterpret_cast<const char*>(given);
  if (std::any_of(bytes + sizeof(Struct), bytes + given->struct_size, [](char byte) { return byte != 0; }))
    return fail(ErrorCode::unsupported,
                fmt::format("{}: asks for what this library, version {}.{}.{}, doesn't know; install a newer one", name,
                            HC_VERSION_MAJOR, HC_VERSION_MINOR, HC_VERSION_PATCH));
  std::memcpy(&copy, given, sizeof(Struct));
  return copy;
}

/// Writes what is known into the caller's struct, whose size stays; members of a newer header become 0.
template <class Struct>
Result<void> writeStruct(Struct value, Struct* target, const char* name) {
  if (target == nullptr) return refuse(fmt::format("{} is NULL; give one to be filled", name));
  if (const auto sized = checkStructSize(target->struct_size, sizeof(Struct), name); !sized) return sized;
  value.struct_size = target->struct_size;
  std::memset(reinterpret_cast<char*>(target) + sizeof(Struct), 0, target->struct_size - sizeof(Struct));
  std::memcpy(target, &value, sizeof(Struct));
  return {};
}

}  // namespace honeycomb::Capi
