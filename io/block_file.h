#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "far/base/result.h"

namespace honeycomb::Io {

/// A file whose pieces are written in any order, perhaps by several programs.
class BlockFile {
 public:
  virtual ~BlockFile() = default;

  /// Writes the bytes at `offset`; what lay between is zero until it is written. Thread-safe. Errors: unwritable.
  virtual Result<void> writeAt(std::int64_t offset, std::span<const std::byte> bytes) = 0;
  /// Writes to the disk what this process, at least, has written so far, without the others. Thread-safe. Errors:
  /// unwritable.
  virtual Result<void> sync() = 0;
  /// Writes all to the disk and closes. Nothing can be written afterwards. Errors: unwritable.
  virtual Result<void> close() = 0;

 protected:
  BlockFile() = default;
  BlockFile(const BlockFile&) = default;
  BlockFile& operator=(const BlockFile&) = default;
};

/// Opens a file that is there, by the system's own calls. `name` stands for it in messages. Errors: unwritable.
Result<std::unique_ptr<BlockFile>> openBlockFile(const std::filesystem::path& file, const std::filesystem::path& name);

}  // namespace honeycomb::Io
