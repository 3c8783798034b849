#include <filesystem>

#include "capi/structs.h"
#include "capi/tables.h"
#include "osd/vulkan/evaluator.h"

struct hc_vulkan {
  honeycomb::Capi::ContextHandle context;
  honeycomb::Osd::VulkanEvaluator evaluator;
};

struct hc_vulkan_table {
  honeycomb::Capi::ContextHandle context;
  honeycomb::Osd::VulkanEvaluator evaluator;
  honeycomb::Osd::VulkanTable table;
};

struct hc_vulkan_binding {
  honeycomb::Capi::ContextHandle context;
  honeycomb::Osd::VulkanBinding binding;
};

namespace honeycomb::Capi {
namespace {

template <class Object>
const Context* contextOfVulkan(const Object* object) {
  return object != nullptr ? object->context.get() : nullptr;
}

/// `maker`: the function whose object is meant.
template <class Object>
Result<void> checkObject(const Object* object, const char* name, const char* maker) {
  if (object == nullptr) return refuse(fmt::format("{} is NULL; give one of {}()", name, maker));
  return {};
}

template <class Object>
Result<void> checkPlace(Object** place, const char* name) {
  if (place == nullptr) return refuse(fmt::format("{} is NULL; say where the new one goes", name));
  return {};
}

Result<Osd::VulkanEvaluator> makeEvaluator(const hc_vulkan_device* given) {
  if (given == nullptr) return refuse("device is NULL; give the Vulkan device to work on");
  const Result<hc_vulkan_device> read = readStruct(given, "hc_vulkan_device");
  if (!read) return tl::unexpected(read.error());
  Osd::VulkanDevice device;
  device.instance = read->instance;
  device.physicalDevice = read->physical_device;
  device.device = read->device;
  device.queue = read->queue;
  device.queueFamily = read->queue_family;
  device.allocator = read->allocator;
  device.getInstanceProcAddr = read->get_instance_proc_addr;
  device.getDeviceProcAddr = read->get_device_proc_addr;
  device.queueLock = {read->lock_queue, read->unlock_queue, read->queue_owner};
  Osd::VulkanEvaluatorOptions options;
  options.maxDeviceBytes = read->max_device_bytes;
  if (read->pipeline_cache != nullptr)
    options.pipelineCache = std::filesystem::path(reinterpret_cast<const char8_t*>(read->pipeline_cache));
  return Osd::VulkanEvaluator::create(device, options);
}

Osd::BufferDescriptor descriptorOf(const hc_layout& layout) {
  if (layout.length == 0 && layout.offset == 0 && layout.stride == 0) return {};
  return {layout.offset, layout.length, layout.stride};
}

Far::TileNormalKind kindOf(hc_normals normals) {
  return normals == HC_NORMALS_FAST ? Far::TileNormalKind::fast : Far::TileNormalKind::exact;
}

/// The level that is wanted. Errors: invalidOption.
Result<std::int32_t> checkRequest(const hc_tables* tables, const hc_vulkan_table_options& options) {
  if (const auto there = checkLevel(tables, options.level); !there) return tl::unexpected(there.error());
  const std::int32_t last = tables->levelCount();
  const std::int32_t level = options.level == 0 ? last : options.level;
  if (options.normals.length == 0) return level;
  if (tables->normals == HC_NORMALS_NONE)
    return refuse("the tables have no normals; create them with hc_tables_options.normals, or leave normals out");
  if (level != last) return refuse(fmt::format("level {} has no normals, only the last, {}", level, last));
  return level;
}

/// Tiles for the device; those of a file are taken as they are.
Result<Osd::VulkanTable> uploadTiles(Osd::VulkanEvaluator& evaluator, const hc_tables& tables, std::int32_t level,
                                     const hc_vulkan_table_options& options) {
  Osd::VulkanTileOptions upload;
  upload.control = descriptorOf(options.control);
  upload.refined = descriptorOf(options.refined);
  upload.level = level;
  if (options.normals.length != 0) upload.normals = descriptorOf(options.normals);
  if (!tables.refinement) {
    if (tables.tileTable() == nullptr) return refuse("the file has no tiles; leave tiled at 0");
    return evaluator.uploadTiles(tables.levels(), *tables.tileTable(), upload);
  }
  Far::TileOptions tile = evaluator.tileOptions();
  tile.level = level;
  if (options.normals.length != 0) tile.normals = kindOf(tables.normals);
  const Result<Far::TileTable> tiles = Far::buildTileTable(*tables.refinement, tile);
  if (!tiles) return tl::unexpected(tiles.error());
  return evaluator.uploadTiles(tables.levels(), *tiles, upload);
}

Result<Osd::VulkanTable> uploadLevels(Osd::VulkanEvaluator& evaluator, const hc_tables& tables, std::int32_t level,
                                      const hc_vulkan_table_options& options) {
  Osd::VulkanTableOptions upload;
  upload.control = descriptorOf(options.control);
  upload.refined = descriptorOf(options.refined);
  upload.lastLevel = level;
  if (options.normals.length != 0) upload.vertexLimits.normals = descriptorOf(options.normals);
  upload.normalKind = kindOf(tables.normals);
  return tables.refinement ? evaluator.upload(*tables.refinement, upload) : evaluator.upload(tables.levels(), upload);
}

Result<hc_vulkan_table*> upload(hc_vulkan& vulkan, const hc_tables* tables, const hc_vulkan_table_options* given) {
  const Result<hc_vulkan_table_options> options = readStruct(given, "hc_vulkan_table_options");
  if (!options) return tl::unexpected(options.error());
  const Result<std::int32_t> level = checkRequest(tables, *options);
  if (!level) return tl::unexpected(level.error());
  Result<Osd::VulkanTable> table = options->tiled != 0 ? uploadTiles(vulkan.evaluator, *tables, *level, *options)
                                                       : uploadLevels(vulkan.evaluator, *tables, *level, *options);
  if (!table) return tl::unexpected(table.error());
  return make<hc_vulkan_table>(vulkan.context, vulkan.evaluator, std::move(*table));
}

Osd::VulkanRange rangeOf(const hc_vulkan_range& range) {
  return {range.buffer, range.offset, range.size};
}

}  // namespace
}  // namespace honeycomb::Capi

