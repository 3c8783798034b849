#pragma once

#include <sys/mman.h>

#include <filesystem>
#include <string>

#include "io/file_descriptor.h"
#include "tests/fuzz/targets.h"

namespace honeycomb::Fuzz {

/// A file in memory, for readers that take paths.
class MemoryFile {
 public:
  explicit MemoryFile(Bytes bytes) : file_(::memfd_create("fuzz", MFD_CLOEXEC)) {
    expect(file_.valid() && Io::writeAllAt(file_.get(), 0, std::as_bytes(bytes)), "there is memory for a file");
  }

  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(file_.get()); }

 private:
  Io::FileDescriptor file_;
};

}  // namespace honeycomb::Fuzz
