#pragma once

#include <cstdint>
#include <exception>
#include <string>

#include "capi/failure.h"
#include "capi/include/honeycomb.h"
#include "python/pybind.h"

/// How errors of the library become exceptions of Python, and how long the interpreter's lock is held.
namespace honeycomb::Python {

/// What becomes a honeycomb.Error.
struct Failure : std::exception {
  hc_status status = HC_ERROR_INTERNAL;
  std::string message;
  std::int64_t element = -1;
  hc_element kind = HC_ELEMENT_NONE;

  const char* what() const noexcept override { return message.c_str(); }
};

/// Throws the Failure of the calling thread's last call, unless that succeeded.
void check(hc_status status);

/// Runs a call of the C API without the interpreter's lock: other Python threads go on meanwhile. `call` touches no
/// object of Python's. Throws Failure.
template <class Call>
void unlocked(const Call& call) {
  hc_status status = HC_OK;
  {
    const py::gil_scoped_release released;
    status = call();
  }
  check(status);
}

/// The same of work that returns a Result<void>.
template <class Work>
void unlockedResult(const Work& work) {
  unlocked([&] { return Capi::guarded(nullptr, work); });
}

}  // namespace honeycomb::Python