using namespace honeycomb;

hc_status hc_vulkan_create(hc_context* context, const hc_vulkan_device* device, hc_vulkan** vulkan) {
  return Capi::guarded(Capi::contextOfVulkan(context), [&]() -> Result<void> {
    if (auto place = Capi::checkPlace(vulkan, "vulkan"); !place) return place;
    Result<Osd::VulkanEvaluator> evaluator = Capi::makeEvaluator(device);
    if (!evaluator) return tl::unexpected(evaluator.error());
    *vulkan = Capi::make<hc_vulkan>(Capi::contextOf(context), std::move(*evaluator));
    return {};
  });
}

void hc_vulkan_destroy(hc_vulkan* vulkan) {
  Capi::destroy(vulkan);
}

hc_status hc_vulkan_table_create(hc_vulkan* vulkan, const hc_tables* tables, const hc_vulkan_table_options* options,
                                 hc_vulkan_table** table) {
  return Capi::guarded(Capi::contextOfVulkan(vulkan), [&]() -> Result<void> {
    if (auto there = Capi::checkObject(vulkan, "vulkan", "hc_vulkan_create"); !there) return there;
    if (auto place = Capi::checkPlace(table, "table"); !place) return place;
    const Result<hc_vulkan_table*> made = Capi::upload(*vulkan, tables, options);
    if (!made) return tl::unexpected(made.error());
    *table = *made;
    return {};
  });
}

void hc_vulkan_table_destroy(hc_vulkan_table* table) {
  Capi::destroy(table);
}

hc_status hc_vulkan_table_get_sizes(const hc_vulkan_table* table, hc_vulkan_sizes* sizes) {
  return Capi::guarded(Capi::contextOfVulkan(table), [&]() -> Result<void> {
    if (auto there = Capi::checkObject(table, "table", "hc_vulkan_table_create"); !there) return there;
    const Osd::VulkanTable& own = table->table;
    const hc_vulkan_sizes known{sizeof(hc_vulkan_sizes), own.bytesOf(Osd::PointBuffer::control),
                                own.bytesOf(Osd::PointBuffer::refined), own.bytesOf(Osd::PointBuffer::vertexNormals),
                                own.byteCount()};
    return Capi::writeStruct(known, sizes, "hc_vulkan_sizes");
  });
}

hc_status hc_vulkan_binding_create(const hc_vulkan_table* table, const hc_vulkan_targets* targets,
                                   hc_vulkan_binding** binding) {
  return Capi::guarded(Capi::contextOfVulkan(table), [&]() -> Result<void> {
    if (auto there = Capi::checkObject(table, "table", "hc_vulkan_table_create"); !there) return there;
    if (auto place = Capi::checkPlace(binding, "binding"); !place) return place;
    if (targets == nullptr) return Capi::refuse("targets is NULL; give the buffers to work on");
    const Result<hc_vulkan_targets> read = Capi::readStruct(targets, "hc_vulkan_targets");
    if (!read) return tl::unexpected(read.error());
    Osd::VulkanTargets own;
    own.control = Capi::rangeOf(read->control);
    own.refined = Capi::rangeOf(read->refined);
    own.vertexNormals = Capi::rangeOf(read->normals);
    Result<Osd::VulkanBinding> bound = table->evaluator.bind(table->table, own);
    if (!bound) return tl::unexpected(bound.error());
    *binding = Capi::make<hc_vulkan_binding>(table->context, std::move(*bound));
    return {};
  });
}

void hc_vulkan_binding_destroy(hc_vulkan_binding* binding) {
  Capi::destroy(binding);
}

hc_status hc_vulkan_record(const hc_vulkan_binding* binding, struct VkCommandBuffer_T* commands) {
  return Capi::guarded(Capi::contextOfVulkan(binding), [&]() -> Result<void> {
    if (auto there = Capi::checkObject(binding, "binding", "hc_vulkan_binding_create"); !there) return there;
    if (commands == nullptr) return Capi::refuse("commands is NULL; give a command buffer in the recording state");
    binding->binding.record(commands);
    return {};
  });
}
