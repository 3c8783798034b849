#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace honeycomb::Python {

namespace py = pybind11;

/// Each adds its classes and functions to the module.
void addFailures(py::module_& module);
void addMeshes(py::module_& module);
void addTables(py::module_& module);
void addEvaluator(py::module_& module);
void addPointCaches(py::module_& module);

}  // namespace honeycomb::Python
