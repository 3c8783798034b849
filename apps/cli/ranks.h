#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "far/base/result.h"
#include "io/block_file.h"

namespace honeycomb::Cli {

/// The processes that work on one task, this one among them. Rank 0 speaks for all. A collective call is made by all
/// ranks, in the same order; where another rank has died, it returns an error once this program is told to stop.
class Ranks {
 public:
  virtual ~Ranks() = default;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// Collective: did all go well? Errors: of those that didn't, the one with the least `order`, on every rank.
  virtual Result<void> agree(const Result<void>& mine, std::int64_t order) = 0;
  /// Collective: rank 0's numbers, on every rank. Errors: unwritable, where a rank has died.
  virtual Result<void> share(std::vector<std::int32_t>& numbers) = 0;
  /// Collective: opens a file that is there for all of them; BlockFile::close() is collective too.
  virtual Result<std::unique_ptr<Io::BlockFile>> open(const std::filesystem::path& file,
                                                      const std::filesystem::path& name) = 0;
  /// Hands out 0, 1, 2, ..: each number once, to whoever asks first. Thread-safe.
  virtual std::int64_t next() = 0;
  /// From now on next() gives numbers past all there are. Thread-safe.
  virtual void stop() = 0;

 protected:
  Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
};

/// What next() gives after stop(), at least.
constexpr std::int64_t kStopped = std::int64_t{1} << 40;

/// What mpirun tells its processes through their environment.
struct RankOfMany {
  int rank = 0;
  int size = 1;
};
RankOfMany rankOfMany();

/// This process alone, or all that mpirun has started: only then MPI is loaded, from a module beside the program.
/// Errors: unsupported, when the program was built without MPI or the module isn't there.
Result<std::unique_ptr<Ranks>> openRanks();

/// What the module has under the name kOpenMpiRanks: null, and a message, where MPI doesn't work. `interrupted` tells
/// waiting calls to give up.
using OpenMpiRanks = Ranks* (*)(bool (*interrupted)(), const char** message);
constexpr const char* kOpenMpiRanks = "honeycombOpenMpiRanks";

}  // namespace honeycomb::Cli
