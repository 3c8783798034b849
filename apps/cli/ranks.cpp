#include "apps/cli/ranks.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "apps/cli/interrupt.h"
#include "apps/cli/program_files.h"

namespace honeycomb::Cli {
namespace {

class LoneRank : public Ranks {
 public:
  int rank() const override { return 0; }
  int size() const override { return 1; }
  Result<void> agree(const Result<void>& mine, std::int64_t /*order*/) override { return mine; }
  Result<void> share(std::vector<std::int32_t>& /*numbers*/) override { return {}; }
  Result<std::unique_ptr<Io::BlockFile>> open(const std::filesystem::path& file,
                                              const std::filesystem::path& name) override {
    return Io::openBlockFile(file, name);
  }
  std::int64_t next() override { return next_.fetch_add(1); }
  void stop() override { next_.store(kStopped); }

 private:
  std::atomic<std::int64_t> next_{0};
};

// Open MPI's names, then those of MPICH, Slurm and others that speak PMI.
constexpr std::array kSizeVariables{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};
constexpr std::array kRankVariables{"OMPI_COMM_WORLD_RANK", "PMI_RANK"};

int numberIn(const std::array<const char*, 2>& variables, int otherwise) {
  for (const char* variable : variables) {
    const char* text = std::getenv(variable);
    int number = 0;
    const std::string_view digits = text == nullptr ? "" : text;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error == std::errc() && end == digits.data() + digits.size()) return number;
  }
  return otherwise;
}

tl::unexpected<Error> failWithoutMpi(std::string_view why) {
  return fail(ErrorCode::unsupported,
              fmt::format("started by mpirun, but {}; build with -DHONEYCOMB_MPI=ON, or start one process", why));
}

bool isInterrupted() {
  return interruptSignal() != 0;
}

// Past the end of the process: what MPI has loaded besides can't be unloaded. Its symbols are for its own plug-ins,
// too.
Result<std::unique_ptr<Ranks>> openModule(const std::filesystem::path& file) {
  void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (module == nullptr) return failWithoutMpi(fmt::format("MPI can't be loaded ({})", dlerror()));
  const auto open = reinterpret_cast<OpenMpiRanks>(dlsym(module, kOpenMpiRanks));
  if (open == nullptr) return failWithoutMpi(fmt::format("{} is no module of this program", file.string()));
  const char* message = "";
  std::unique_ptr<Ranks> ranks(open(isInterrupted, &message));
  if (!ranks) return failWithoutMpi(message);
  return ranks;
}

}  // namespace

RankOfMany rankOfMany() {
  return {numberIn(kRankVariables, 0), numberIn(kSizeVariables, 1)};
}

Result<std::unique_ptr<Ranks>> openRanks() {
  if (rankOfMany().size <= 1) return std::make_unique<LoneRank>();
  std::error_code ignored;
  const std::filesystem::path module = moduleFile("honeycomb_mpi.so");
  if (!std::filesystem::exists(module, ignored)) return failWithoutMpi(fmt::format("{} is not there", module.string()));
  return openModule(module);
}

}  // namespace honeycomb::Cli
