#include "io/periodic_sync.h"

namespace honeycomb::Io {

Result<void> PeriodicSync::afterWrite(std::initializer_list<BlockFile*> files) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock || Clock::now() - synced_ < every_) return {};
  for (BlockFile* file : files)
    if (Result<void> done = file->sync(); !done) return done;
  synced_ = Clock::now();
  return {};
}

}  // namespace honeycomb::Io
