#include "capi/context.h"

#include <cstdint>
#include <cstdlib>
#include <new>

#include "capi/failure.h"
#include "capi/structs.h"

namespace honeycomb::Capi {
namespace {

void* allocateBySystem(void*, std::size_t size, std::size_t alignment) {
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void releaseToSystem(void*, void* block) {
  std::free(block);
}

constexpr hc_allocator kSystem{nullptr, allocateBySystem, releaseToSystem};

ContextHandle makeContext(const hc_allocator& allocator, decltype(hc_context_options::log) log, void* logUser) {
  const Context context(allocator, log, logUser);
  return std::allocate_shared<const Context>(ContextAllocator<const Context>(context), context);
}

}  // namespace

void* Context::allocate(std::size_t bytes, std::size_t alignment) const {
  void* block = allocator_.allocate(allocator_.user, bytes, alignment);
  if (block == nullptr || reinterpret_cast<std::uintptr_t>(block) % alignment != 0) throw std::bad_alloc();
  return block;
}

void Context::release(void* block) const noexcept {
  allocator_.release(allocator_.user, block);
}

ContextHandle contextOf(const hc_context* context) {
  return context != nullptr ? context->context : makeContext(kSystem, nullptr, nullptr);
}

}  // namespace honeycomb::Capi

using namespace honeycomb;

hc_status hc_context_create(const hc_context_options* options, hc_context** context) {
  return Capi::guarded(nullptr, [&]() -> Result<void> {
    if (context == nullptr) return Capi::refuse("context is NULL; say where the new context goes");
    const Result<hc_context_options> read = Capi::readStruct(options, "hc_context_options");
    if (!read) return tl::unexpected(read.error());
    const hc_allocator& given = read->allocator;
    if ((given.allocate == nullptr) != (given.release == nullptr))
      return Capi::refuse("allocator: allocate and release belong together; give both or neither");
    *context = Capi::make<hc_context>(
        Capi::makeContext(given.allocate != nullptr ? given : Capi::kSystem, read->log, read->log_user));
    return {};
  });
}

void hc_context_destroy(hc_context* context) {
  Capi::destroy(context);
}
