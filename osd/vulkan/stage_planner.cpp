#include "osd/vulkan/stage_planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "far/base/index.h"

namespace honeycomb::Osd {

std::int64_t endOfRows(std::span<const std::int32_t> offsets, std::int64_t begin, const RowCapacity& capacity) {
  const std::int64_t limit = std::min(std::ssize(offsets) - 1, begin + std::max<std::int64_t>(capacity.rows, 1));
  std::int64_t end = begin + 1;
  while (end < limit && offsets[at(end + 1)] - offsets[at(begin)] <= capacity.entries) ++end;
  return end;
}

Result<void> StagePlanner::check() const {
  constexpr std::uint64_t kNumbers = std::uint64_t{1} << 32U;
  const std::uint64_t most = std::max(sourceBytes(), targetBytes()) / sizeof(float);
  if (most >= kNumbers) {
    return fail(
        ErrorCode::tooLarge,
        fmt::format("a level of {} numbers passes the 2^32 that the Vulkan kernels can count: use a CPU backend",
                    most));
  }
  if (sourceBytes() > kSourcePages * limits_.pageBytes) {
    return fail(
        ErrorCode::tooLarge,
        fmt::format("a level of {} bytes can't be read: this Vulkan device binds {} ranges of {} bytes; refine fewer "
                    "levels or use a CPU backend",
                    sourceBytes(), kSourcePages, limits_.pageBytes));
  }
  return {};
}

std::int64_t StagePlanner::sliceCapacity(const Section& section) const {
  const std::uint64_t bytes = static_cast<std::uint64_t>(section.count) * sizeof(std::uint32_t);
  if (fitsPage(bytes)) return section.count;
  return static_cast<std::int64_t>((limits_.pageBytes - limits_.alignment) / sizeof(std::uint32_t));
}

Result<Slice> StagePlanner::slice(const Section& section, std::int64_t first, std::int64_t count) const {
  constexpr std::uint64_t kEntry = sizeof(std::uint32_t);
  const std::uint64_t whole = static_cast<std::uint64_t>(section.count) * kEntry;
  if (fitsPage(whole)) return Slice{{Role::table, section.offset, whole}, static_cast<std::uint32_t>(first)};
  const std::uint64_t begin = static_cast<std::uint64_t>(first) * kEntry;
  const std::uint64_t aligned = begin / limits_.alignment * limits_.alignment;
  const std::uint64_t size = begin + static_cast<std::uint64_t>(count) * kEntry - aligned;
  if (!fitsPage(size)) {
    return fail(
        ErrorCode::tooLarge,
        fmt::format("a face or row needs {} bytes of table at once, this Vulkan device binds {}: use a CPU backend",
                    size, limits_.pageBytes));
  }
  return Slice{{Role::table, section.offset + aligned, size}, static_cast<std::uint32_t>((begin - aligned) / kEntry)};
}

std::vector<Window> StagePlanner::windows(const PointLayout& layout, std::int64_t first, std::int64_t last) const {
  const std::uint64_t all = bytesOf(layout) / sizeof(float);
  if (fitsPage(bytesOf(layout))) return {{0, all}};
  const std::uint64_t page = limits_.pageNumbers();
  const std::uint64_t begin = number(layout, first);
  const std::uint64_t end = number(layout, last) + static_cast<std::uint64_t>(layout.desc.length);
  std::vector<Window> windows;
  for (std::uint64_t at = begin / page * page; at < end; at += page) windows.push_back({at, std::min(page, all - at)});
  return windows;
}

// Item g covers the numbers origin + g*step .. + length - 1.
ItemRange StagePlanner::itemsIn(const Window& window, const ItemOutputs& outputs, ItemRange range) const {
  if (window.begin == 0 && window.size == targetBytes() / sizeof(float)) return range;
  const BufferDescriptor& desc = target_.desc;
  const auto origin = static_cast<std::int64_t>(number(target_, outputs.first));
  const std::int64_t step = outputs.each * desc.stride;
  const std::int64_t length = (outputs.each - 1) * desc.stride + desc.length;
  const std::int64_t begin = static_cast<std::int64_t>(window.begin) - origin - length;
  const std::int64_t end = static_cast<std::int64_t>(window.begin + window.size) - origin;
  const std::int64_t first = begin < 0 ? 0 : begin / step + 1;
  const std::int64_t past = end <= 0 ? 0 : (end + step - 1) / step;
  return {std::max(range.begin, first), std::min(range.end, past)};
}

Dispatch StagePlanner::dispatch(Kernel kernel) const {
  Dispatch result;
  result.kernel = kernel;
  Specialization& constants = result.specialization;
  constants.workgroupSize = kWorkgroupSize;
  constants.length = static_cast<std::uint32_t>(target_.desc.length);
  constants.sourceStride = static_cast<std::uint32_t>(source_.desc.stride);
  constants.targetStride = static_cast<std::uint32_t>(target_.desc.stride);
  if (!fitsPage(sourceBytes()))
    constants.pageShift = static_cast<std::uint32_t>(std::countr_zero(limits_.pageNumbers()));
  constants.windowed = fitsPage(targetBytes()) ? 0 : 1;
  result.push.sourceOffset = static_cast<std::uint32_t>(source_.desc.offset);
  result.push.targetOffset = static_cast<std::uint32_t>(target_.desc.offset);
  return result;
}

void StagePlanner::bindTarget(Dispatch& dispatch, const Window& window) const {
  rangeOf(dispatch, Slot::target) = {Role::target, window.begin * sizeof(float), window.size * sizeof(float)};
  dispatch.push.windowBegin = static_cast<std::uint32_t>(window.begin);
  dispatch.push.windowSize = static_cast<std::uint32_t>(window.size);
}

Result<void> StagePlanner::shape(Dispatch& dispatch, std::uint64_t invocations) const {
  const std::uint64_t groups = (invocations + kWorkgroupSize - 1) / kWorkgroupSize;
  const std::uint64_t inRow = std::min<std::uint64_t>(groups, limits_.groupsInRow);
  const std::uint64_t rows = (groups + inRow - 1) / inRow;
  constexpr std::uint64_t kInvocations = std::uint64_t{1} << 32U;
  if (rows > limits_.groupRows || rows * inRow * kWorkgroupSize >= kInvocations) {
    return fail(
        ErrorCode::tooLarge,
        fmt::format("a dispatch of {} invocations passes this Vulkan device's {} x {} workgroups: refine fewer levels "
                    "or use a CPU backend",
                    invocations, limits_.groupsInRow, limits_.groupRows));
  }
  dispatch.groups = static_cast<std::uint32_t>(inRow);
  dispatch.groupRows = static_cast<std::uint32_t>(rows);
  dispatch.push.rowLength = dispatch.groups * kWorkgroupSize;
  return {};
}

}  // namespace honeycomb::Osd
