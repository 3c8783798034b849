#pragma once

#include <exception>
#include <new>
#include <stdexcept>

#include "capi/context.h"
#include "capi/include/honeycomb.h"
#include "far/base/result.h"

/// How errors leave the library: as a status, with a message that stays with the thread.
namespace honeycomb::Capi {

/// Keeps an error for hc_last_message() and hc_last_element() on this thread, tells the context's log (none: null), and
/// returns its status. Allocates nothing.
hc_status report(const Context* context, const Error& error) noexcept;
/// The same of an error that has no element.
hc_status report(const Context* context, hc_status status, const char* message) noexcept;

constexpr const char* kNoMemory = "out of memory; use fewer levels, or close other programs";

/// The status of what `work` returns, a Result<void>, or throws: nothing is thrown on.
template <class Work>
hc_status guarded(const Context* context, const Work& work) noexcept {
  try {
    const Result<void> done = work();
    return done ? hc_status{HC_OK} : report(context, done.error());
  } catch (const std::bad_alloc&) {
    return report(context, HC_ERROR_OUT_OF_MEMORY, kNoMemory);
  } catch (const std::length_error&) {
    return report(context, HC_ERROR_OUT_OF_MEMORY, kNoMemory);
  } catch (const std::exception& unexpected) {
    return report(context, HC_ERROR_INTERNAL, unexpected.what());
  } catch (...) {
    return report(context, HC_ERROR_INTERNAL, "an exception of an unknown kind; please report this");
  }
}

/// An error of a call that makes no sense.
inline tl::unexpected<Error> refuse(std::string message) {
  return fail(ErrorCode::invalidOption, std::move(message));
}

}  // namespace honeycomb::Capi
