#include "far/base/parallel.h"

#include <atomic>
#include <thread>

#include "far/base/shares.h"

#ifdef HONEYCOMB_THREADS_TBB
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace honeycomb::Parallel {

namespace {

[[maybe_unused]] int hardwareThreads() {  // nobody asks in a build without threads
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Pieces a scan or a sort cuts its items into; fixed by the item count alone, so results never depend on threads.
std::int64_t pieceCount(std::int64_t items) {
  return std::clamp<std::int64_t>(items / (4 * kGrain), 1, 64);
}

[[maybe_unused]] int workersFor(std::int64_t items, int workers) {
  return static_cast<int>(std::min<std::int64_t>({items, workers, kMostWorkers}));
}

void workAlone(std::int64_t count, const std::function<void(int, std::int64_t)>& body) {
  for (std::int64_t i = 0; i < count; ++i) body(0, i);
}

}  // namespace

#if defined(HONEYCOMB_THREADS_TBB)

struct ThreadLimit::State {
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads)
    : state_(new State{tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                           static_cast<std::size_t>(threads > 0 ? threads : hardwareThreads()))}) {}
ThreadLimit::~ThreadLimit() = default;

int threadCount() {
  const auto allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min(static_cast<int>(allowed), tbb::this_task_arena::max_concurrency());
}

void forRange(std::int64_t begin, std::int64_t end, std::int64_t grain,
              const std::function<void(std::int64_t, std::int64_t)>& body) {
  if (end <= begin) return;
  if (end - begin <= grain) return body(begin, end);
  tbb::parallel_for(
      tbb::blocked_range<std::int64_t>(begin, end, static_cast<std::size_t>(std::max<std::int64_t>(1, grain))),
      [&body](const tbb::blocked_range<std::int64_t>& range) { body(range.begin(), range.end()); });
}

void forItems(std::int64_t count, int most, const std::function<void(int, std::int64_t)>& body) {
  const int workers = workersFor(count, most);
  if (workers <= 1) return workAlone(count, body);
  Shares<kMostWorkers> shares(count, workers);
  tbb::parallel_for(
      0, workers, [&](int) { shares.work(tbb::this_task_arena::current_thread_index(), body); },
      tbb::simple_partitioner());
}

void isolated(const std::function<void()>& body) {
  tbb::this_task_arena::isolate(body);
}

#else

namespace {
// Shared by the loops of the process, as oneTBB's global control is.
std::atomic<int>& allowedThreads() {
  static std::atomic<int> allowed{0};
  return allowed;
}
}  // namespace

struct ThreadLimit::State {
  int previous;
};

ThreadLimit::ThreadLimit(int threads) : state_(new State{allowedThreads().exchange(threads)}) {}
ThreadLimit::~ThreadLimit() {
  allowedThreads() = state_->previous;
}

void isolated(const std::function<void()>& body) {
  body();
}

#if defined(HONEYCOMB_THREADS_STD)

int threadCount() {
  const int allowed = allowedThreads();
  return allowed > 0 ? allowed : hardwareThreads();
}

void forRange(std::int64_t begin, std::int64_t end, std::int64_t grain,
              const std::function<void(std::int64_t, std::int64_t)>& body) {
  if (end <= begin) return;
  const std::int64_t count = end - begin;
  const std::int64_t pieces = std::min<std::int64_t>(threadCount(), count / std::max<std::int64_t>(1, grain));
  if (pieces <= 1) return body(begin, end);
  std::vector<std::thread> threads;
  threads.reserve(static_cast<std::size_t>(pieces - 1));
  for (std::int64_t i = 1; i < pieces; ++i) {
    threads.emplace_back(body, begin + pieceBegin(count, pieces, i), begin + pieceBegin(count, pieces, i + 1));
  }
  body(begin, begin + pieceBegin(count, pieces, 1));
  for (std::thread& thread : threads) thread.join();
}

void forItems(std::int64_t count, int most, const std::function<void(int, std::int64_t)>& body) {
  const int workers = workersFor(count, most);
  if (workers <= 1) return workAlone(count, body);
  Shares<kMostWorkers> shares(count, workers);
  forRange(0, workers, 1, [&](std::int64_t first, std::int64_t) { shares.work(static_cast<int>(first), body); });
}

#else

int threadCount() {
  return 1;
}

void forRange(std::int64_t begin, std::int64_t end, std::int64_t,
              const std::function<void(std::int64_t, std::int64_t)>& body) {
  if (begin < end) body(begin, end);
}

void forItems(std::int64_t count, int, const std::function<void(int, std::int64_t)>& body) {
  workAlone(count, body);
}

#endif
#endif

std::int64_t exclusiveScan(std::span<std::int32_t> values) {
  const auto count = static_cast<std::int64_t>(values.size());
  const std::int64_t pieces = pieceCount(count);
  std::vector<std::int64_t> sums(static_cast<std::size_t>(pieces) + 1, 0);
  const auto at = [](std::int64_t i) { return static_cast<std::size_t>(i); };
  forEach(
      0, pieces,
      [&](std::int64_t piece) {
        std::int64_t sum = 0;
        const std::int64_t end = pieceBegin(count, pieces, piece + 1);
        for (std::int64_t i = pieceBegin(count, pieces, piece); i < end; ++i) sum += values[at(i)];
        sums[at(piece) + 1] = sum;
      },
      1);
  for (std::int64_t piece = 0; piece < pieces; ++piece) sums[at(piece) + 1] += sums[at(piece)];
  forEach(
      0, pieces,
      [&](std::int64_t piece) {
        std::int64_t sum = sums[at(piece)];
        const std::int64_t end = pieceBegin(count, pieces, piece + 1);
        for (std::int64_t i = pieceBegin(count, pieces, piece); i < end; ++i) {
          const std::int32_t value = values[at(i)];
          values[at(i)] = static_cast<std::int32_t>(sum);
          sum += value;
        }
      },
      1);
  return sums.back();
}

Array<std::int32_t> stableOrder(std::span<const std::int32_t> keys, std::int32_t keyCount) {
  const auto count = static_cast<std::int64_t>(keys.size());
  // Many keys: one piece, so that the histograms stay linear in the items.
  const std::int64_t pieces = keyCount > 4096 ? 1 : pieceCount(count);
  const auto at = [](std::int64_t i) { return static_cast<std::size_t>(i); };
  // places[key * pieces + piece]: first how many, then where they go.
  std::vector<std::int32_t> places(at(keyCount * pieces), 0);
  forEach(
      0, pieces,
      [&](std::int64_t piece) {
        const std::int64_t end = pieceBegin(count, pieces, piece + 1);
        for (std::int64_t i = pieceBegin(count, pieces, piece); i < end; ++i)
          ++places[at(keys[at(i)] * pieces + piece)];
      },
      1);
  exclusiveScan(places);
  Array<std::int32_t> order(keys.size());
  forEach(
      0, pieces,
      [&](std::int64_t piece) {
        const std::int64_t end = pieceBegin(count, pieces, piece + 1);
        for (std::int64_t i = pieceBegin(count, pieces, piece); i < end; ++i) {
          order[at(places[at(keys[at(i)] * pieces + piece)]++)] = static_cast<std::int32_t>(i);
        }
      },
      1);
  return order;
}

}  // namespace honeycomb::Parallel
