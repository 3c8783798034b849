#include "python/failure.h"

#include <array>
#include <string_view>
#include <utility>

namespace honeycomb::Python {
namespace {

/// "INVALID_MESH", as honeycomb.h has it without its prefix.
std::string codeOf(hc_status status) {
  const std::string name = hc_status_name(status);
  const std::string prefix = "HC_ERROR_";
  return name.rfind(prefix, 0) == 0 ? name.substr(prefix.size()) : name;
}

py::object kindOf(hc_element kind) {
  if (kind == HC_ELEMENT_VERTEX) return py::str("vertex");
  if (kind == HC_ELEMENT_FACE) return py::str("face");
  if (kind == HC_ELEMENT_OTHER) return py::str("other");
  return py::none();
}

/// The library speaks of its options as honeycomb.h does.
std::string inPython(std::string message) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kWords{
      {{"hc_tables_options.", "Tables' "},
       {"hc_tables_create()", "Tables()"},
       {"NULL", "None"},
       {"set tiles to 0", "set tiles to False"}}};
  for (const auto& [inC, word] : kWords)
    for (std::size_t at = message.find(inC); at != std::string::npos; at = message.find(inC, at + word.size()))
      message.replace(at, inC.size(), word);
  return message;
}

/// The class is Python's own: honeycomb/error.py.
void raise(const Failure& failure) {
  const py::object type = py::module_::import("honeycomb.error").attr("Error");
  const py::object element = failure.element < 0 ? py::object(py::none()) : py::int_(failure.element);
  const py::object error = type(inPython(failure.message), codeOf(failure.status), element, kindOf(failure.kind));
  PyErr_SetObject(type.ptr(), error.ptr());
}

}  // namespace

void check(hc_status status) {
  if (status == HC_OK) return;
  Failure failure;
  failure.status = status;
  failure.message = hc_last_message();
  failure.element = hc_last_element(&failure.kind);
  throw failure;
}

void addFailures(py::module_& module) {
  module.attr("__doc__") = "The extension behind the package honeycomb: use that.";
  // pybind11 asks for this very type. NOLINTNEXTLINE(performance-unnecessary-value-param)
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Failure& failure) {
      raise(failure);
    }
  });
}

}  // namespace honeycomb::Python
