#include <memory>
#include <mutex>

#include "python/arrays.h"
#include "python/failure.h"
#include "python/tables.h"

namespace honeycomb::Python {
namespace {

constexpr std::array kBackends{"auto", "serial", "simd", "tbb", "simd-tiled", "tbb-tiled"};

/// Of some tables. Python's threads may share one: calls go one after another.
class Evaluator {
 public:
  Evaluator(Tables tables, const std::string& backend, bool checked) : tables_(std::move(tables)) {
    hc_evaluator_options options{};
    options.struct_size = sizeof options;
    options.backend = chosen(backend, kBackends, "backend");
    options.unchecked = !checked;
    hc_evaluator* made = nullptr;
    check(hc_evaluator_create(nullptr, &options, &made));
    evaluator_.reset(made);
  }

  const Tables& tables() const { return tables_; }

  py::object refine(const py::object& control, const py::object& out, const py::object& normals,
                    const std::optional<std::int32_t>& given) {
    const std::int32_t level = tables_.level(given);
    const std::int64_t rows = tables_.counts(level).points;
    const hc_points source = pointsOf(control, "control", tables_.info().control_points);
    py::object refined = out.is_none() ? newPoints(rows, source.length) : out;
    const hc_points_out target = pointsOutOf(refined, "out", rows, source.length);
    const Optional directions(normals, "normals", rows);
    run([&] { return hc_evaluate(evaluator_.get(), tables_.get(), level, &source, &target, directions.get()); });
    return refined;
  }

  py::object limits(const py::object& points, const std::string& kind, const py::object& out,
                    const py::object& normals) {
    const hc_level_counts counts = tables_.counts(std::nullopt);
    const bool vertices = chosen(kind, std::array{"vertex", "face"}, "kind") == 0;
    const std::int64_t rows = vertices ? counts.vertices : counts.faces;
    const hc_points source = pointsOf(points, "points", counts.points, 3);
    py::object positions = out.is_none() ? newPoints(rows, 3) : out;
    const hc_points_out target = pointsOutOf(positions, "out", rows, 3);
    const Optional directions(normals, "normals", rows);
    run([&] {
      return hc_evaluate_limits(evaluator_.get(), tables_.get(), vertices ? HC_ELEMENT_VERTEX : HC_ELEMENT_FACE,
                                &source, &target, directions.get());
    });
    return positions;
  }

 private:
  /// Normals that may not be wanted.
  class Optional {
   public:
    Optional(const py::object& given, const char* name, std::int64_t rows) : wanted_(!given.is_none()) {
      if (wanted_) points_ = pointsOutOf(given, name, rows, 3);
    }
    const hc_points_out* get() const { return wanted_ ? &points_ : nullptr; }

   private:
    bool wanted_;
    hc_points_out points_{};
  };

  /// The mutex is taken and left while the interpreter's lock isn't held: neither waits for the other.
  template <class Call>
  void run(const Call& call) {
    unlocked([&] {
      const std::scoped_lock alone(busy_);
      return call();
    });
  }

  struct Destroy {
    void operator()(hc_evaluator* evaluator) const { hc_evaluator_destroy(evaluator); }
  };

  Tables tables_;
  std::unique_ptr<hc_evaluator, Destroy> evaluator_;
  std::mutex busy_;
};

constexpr const char* kEvaluatorText = R"(Refines points by tables, frame after frame.

backend  "serial", "simd", "tbb", "simd-tiled" or "tbb-tiled" (with tables that have tiles), "auto": all give the same bits
checked  points are looked through for NaN and infinity first

Points are arrays of float32, a row a point, whose numbers stand beside each other; rows may be apart, as those of
columns of a wider array. Nothing is copied. Raises TypeError and ValueError for other arrays, and Error. Python's other
threads go on while it works; those that share an evaluator wait for each other.)";

constexpr const char* kRefineText = R"(Refined points, `out` or a new array, from control points.

control  (tables.control_points, k) float32: positions have 3 columns, texture coordinates 2, anything from 1
out      as many rows as the level has points, k columns; apart from control
normals  receives unit normals, 3 columns: at the last level, of tables with normals, if k is 3 or 4
level    None: the last)";

constexpr const char* kLimitsText = R"(Limit positions, `out` or a new array, of the last level's vertices or faces.

points   of the last level, 3 columns
kind     "vertex" or "face"
normals  receives unit normals of the limit surface, 3 columns

Needs tables with limits or exact normals.)";

}  // namespace

void addEvaluator(py::module_& module) {
  py::class_<Evaluator>(module, "Evaluator", kEvaluatorText)
      .def(py::init<Tables, const std::string&, bool>(), py::arg("tables"), py::arg("backend") = "auto", py::kw_only(),
           py::arg("checked") = true)
      .def_property_readonly("tables", &Evaluator::tables, "Those it was made for.")
      .def("refine", &Evaluator::refine, py::arg("control"), py::arg("out") = py::none(),
           py::arg("normals") = py::none(), py::arg("level") = py::none(), kRefineText)
      .def("limits", &Evaluator::limits, py::arg("points"), py::arg("kind") = "vertex", py::arg("out") = py::none(),
           py::arg("normals") = py::none(), kLimitsText);
}

}  // namespace honeycomb::Python
