#pragma once

#include <memory>
#include <mutex>
#include <vector>

namespace honeycomb {

/// Working memory for the pieces of a parallel loop: as many objects as pieces run at once, made when first needed and
/// kept for the next loop.
template <class T>
class Pool {
 public:
  /// An object of the pool while it is borrowed; goes back when the loan ends.
  class Loan {
   public:
    Loan(Pool& pool, std::unique_ptr<T> object) : pool_(pool), object_(std::move(object)) {}
    ~Loan() { pool_.giveBack(std::move(object_)); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    T& operator*() const { return *object_; }
    T* operator->() const { return object_.get(); }

   private:
    Pool& pool_;
    std::unique_ptr<T> object_;
  };

  /// A free object, or `make()` (a std::unique_ptr<T>) where all are lent.
  template <class Make>
  Loan borrow(const Make& make) {
    {
      const std::lock_guard lock(mutex_);
      if (!free_.empty()) {
        std::unique_ptr<T> object = std::move(free_.back());
        free_.pop_back();
        return Loan(*this, std::move(object));
      }
    }
    return Loan(*this, make());
  }
  /// The same; made by its default constructor where none is free.
  Loan borrow() {
    return borrow([] { return std::make_unique<T>(); });
  }

 private:
  void giveBack(std::unique_ptr<T> object) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(object));
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> free_;
};

}  // namespace honeycomb
