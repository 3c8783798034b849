#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>

namespace honeycomb {

/// What went wrong, in classes a program can act on; the message says the rest.
enum class ErrorCode {
  invalidMesh,       ///< the polygons are not an oriented manifold; `element` is the caller's face or vertex
  invalidOption,     ///< an option out of its range
  invalidFile,       ///< a file that can't be understood
  invalidPositions,  ///< NaN or infinity in positions; `element` is the vertex
  tooLarge,          ///< past 2^31 half-edges, or past the memory allowed
  unreadable,        ///< the system refused to open or read
  unwritable,        ///< the system refused to create, write or rename
  noDevice,          ///< no usable Vulkan device
  deviceLost,        ///< the Vulkan device stopped answering
  outOfMemory,       ///< memory of the host or the device ran out
  unsupported        ///< the device lacks something that is needed
};

/// What an error's element is a number of: a vertex or face of the caller's mesh, or something else.
enum class ElementKind : std::uint8_t { other, vertex, face };

/// An error as a value. The libraries never print and never exit.
struct Error {
  ErrorCode code = ErrorCode::invalidOption;
  std::string message;        ///< one line: what is wrong, where, and what to do
  std::int64_t element = -1;  ///< the caller's face, vertex, line or frame number where one is meant, else -1
  ElementKind kind = ElementKind::other;  ///< what the element is
};

/// "vertex 12 (counted from 0)". A program whose users count otherwise puts its own words in the place of these.
inline std::string elementName(ElementKind kind, std::int64_t element) {
  return (kind == ElementKind::face ? "face " : "vertex ") + std::to_string(element) + " (counted from 0)";
}

template <class T>
using Result = tl::expected<T, Error>;

/// Shorthand for returning an error from a function that returns a Result.
inline tl::unexpected<Error> fail(ErrorCode code, std::string message, std::int64_t element = -1,
                                  ElementKind kind = ElementKind::other) {
  return tl::unexpected<Error>(Error{code, std::move(message), element, kind});
}

}  // namespace honeycomb
