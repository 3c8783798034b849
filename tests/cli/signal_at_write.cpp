// Preloaded into a program, it raises a signal at each write to a file from the n-th on: a test meets the same moment
// of a bake however fast the machine is. A program that the signal kills has written half of it.
// HONEYCOMB_SIGNAL_AT_WRITE holds "SIGNAL n". Output streams don't come here: they write from within the C library.
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace {

/// Signal and number, read from the environment.
struct Moment {
  Moment() {
    const char* text = std::getenv("HONEYCOMB_SIGNAL_AT_WRITE");
    if (text == nullptr || std::sscanf(text, "%d %d", &signal, &write) != 2) std::abort();
  }
  int signal = 0;
  int write = 0;
};

/// Before each write of `size` bytes; `writeHalf` writes so many of them.
template <class Write>
void beforeWrite(int file, std::size_t size, const Write& writeHalf) {
  static const Moment moment;
  static std::atomic<int> writes{0};
  struct stat status {};
  if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode) || ++writes < moment.write) return;
  if (moment.signal == SIGKILL) writeHalf(size / 2);
  std::raise(moment.signal);
}

}  // namespace

// System calls by number: the C library's own functions are those that are replaced.
extern "C" {

ssize_t write(int file, const void* bytes, std::size_t size) {
  const auto call = [&](std::size_t count) { return syscall(SYS_write, file, bytes, count); };
  beforeWrite(file, size, call);
  return call(size);
}

ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t offset) {
  const auto call = [&](std::size_t count) { return syscall(SYS_pwrite64, file, bytes, count, offset); };
  beforeWrite(file, size, call);
  return call(size);
}

// MPI-IO's.
ssize_t pwritev(int file, const iovec* pieces, int count, off_t offset) {
  const auto call = [&](std::size_t some) { return syscall(SYS_pwritev, file, pieces, some, offset, 0L); };
  beforeWrite(file, 0, call);
  return call(static_cast<std::size_t>(count));
}
}
