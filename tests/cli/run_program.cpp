#include "run_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>

namespace honeycomb::Test {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void become(const std::vector<std::string>& arguments, const RunOptions& options, int out, int err) {
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  for (const auto& variable : options.environment) setenv(variable.first.c_str(), variable.second.c_str(), 1);
  if (options.fileSizeLimit >= 0) {
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = static_cast<rlim_t>(options.fileSizeLimit);
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  std::vector<std::string> command;
  if (options.ranks > 0)
    command = {HONEYCOMB_MPIRUN, "--allow-run-as-root", "--oversubscribe", "-n", std::to_string(options.ranks)};
  // By way of env: the program alone is meant, not mpirun.
  if (options.at.signal != 0)
    command.insert(command.end(),
                   {"/usr/bin/env", "LD_PRELOAD=" HONEYCOMB_SIGNAL_AT_WRITE,
                    fmt::format("HONEYCOMB_SIGNAL_AT_WRITE={} {}", options.at.signal, options.at.write)});
  command.emplace_back(HONEYCOMB_PROGRAM);
  command.insert(command.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : command) argv.push_back(word.data());
  argv.push_back(nullptr);
  execv(argv[0], argv.data());
  _exit(127);
}

std::string contents(std::FILE* file) {
  std::string text;
  std::rewind(file);
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  return text;
}

}  // namespace

Outcome run(const std::vector<std::string>& arguments, const RunOptions& options) {
  const File out(std::tmpfile()), err(std::tmpfile());
  const pid_t child = fork();
  if (child == 0) become(arguments, options, fileno(out.get()), fileno(err.get()));
  Outcome outcome = wait(child);
  outcome.out = contents(out.get());
  outcome.err = contents(err.get());
  return outcome;
}

pid_t start(const std::vector<std::string>& arguments, const RunOptions& options) {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  const int out =
      options.output.empty() ? nowhere : open(options.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const pid_t child = fork();
  if (child == 0) become(arguments, options, out, nowhere);
  if (out != nowhere) close(out);
  close(nowhere);
  return child;
}

Outcome wait(pid_t child) {
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used);
  Outcome outcome;
  outcome.mostMemory = std::int64_t{used.ru_maxrss} * 1024;
  if (WIFEXITED(status)) outcome.exitCode = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  return outcome;
}

bool hasEnded(pid_t child) {
  siginfo_t ended{};
  return waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid != 0;
}

bool waitUntilStopped(pid_t child) {
  siginfo_t changed{};
  waitid(P_PID, static_cast<id_t>(child), &changed, WSTOPPED | WEXITED | WNOWAIT);
  return changed.si_code == CLD_STOPPED;
}

Outcome continueToTheEnd(pid_t child) {
  while (waitUntilStopped(child)) kill(child, SIGCONT);
  return wait(child);
}

bool isOneErrorLine(const std::string& err) {
  return err.starts_with("error: ") && err.ends_with('\n') && std::count(err.begin(), err.end(), '\n') == 1;
}

}  // namespace honeycomb::Test
