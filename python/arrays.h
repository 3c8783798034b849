#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "capi/include/honeycomb.h"
#include "python/pybind.h"

/// Arrays of numpy as the C API's buffers: looked at where they are, never copied.
namespace honeycomb::Python {

/// "of type list", "an array of float64": what was given instead.
std::string typeName(const py::object& given);

/// Points of the caller's: an array of float32, a row a point, the numbers of a row beside each other; rows may be
/// apart, so that positions[:, :3] of a wider array will do. `columns` 0: any number. The array is the caller's to
/// keep. Throws TypeError for another type, ValueError for another shape or layout; both name `name`.
hc_points pointsOf(const py::object& given, const char* name, std::int64_t rows, std::int64_t columns = 0);
/// The same of an array that is written.
hc_points_out pointsOutOf(const py::object& given, const char* name, std::int64_t rows, std::int64_t columns = 0);

/// Positions that are packed: x y z, a row a point. Throws as pointsOf().
std::span<const float> packedPointsOf(const py::object& given, const char* name, std::int64_t rows);

/// An array of one dimension, packed, of std::int32_t, std::int64_t or hc_crease. Throws as pointsOf().
template <class Item>
std::span<const Item> listOf(const py::object& given, const char* name);

/// A new array of float32.
py::array newPoints(std::int64_t rows, std::int64_t columns);

/// An array in memory of `owner`'s, which it keeps alive; not to be written.
template <class Item>
py::array viewOf(const Item* items, std::vector<py::ssize_t> shape, const py::object& owner) {
  py::array_t<Item> view(std::move(shape), items, owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

/// Room for index rows: `given`, which must be int32, packed and of that shape, or where it is none a new array. Throws
/// as pointsOf().
py::array_t<std::int32_t> indexRows(const std::optional<py::object>& given, std::int64_t rows, std::int64_t columns);

/// One of the names, as its place. Throws ValueError, listing them; `option` names what is chosen.
std::int32_t chosen(std::string_view name, const char* const* names, std::size_t count, const char* option);
template <std::size_t count>
std::int32_t chosen(std::string_view name, const std::array<const char*, count>& names, const char* option) {
  return chosen(name, names.data(), count, option);
}

}  // namespace honeycomb::Python
