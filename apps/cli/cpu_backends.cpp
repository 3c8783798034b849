#include "apps/cli/surface_evaluator.h"
#include "far/base/index.h"
#include "far/base/parallel.h"
#include "osd/cpu_evaluator.h"

namespace honeycomb::Cli {
namespace {

/// Three numbers a point.
constexpr Osd::BufferDescriptor kPacked{};

class CpuSurfaceEvaluator : public SurfaceEvaluator {
 public:
  CpuSurfaceEvaluator(const Far::Refinement& refinement, Normals normals, Osd::CpuEvaluator evaluator)
      : refinement_(refinement), normals_(normals), evaluator_(std::move(evaluator)) {}

  Result<void> evaluate(std::span<const float> control, Surface<float>& surface) override {
    return evaluateAs<float>(control, surface);
  }
  Result<void> evaluate(std::span<const double> control, Surface<double>& surface) override {
    return evaluateAs<double>(control, surface);
  }

 private:
  template <class Real>
  Result<void> evaluateAs(std::span<const Real> control, Surface<Real>& surface) {
    surface.vertexCount = refinement_.last().topology.vertexCount();
    surface.points.resize(3 * at(refinement_.last().table.targetCount));
    const Osd::PointsOut<Real> points{surface.points, kPacked};
    const Result<void> refined =
        evaluator_.evaluate<Real>(refinement_, refinement_.levelCount(), Osd::Points<Real>{control, kPacked}, points);
    if (!refined || normals_ == Normals::none) return refined;
    surface.normals.resize(3 * at(surface.vertexCount));
    return evaluator_.vertexLimits<Real>(refinement_.limits(), Osd::Points<Real>{surface.points, kPacked},
                                         Osd::PointsOut<Real>{{}, kPacked},
                                         Osd::PointsOut<Real>{surface.normals, kPacked});
  }

  const Far::Refinement& refinement_;
  Normals normals_;
  Osd::CpuEvaluator evaluator_;
};

/// One thread: SerialEvaluator or SimdEvaluator.
template <class Evaluator>
class OneThreadBackend : public Backend {
 public:
  explicit OneThreadBackend(std::string_view name) : name_(name) {}
  std::string_view name() const override { return name_; }
  Result<std::unique_ptr<SurfaceEvaluator>> evaluator(const Far::Refinement& refinement, Normals normals) override {
    return std::make_unique<CpuSurfaceEvaluator>(refinement, normals, Evaluator());
  }
  int framesAtOnce() const override { return 1; }
  Result<std::unique_ptr<SurfaceEvaluator>> frameEvaluator(const Far::Refinement& refinement) override {
    return evaluator(refinement, Normals::none);
  }

 private:
  std::string_view name_;
};

class TbbBackend : public Backend {
 public:
  std::string_view name() const override { return "tbb"; }
  Result<std::unique_ptr<SurfaceEvaluator>> evaluator(const Far::Refinement& refinement, Normals normals) override {
    return std::make_unique<CpuSurfaceEvaluator>(refinement, normals, Osd::TbbEvaluator());
  }
  int framesAtOnce() const override { return Parallel::threadCount(); }
  // A frame a task: threads that work on frames of their own wait for nobody.
  Result<std::unique_ptr<SurfaceEvaluator>> frameEvaluator(const Far::Refinement& refinement) override {
    return std::make_unique<CpuSurfaceEvaluator>(refinement, Normals::none, Osd::SimdEvaluator());
  }
};

}  // namespace

Result<std::unique_ptr<Backend>> openSerial() {
  return std::make_unique<OneThreadBackend<Osd::SerialEvaluator>>("serial");
}

Result<std::unique_ptr<Backend>> openSimd() {
  return std::make_unique<OneThreadBackend<Osd::SimdEvaluator>>("simd");
}

Result<std::unique_ptr<Backend>> openTbb() {
  return std::make_unique<TbbBackend>();
}

}  // namespace honeycomb::Cli
