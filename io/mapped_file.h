#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "far/base/result.h"

namespace honeycomb::Io {

/// The bytes of a file, mapped read-only: pages come in when they are touched. What can't be mapped, such as a pipe, is
/// read into memory instead. The file must not be shortened by others while it is mapped (the system would raise
/// SIGBUS).
class MappedFile {
 public:
  /// Errors: unreadable, naming `path` and the system's reason; a directory or a device is refused.
  static Result<MappedFile> open(const std::filesystem::path& path);

  std::span<const std::byte> bytes() const { return bytes_; }
  std::string_view text() const { return {reinterpret_cast<const char*>(bytes_.data()), bytes_.size()}; }

  /// Tells the system that the bytes are about to be read in order, so that it reads ahead.
  void expectSequentialReads() const;
  /// Lets the memory of bytes [begin, end) go, rounded down to whole pages at both ends, so that ranges in a row leave
  /// no gaps. The bytes stay readable: touching them brings them back from the file.
  void release(std::size_t begin, std::size_t end) const;

 private:
  struct Unmap {
    std::size_t size;  // bytes
    void operator()(std::byte* address) const;
  };
  MappedFile() = default;

  std::unique_ptr<std::byte, Unmap> mapping_;
  std::vector<std::byte> copy_;  // of what can't be mapped
  std::span<const std::byte> bytes_;
};

}  // namespace honeycomb::Io
