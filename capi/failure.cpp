#include "capi/failure.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace honeycomb::Capi {
namespace {

constexpr std::size_t kMessageBytes = 1024;

/// Plain memory: nothing is allocated, so that running out of memory can be told of, and nothing runs as a thread ends.
struct LastFailure {
  std::array<char, kMessageBytes> message;
  std::int64_t element;
  hc_element kind;
};
thread_local LastFailure lastFailure{{}, -1, HC_ELEMENT_NONE};

/// One line that fits, whole characters of UTF-8 only.
void keepMessage(std::string_view message) {
  std::size_t size = std::min(message.size(), kMessageBytes - 1);
  if (size < message.size())
    while (size > 0 && (static_cast<unsigned char>(message[size]) & 0xC0U) == 0x80U) --size;
  std::memcpy(lastFailure.message.data(), message.data(), size);
  std::replace(lastFailure.message.begin(), lastFailure.message.begin() + static_cast<std::ptrdiff_t>(size), '\n', ' ');
  lastFailure.message[size] = '\0';
}

void tell(const Context* context) {
  if (context != nullptr) context->say(HC_LOG_ERROR, lastFailure.message.data());
}

hc_status statusOf(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalidMesh:
      return HC_ERROR_INVALID_MESH;
    case ErrorCode::invalidOption:
      return HC_ERROR_INVALID_ARGUMENT;
    case ErrorCode::invalidFile:
      return HC_ERROR_INVALID_FILE;
    case ErrorCode::invalidPositions:
      return HC_ERROR_INVALID_POSITIONS;
    case ErrorCode::tooLarge:
      return HC_ERROR_TOO_LARGE;
    case ErrorCode::unreadable:
      return HC_ERROR_UNREADABLE;
    case ErrorCode::unwritable:
      return HC_ERROR_UNWRITABLE;
    case ErrorCode::noDevice:
      return HC_ERROR_NO_DEVICE;
    case ErrorCode::deviceLost:
      return HC_ERROR_DEVICE_LOST;
    case ErrorCode::outOfMemory:
      return HC_ERROR_OUT_OF_MEMORY;
    case ErrorCode::unsupported:
      return HC_ERROR_UNSUPPORTED;
  }
  return HC_ERROR_INTERNAL;
}

hc_element elementOf(const Error& error) {
  if (error.element < 0) return HC_ELEMENT_NONE;
  switch (error.kind) {
    case ElementKind::vertex:
      return HC_ELEMENT_VERTEX;
    case ElementKind::face:
      return HC_ELEMENT_FACE;
    case ElementKind::other:
      break;
  }
  return HC_ELEMENT_OTHER;
}

}  // namespace

hc_status report(const Context* context, const Error& error) noexcept {
  keepMessage(error.message);
  lastFailure.element = std::max<std::int64_t>(error.element, -1);
  lastFailure.kind = elementOf(error);
  tell(context);
  return statusOf(error.code);
}

hc_status report(const Context* context, hc_status status, const char* message) noexcept {
  keepMessage(message);
  lastFailure.element = -1;
  lastFailure.kind = HC_ELEMENT_NONE;
  tell(context);
  return status;
}

}  // namespace honeycomb::Capi

using honeycomb::Capi::lastFailure;

uint32_t hc_version() {
  return HC_VERSION;
}

const char* hc_status_name(hc_status status) {
  constexpr std::array kNames{"HC_OK",
                              "HC_ERROR_INVALID_ARGUMENT",
                              "HC_ERROR_INVALID_MESH",
                              "HC_ERROR_INVALID_FILE",
                              "HC_ERROR_INVALID_POSITIONS",
                              "HC_ERROR_TOO_LARGE",
                              "HC_ERROR_UNREADABLE",
                              "HC_ERROR_UNWRITABLE",
                              "HC_ERROR_NO_DEVICE",
                              "HC_ERROR_DEVICE_LOST",
                              "HC_ERROR_OUT_OF_MEMORY",
                              "HC_ERROR_UNSUPPORTED",
                              "HC_ERROR_INTERNAL"};
  static_assert(kNames.size() == HC_ERROR_INTERNAL + 1);
  if (status < 0 || static_cast<std::size_t>(status) >= kNames.size()) return "unknown hc_status";
  return kNames[static_cast<std::size_t>(status)];
}

const char* hc_last_message() {
  return lastFailure.message.data();
}

int64_t hc_last_element(hc_element* kind) {
  if (kind != nullptr) *kind = lastFailure.kind;
  return lastFailure.element;
}
