// The module honeycomb_mpi.so: loaded by a program that mpirun has started, so that no other pays for loading MPI.

#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <thread>

#include "apps/cli/mpi/mpi_block_file.h"
#include "apps/cli/ranks.h"

namespace honeycomb::Cli {
namespace {

constexpr std::chrono::microseconds kPause{200};  // of a wait: ranks may share a processor
constexpr std::int64_t kWell = std::numeric_limits<std::int64_t>::max();

/// Where rank 0 counts: everybody fetches and adds, and has the next number fetched while it works on this one, so that
/// a rank 0 that is busy keeps nobody waiting.
class Counter {
 public:
  explicit Counter(int rank) {
    MPI_Win_allocate(rank == 0 ? sizeof(std::int64_t) : 0, sizeof(std::int64_t), MPI_INFO_NULL, MPI_COMM_WORLD,
                     &memory_, &window_);
    if (rank == 0) {
      MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 0, 0, window_);
      *memory_ = 0;
      MPI_Win_unlock(0, window_);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Win_lock_all(MPI_MODE_NOCHECK, window_);
  }
  /// Collective.
  void close() {
    if (fetching_) MPI_Wait(&request_, MPI_STATUS_IGNORE);
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
  }
  std::int64_t next() {
    if (stopped_) return kStopped;
    if (!fetching_) fetch();
    MPI_Wait(&request_, MPI_STATUS_IGNORE);
    const std::int64_t number = fetched_;
    fetch();
    return number;
  }
  void stop() {
    stopped_ = true;
    std::int64_t before = 0;
    MPI_Fetch_and_op(&kStopped, &before, MPI_INT64_T, 0, 0, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
  }

 private:
  void fetch() {
    MPI_Rget_accumulate(&one_, 1, MPI_INT64_T, &fetched_, 1, MPI_INT64_T, 0, 0, 1, MPI_INT64_T, MPI_SUM, window_,
                        &request_);
    fetching_ = true;
  }

  MPI_Win window_ = MPI_WIN_NULL;
  std::int64_t* memory_ = nullptr;
  const std::int64_t one_ = 1;
  std::int64_t fetched_ = 0;
  MPI_Request request_ = MPI_REQUEST_NULL;
  bool fetching_ = false;
  bool stopped_ = false;
};

class MpiRanks : public Ranks {
 public:
  explicit MpiRanks(bool (*interrupted)()) : interrupted_(interrupted) {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    counter_.emplace(rank_);
  }
  // A program that is told to stop waits for nobody.
  ~MpiRanks() override {
    if (interrupted_()) return;
    counter_->close();
    MPI_Finalize();
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  Result<void> agree(const Result<void>& mine, std::int64_t order) override {
    const std::lock_guard lock(calls_);
    std::int64_t key = mine ? kWell : order * size_ + rank_, least = kWell;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallreduce(&key, &least, 1, MPI_INT64_T, MPI_MIN, MPI_COMM_WORLD, &request);
    if (!finish(request)) return stopped();
    if (least == kWell) return {};
    Error error = mine ? Error{} : mine.error();
    if (!spread(error, static_cast<int>(least % size_))) return stopped();
    return tl::unexpected(error);
  }
  Result<void> share(std::vector<std::int32_t>& numbers) override {
    const std::lock_guard lock(calls_);
    auto count = static_cast<std::int64_t>(numbers.size());
    if (!broadcast(&count, 1, MPI_INT64_T, 0)) return stopped();
    numbers.resize(static_cast<std::size_t>(count));
    if (!broadcast(numbers.data(), static_cast<int>(count), MPI_INT32_T, 0)) return stopped();
    return {};
  }
  Result<std::unique_ptr<Io::BlockFile>> open(const std::filesystem::path& file,
                                              const std::filesystem::path& name) override {
    const std::lock_guard lock(calls_);
    MPI_File opened = MPI_FILE_NULL;
    errno = 0;
    const int code = MPI_File_open(MPI_COMM_WORLD, file.c_str(), MPI_MODE_WRONLY, MPI_INFO_NULL, &opened);
    if (code != MPI_SUCCESS) return failMpi(name, code, errno);
    return std::make_unique<MpiBlockFile>(opened, file, name, calls_);
  }
  std::int64_t next() override {
    const std::lock_guard lock(calls_);
    return counter_->next();
  }
  void stop() override {
    const std::lock_guard lock(calls_);
    counter_->stop();
  }

 private:
  /// Waits; false where the program was told to stop meanwhile.
  bool finish(MPI_Request& request) const {
    int done = 0;
    while (MPI_Test(&request, &done, MPI_STATUS_IGNORE) == MPI_SUCCESS && done == 0) {
      if (interrupted_()) return false;
      std::this_thread::sleep_for(kPause);
    }
    return done != 0;
  }
  bool broadcast(void* data, int count, MPI_Datatype type, int from) const {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibcast(data, count, type, from, MPI_COMM_WORLD, &request);
    return finish(request);
  }
  bool spread(Error& error, int from) const {
    std::int64_t facts[]{static_cast<std::int64_t>(error.code), error.element, std::ssize(error.message)};
    if (!broadcast(facts, 3, MPI_INT64_T, from)) return false;
    error.code = static_cast<ErrorCode>(facts[0]);
    error.element = facts[1];
    error.message.resize(static_cast<std::size_t>(facts[2]));
    return broadcast(error.message.data(), static_cast<int>(facts[2]), MPI_CHAR, from);
  }
  static tl::unexpected<Error> stopped() {
    return fail(ErrorCode::unwritable, "told to stop while waiting for the other ranks; one of them may have died");
  }

  bool (*interrupted_)();
  int rank_ = 0;
  int size_ = 1;
  std::mutex calls_;
  std::optional<Counter> counter_;
};

}  // namespace

extern "C" [[gnu::visibility("default")]] Ranks* honeycombOpenMpiRanks(bool (*interrupted)(), const char** message) {
  int provided = MPI_THREAD_SINGLE;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided) != MPI_SUCCESS) {
    *message = "MPI doesn't start";
    return nullptr;
  }
  if (provided < MPI_THREAD_SERIALIZED) {
    *message = "this MPI can't be called from threads";
    return nullptr;
  }
  return std::make_unique<MpiRanks>(interrupted).release();
}

}  // namespace honeycomb::Cli
