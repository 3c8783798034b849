#include "io/scene/trial.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <stdexcept>

namespace honeycomb::Io::Test {
namespace {

using testing::HasSubstr;

TEST(TryReading, PassesWhatComesToAnEnd) {
  int reached = 0;
  EXPECT_TRUE(tryReading("a.dae", [&reached] { ++reached; }));
  EXPECT_EQ(reached, 0) << "it ran in a copy";
  EXPECT_TRUE(tryReading("a.dae", [] { throw std::runtime_error("no such node"); }));
}

TEST(TryReading, NamesTheFileThatBringsItsReaderDown) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) {
    const Result<void> tried = tryReading("a.dae", [signal] { raise(signal); });
    ASSERT_FALSE(tried) << signal;
    EXPECT_EQ(tried.error().code, ErrorCode::invalidFile);
    EXPECT_THAT(tried.error().message, HasSubstr("a.dae: is damaged: its reader breaks down"));
  }
  EXPECT_FALSE(tryReading("a.dae", [] { _exit(3); }));
}

TEST(TryReading, EndsAReaderThatDoesNot) {
  const auto forever = [] {
    for (std::atomic<int> turn = 0;; ++turn) {
    }
  };
  const Result<void> tried = tryReading("a.dae", forever, 1);
  ASSERT_FALSE(tried);
  EXPECT_THAT(tried.error().message, HasSubstr("doesn't come to an end"));
}

}  // namespace
}  // namespace honeycomb::Io::Test
