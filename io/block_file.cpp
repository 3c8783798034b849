#include "io/block_file.h"

#include <fcntl.h>

#include <utility>

#include "io/file_descriptor.h"
#include "io/output_target.h"
#include "io/system_error.h"

namespace honeycomb::Io {
namespace {

class SystemBlockFile : public BlockFile {
 public:
  SystemBlockFile(FileDescriptor file, std::filesystem::path name) : file_(std::move(file)), name_(std::move(name)) {}

  Result<void> writeAt(std::int64_t offset, std::span<const std::byte> bytes) override {
    if (!writeAllAt(file_.get(), offset, bytes)) return failSystem(ErrorCode::unwritable, name_, errno);
    return {};
  }
  Result<void> sync() override {
    if (!syncToDisk(file_.get())) return failSystem(ErrorCode::unwritable, name_, errno);
    return {};
  }
  Result<void> close() override {
    if (Result<void> synced = sync(); !synced) return synced;
    if (!file_.close()) return failSystem(ErrorCode::unwritable, name_, errno);
    return {};
  }

 private:
  FileDescriptor file_;
  std::filesystem::path name_;
};

}  // namespace

Result<std::unique_ptr<BlockFile>> openBlockFile(const std::filesystem::path& file, const std::filesystem::path& name) {
  FileDescriptor opened(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!opened.valid()) return failSystem(ErrorCode::unwritable, name, errno);
  return std::make_unique<SystemBlockFile>(std::move(opened), name);
}

}  // namespace honeycomb::Io
