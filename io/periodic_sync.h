#pragma once

#include <chrono>
#include <initializer_list>
#include <mutex>

#include "far/base/result.h"
#include "io/block_file.h"

namespace honeycomb::Io {

/// What a power failure costs of the work of those who write frames, at most: about so much of their time.
constexpr std::chrono::steady_clock::duration kSyncEvery = std::chrono::seconds(10);

/// Brings what has been written to the disk from time to time.
class PeriodicSync {
 public:
  explicit PeriodicSync(std::chrono::steady_clock::duration every = kSyncEvery) : every_(every) {}

  /// To be called when something has been written: syncs the files, one after the other in their order, if that is due.
  /// Thread-safe: one thread waits for the disk, the others go on. Errors: unwritable.
  Result<void> afterWrite(std::initializer_list<BlockFile*> files);

 private:
  using Clock = std::chrono::steady_clock;

  Clock::duration every_;
  std::mutex mutex_;
  Clock::time_point synced_ = Clock::now();
};

}  // namespace honeycomb::Io
