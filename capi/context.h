#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "capi/include/honeycomb.h"

namespace honeycomb::Capi {

/// What objects keep of the context that they were made in.
class Context {
 public:
  Context(const hc_allocator& allocator, decltype(hc_context_options::log) log, void* logUser)
      : allocator_(allocator), log_(log), logUser_(logUser) {}

  /// Memory of an object. Throws std::bad_alloc.
  void* allocate(std::size_t bytes, std::size_t alignment) const;
  void release(void* block) const noexcept;
  void say(hc_severity severity, const char* message) const {
    if (log_ != nullptr) log_(logUser_, severity, message);
  }

 private:
  hc_allocator allocator_;
  decltype(hc_context_options::log) log_;
  void* logUser_;
};

/// For std::allocate_shared: control block and object in one block of the context's.
template <class T>
struct ContextAllocator {
  using value_type = T;
  Context context;

  explicit ContextAllocator(const Context& own) : context(own) {}
  template <class U>
  ContextAllocator(const ContextAllocator<U>& other) : context(other.context) {}
  T* allocate(std::size_t count) { return static_cast<T*>(context.allocate(count * sizeof(T), alignof(T))); }
  void deallocate(T* block, std::size_t) { context.release(block); }
  template <class U>
  bool operator==(const ContextAllocator<U>&) const {
    return true;
  }
};

using ContextHandle = std::shared_ptr<const Context>;

/// The context of a handle; of NULL one with malloc() and no log.
ContextHandle contextOf(const hc_context* context);

/// A new object in the context's memory, which it keeps in its member `context`. Throws std::bad_alloc.
template <class Object, class... Arguments>
Object* make(const ContextHandle& context, Arguments&&... arguments) {
  void* block = context->allocate(sizeof(Object), alignof(Object));
  try {
    return new (block) Object{context, std::forward<Arguments>(arguments)...};
  } catch (...) {
    context->release(block);
    throw;
  }
}

/// The end of what make() made; null is allowed.
template <class Object>
void destroy(Object* object) noexcept {
  if (object == nullptr) return;
  const ContextHandle context = object->context;
  object->~Object();
  context->release(object);
}

}  // namespace honeycomb::Capi

struct hc_context {
  honeycomb::Capi::ContextHandle context;
};
