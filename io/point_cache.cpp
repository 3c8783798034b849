#include "io/point_cache.h"

#include <array>

#include "io/by_extension.h"
#include "io/mdd.h"
#include "io/mdd_writer.h"
#include "io/pc2.h"

namespace honeycomb::Io {
namespace {

template <class Reader>
Result<std::shared_ptr<const FrameSource>> openReader(const std::filesystem::path& path) {
  Result<Reader> reader = Reader::open(path);
  if (!reader) return tl::unexpected(reader.error());
  return std::make_shared<const Reader>(std::move(*reader));
}

/// PC2 counts frames.
Result<std::shared_ptr<const FrameLayout>> pc2InFrames(std::string_view name, const FrameInfo& info,
                                                       double /*framesPerSecond*/) {
  return pc2Layout(name, info);
}

constexpr std::array kPointCaches{PointCache{".pc2", openReader<Pc2Reader>, pc2InFrames},
                                  PointCache{".mdd", openReader<MddReader>, mddLayout}};

}  // namespace

Result<const PointCache*> pointCache(const std::filesystem::path& path) {
  return byExtension(kPointCaches, "point cache files", path);
}

}  // namespace honeycomb::Io
