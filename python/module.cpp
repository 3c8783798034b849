#include "python/pybind.h"

PYBIND11_MODULE(_honeycomb, module) {
  using namespace honeycomb::Python;
  addFailures(module);
  addTables(module);
  addMeshes(module);
  addEvaluator(module);
  addPointCaches(module);
  module.attr("__version__") = HONEYCOMB_VERSION;
}
