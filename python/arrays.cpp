#include "python/arrays.h"

#include <fmt/format.h>

#include <limits>

namespace honeycomb::Python {
namespace {

/// An array of that type, aligned. Throws TypeError, ValueError.
template <class Item>
py::array arrayOf(const py::object& given, const char* name, const char* type) {
  if (!py::isinstance<py::array_t<Item>>(given))
    throw py::type_error(fmt::format("{0} is {1}; give a numpy array of {2}, such as numpy.asarray({0}, numpy.{2})",
                                     name, typeName(given), type));
  py::array array = py::reinterpret_borrow<py::array>(given);
  if (!array.attr("flags").attr("aligned").cast<bool>())
    throw py::value_error(fmt::format("{0} is not aligned; give numpy.require({0}, requirements='CA')", name));
  return array;
}

/// `columns` 0: any number.
void checkShape(const py::array& array, const char* name, std::int64_t rows, std::int64_t columns) {
  constexpr py::ssize_t kMost = std::numeric_limits<std::int32_t>::max();
  if (array.ndim() == 2 && array.shape(0) == rows &&
      (columns == 0 ? array.shape(1) >= 1 && array.shape(1) <= kMost : array.shape(1) == columns))
    return;
  throw py::value_error(fmt::format("{} has the shape {}; give ({}, {})", name,
                                    std::string(py::str(array.attr("shape"))), rows, columns > 0 ? columns : 3));
}

/// In floats: how far apart rows are.
std::int64_t strideOf(const py::array& array, const char* name) {
  constexpr auto kBytes = static_cast<py::ssize_t>(sizeof(float));
  const py::ssize_t length = array.shape(1);
  const py::ssize_t stride = array.shape(0) < 2 ? length * kBytes : array.strides(0);
  const bool together = length == 1 || array.strides(1) == kBytes;
  if (together && stride % kBytes == 0 && stride >= length * kBytes &&
      stride / kBytes <= std::numeric_limits<std::int32_t>::max())
    return stride / kBytes;
  throw py::value_error(
      fmt::format("{0} has the strides {1}; the numbers of a row must stand beside each other and rows must follow one "
                  "another: give numpy.ascontiguousarray({0})",
                  name, std::string(py::str(array.attr("strides")))));
}

/// hc_points or hc_points_out at `data`.
template <class Buffer, class Float>
Buffer describe(const py::array& array, Float* data, const char* name) {
  const std::int64_t stride = strideOf(array, name);
  const std::int64_t length = array.shape(1);
  const std::int64_t size = array.shape(0) == 0 ? 0 : (array.shape(0) - 1) * stride + length;
  Buffer buffer{};
  buffer.data = data;
  buffer.size = static_cast<std::size_t>(size);
  buffer.length = static_cast<std::int32_t>(length);
  buffer.stride = static_cast<std::int32_t>(stride);
  return buffer;
}

void checkWriteable(const py::array& array, const char* name) {
  if (!array.writeable())
    throw py::value_error(fmt::format("{} is read-only; give an array that can be written", name));
}

void checkPacked(const py::array& array, const char* name) {
  if (!array.attr("flags").attr("c_contiguous").cast<bool>())
    throw py::value_error(fmt::format("{0} is not packed; give numpy.ascontiguousarray({0})", name));
}

}  // namespace

std::string typeName(const py::object& given) {
  if (py::isinstance<py::array>(given)) return "an array of " + std::string(py::str(py::array(given).dtype()));
  return "of type " + std::string(py::str(py::type::of(given).attr("__name__")));
}

hc_points pointsOf(const py::object& given, const char* name, std::int64_t rows, std::int64_t columns) {
  const py::array array = arrayOf<float>(given, name, "float32");
  checkShape(array, name, rows, columns);
  return describe<hc_points>(array, static_cast<const float*>(array.data()), name);
}

hc_points_out pointsOutOf(const py::object& given, const char* name, std::int64_t rows, std::int64_t columns) {
  py::array array = arrayOf<float>(given, name, "float32");
  checkShape(array, name, rows, columns);
  checkWriteable(array, name);
  return describe<hc_points_out>(array, static_cast<float*>(array.mutable_data()), name);
}

std::span<const float> packedPointsOf(const py::object& given, const char* name, std::int64_t rows) {
  const hc_points points = pointsOf(given, name, rows, 3);
  checkPacked(py::reinterpret_borrow<py::array>(given), name);
  return {points.data, points.size};
}

template <class Item>
std::span<const Item> listOf(const py::object& given, const char* name) {
  const py::array array = arrayOf<Item>(given, name, std::string(py::str(py::dtype::of<Item>())).c_str());
  if (array.ndim() != 1) throw py::value_error(fmt::format("{} has {} dimensions; give one", name, array.ndim()));
  checkPacked(array, name);
  return {static_cast<const Item*>(array.data()), static_cast<std::size_t>(array.size())};
}
template std::span<const std::int32_t> listOf(const py::object&, const char*);
template std::span<const std::int64_t> listOf(const py::object&, const char*);
template std::span<const hc_crease> listOf(const py::object&, const char*);

py::array newPoints(std::int64_t rows, std::int64_t columns) {
  return py::array_t<float>(std::vector<py::ssize_t>{rows, columns});
}

py::array_t<std::int32_t> indexRows(const std::optional<py::object>& given, std::int64_t rows, std::int64_t columns) {
  if (!given) return py::array_t<std::int32_t>(std::vector<py::ssize_t>{rows, columns});
  py::array array = arrayOf<std::int32_t>(*given, "out", "int32");
  checkShape(array, "out", rows, columns);
  checkWriteable(array, "out");
  checkPacked(array, "out");
  return py::reinterpret_borrow<py::array_t<std::int32_t>>(array);
}

std::int32_t chosen(std::string_view name, const char* const* names, std::size_t count, const char* option) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) {
    if (name == names[i]) return static_cast<std::int32_t>(i);
    all += (all.empty() ? "" : ", ") + std::string(names[i]);
  }
  throw py::value_error(fmt::format("{}: there is no '{}'; choose from: {}", option, name, all));
}

}  // namespace honeycomb::Python
