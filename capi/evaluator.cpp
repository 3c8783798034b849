#include <algorithm>

#include "capi/buffers.h"
#include "capi/tables.h"
#include "far/base/index.h"
#include "osd/cpu_evaluator.h"
#include "osd/normal_evaluator.h"
#include "osd/tile_evaluator.h"

/// Both ways of evaluation; scratch memory comes as they are used.
struct hc_evaluator {
  honeycomb::Capi::ContextHandle context;
  hc_backend backend = HC_BACKEND_AUTO;
  bool checked = true;
  honeycomb::Osd::CpuEvaluator levels;
  honeycomb::Osd::NormalEvaluator normals;
  honeycomb::Osd::TileEvaluator tiles;

  hc_evaluator(honeycomb::Capi::ContextHandle owner, hc_backend choice, bool checks,
               honeycomb::Osd::CpuEvaluator::Threads threads, honeycomb::Osd::CpuEvaluator::Instructions instructions)
      : context(std::move(owner)),
        backend(choice),
        checked(checks),
        levels(threads, instructions),
        normals(threads),
        tiles({threads, instructions}) {}
};

namespace honeycomb::Capi {
namespace {

using Threads = Osd::CpuEvaluator::Threads;
using Instructions = Osd::CpuEvaluator::Instructions;

struct BackendChoice {
  Threads threads;
  Instructions instructions;
  bool tiled;
};
constexpr BackendChoice kBackends[]{
    {Threads::all, Instructions::vectors, true},  {Threads::one, Instructions::plain, false},
    {Threads::one, Instructions::vectors, false}, {Threads::all, Instructions::vectors, false},
    {Threads::one, Instructions::vectors, true},  {Threads::all, Instructions::vectors, true}};

bool tiled(const hc_evaluator& evaluator, const hc_tables& tables) {
  return kBackends[evaluator.backend].tiled && (evaluator.backend != HC_BACKEND_AUTO || tables.tileTable() != nullptr);
}

/// One call of hc_evaluate().
struct Evaluation {
  hc_evaluator& evaluator;
  const hc_tables& tables;
  std::int32_t level;
  const hc_points* control;
  const hc_points_out* refined;
  const hc_points_out* normals;
};

Result<void> checkKinds(const Evaluation& evaluation) {
  const hc_tables& tables = evaluation.tables;
  if (tiled(evaluation.evaluator, tables) && tables.tileTable() == nullptr)
    return refuse("the tables have no tiles; create them with hc_tables_options.tiles, or take another backend");
  if (evaluation.normals == nullptr) return {};
  if (tables.normals == HC_NORMALS_NONE)
    return refuse("the tables have no normals; create them with hc_tables_options.normals, or give NULL for normals");
  if (tables.normals == HC_NORMALS_FAST && !tiled(evaluation.evaluator, tables) && !tables.fastNormals)
    return refuse("fast normals of a file are those of its tiles; take a tiled backend");
  if (evaluation.level != tables.levelCount())
    return refuse(fmt::format("level {} has no normals, only the last, {}; evaluate that, or give NULL for normals",
                              evaluation.level, tables.levelCount()));
  if (evaluation.control->length < 3 || evaluation.control->length > 4)
    return refuse(
        fmt::format("normals are of positions, but control points have length {}; give points of length 3 or "
                    "4, or NULL for normals",
                    evaluation.control->length));
  if (evaluation.normals->length != 3)
    return refuse(fmt::format("normals have length 3, not {}", evaluation.normals->length));
  return {};
}

Result<void> check(const Evaluation& evaluation) {
  const Far::LevelTables levels = evaluation.tables.levels();
  const std::int64_t sources = levels.pointCount(0);
  const std::int64_t targets = levels.pointCount(evaluation.level);
  const hc_points_out* normals = evaluation.normals;
  if (auto sound = checkBuffer(evaluation.control, sources, "control"); !sound) return sound;
  if (auto sound = checkBuffer(evaluation.refined, targets, "refined"); !sound) return sound;
  if (normals != nullptr)
    if (auto sound = checkBuffer(normals, targets, "normals"); !sound) return sound;
  if (evaluation.control->length != evaluation.refined->length)
    return refuse(fmt::format("control points have length {} and refined points {}; they must be the same",
                              evaluation.control->length, evaluation.refined->length));
  if (auto sound = checkKinds(evaluation); !sound) return sound;
  const Extent normalsExtent = normals != nullptr ? extentOf(*normals, targets) : Extent{};
  auto apart =
      checkApart(extentOf(*evaluation.control, sources), extentOf(*evaluation.refined, targets), normalsExtent);
  if (!apart || !evaluation.evaluator.checked) return apart;
  return checkFinite(*evaluation.control, sources, evaluation.tables.info.inputVertices);
}

/// Limit normals of the last level's vertices; central control vertices have none.
Result<void> writeExactNormals(const Evaluation& evaluation) {
  const hc_tables& tables = evaluation.tables;
  const Osd::PointsOut<float> refined = pointsOf(*evaluation.refined);
  const Osd::PointsOut<float> normals = pointsOf(*evaluation.normals);
  const Osd::Points<float> positions{refined.data, {refined.desc.offset, 3, refined.desc.stride}};
  for (std::int64_t p = tables.vertexCount(); p < tables.levels().pointCount(evaluation.level); ++p)
    std::fill_n(normals.data.data() + normals.desc.offset + p * normals.desc.stride, 3, 0.0F);
  return evaluation.evaluator.levels.vertexLimits<float>(tables.levels().limits(), positions, {}, normals);
}

Result<void> evaluate(const Evaluation& evaluation) {
  const hc_tables& tables = evaluation.tables;
  const Osd::Points<float> control = pointsOf(*evaluation.control);
  const Osd::PointsOut<float> refined = pointsOf(*evaluation.refined);
  if (tiled(evaluation.evaluator, tables)) {
    Osd::TileRequest<float> request;
    if (evaluation.normals != nullptr) request.normals = pointsOf(*evaluation.normals);
    return evaluation.evaluator.tiles.evaluate<float>(tables.levels(), *tables.tileTable(), evaluation.level, control,
                                                      refined, request);
  }
  if (evaluation.normals != nullptr && tables.normals == HC_NORMALS_FAST)
    return evaluation.evaluator.normals.evaluate<float>(tables.levels(), *tables.fastNormals, control, refined,
                                                        pointsOf(*evaluation.normals));
  const auto done = evaluation.evaluator.levels.evaluate<float>(tables.levels(), evaluation.level, control, refined);
  return done && evaluation.normals != nullptr ? writeExactNormals(evaluation) : done;
}

/// One call of hc_evaluate_limits().
struct LimitEvaluation {
  hc_evaluator& evaluator;
  const hc_tables& tables;
  hc_element kind;
  const hc_points* points;
  const hc_points_out* positions;
  const hc_points_out* normals;

  std::int64_t results() const { return kind == HC_ELEMENT_VERTEX ? tables.vertexCount() : tables.faceCount(); }
};

Result<void> checkLimitBuffers(const LimitEvaluation& limits) {
  const std::int64_t sources = limits.tables.levels().pointCount(limits.tables.levelCount());
  if (auto sound = checkBuffer(limits.points, sources, "points"); !sound) return sound;
  const auto notPositions = [](std::int32_t length) {
    return refuse(fmt::format("limits are of positions, but there are points of length {}; give 3", length));
  };
  if (limits.points->length != 3) return notPositions(limits.points->length);
  const Extent read = extentOf(*limits.points, sources);
  Extent extents[2]{};
  for (const hc_points_out* out : {limits.positions, limits.normals}) {
    if (out == nullptr) continue;
    if (auto sound = checkBuffer(out, limits.results(), "limits"); !sound) return sound;
    if (out->length != 3) return notPositions(out->length);
    extents[out == limits.normals] = extentOf(*out, limits.results());
  }
  return checkApart(read, extents[0], extents[1]);
}

Result<void> check(const LimitEvaluation& limits) {
  if (!limits.tables.hasLimits()) return refuse("the tables have no limits; create them with hc_tables_options.limits");
  if (limits.kind != HC_ELEMENT_VERTEX && limits.kind != HC_ELEMENT_FACE)
    return refuse(fmt::format("kind is {}; give HC_ELEMENT_VERTEX or HC_ELEMENT_FACE", limits.kind));
  if (limits.positions == nullptr && limits.normals == nullptr)
    return refuse("positions and normals are NULL; give at least one of them");
  auto sound = checkLimitBuffers(limits);
  if (!sound || !limits.evaluator.checked) return sound;
  return checkFinite(*limits.points, limits.tables.levels().pointCount(limits.tables.levelCount()), 0);
}

Result<void> evaluate(const LimitEvaluation& limits) {
  const Far::LimitTable& table = limits.tables.levels().limits();
  const Osd::Points<float> points = pointsOf(*limits.points);
  const Osd::PointsOut<float> positions = limits.positions ? pointsOf(*limits.positions) : Osd::PointsOut<float>{};
  const Osd::PointsOut<float> normals = limits.normals ? pointsOf(*limits.normals) : Osd::PointsOut<float>{};
  return limits.kind == HC_ELEMENT_VERTEX
             ? limits.evaluator.levels.vertexLimits<float>(table, points, positions, normals)
             : limits.evaluator.levels.faceLimits<float>(table, points, positions, normals);
}

Result<void> checkEvaluator(const hc_evaluator* evaluator) {
  if (evaluator == nullptr) return refuse("evaluator is NULL; give one of hc_evaluator_create()");
  return {};
}

const Context* contextOfEvaluator(const hc_evaluator* evaluator) {
  return evaluator != nullptr ? evaluator->context.get() : nullptr;
}

}  // namespace
}  // namespace honeycomb::Capi

using namespace honeycomb;

hc_status hc_evaluator_create(hc_context* context, const hc_evaluator_options* options, hc_evaluator** evaluator) {
  return Capi::guarded(context != nullptr ? context->context.get() : nullptr, [&]() -> Result<void> {
    if (evaluator == nullptr) return Capi::refuse("evaluator is NULL; say where the new evaluator goes");
    const Result<hc_evaluator_options> read = Capi::readStruct(options, "hc_evaluator_options");
    if (!read) return tl::unexpected(read.error());
    if (read->backend < 0 || at(read->backend) >= std::size(Capi::kBackends))
      return Capi::refuse(fmt::format("backend is {}; give one of hc_backend", read->backend));
    const auto& choice = Capi::kBackends[read->backend];
    *evaluator = Capi::make<hc_evaluator>(Capi::contextOf(context), read->backend, read->unchecked == 0, choice.threads,
                                          choice.instructions);
    return {};
  });
}

void hc_evaluator_destroy(hc_evaluator* evaluator) {
  Capi::destroy(evaluator);
}

hc_status hc_evaluate(hc_evaluator* evaluator, const hc_tables* tables, int32_t level, const hc_points* control,
                      const hc_points_out* refined, const hc_points_out* normals) {
  return Capi::guarded(Capi::contextOfEvaluator(evaluator), [&]() -> Result<void> {
    if (auto there = Capi::checkEvaluator(evaluator); !there) return there;
    if (auto there = Capi::checkLevel(tables, level); !there) return there;
    if (level == 0) return Capi::refuse("level 0 is the control mesh; use 1 and more");
    const Capi::Evaluation evaluation{*evaluator, *tables, level, control, refined, normals};
    if (auto sound = Capi::check(evaluation); !sound) return sound;
    return Capi::evaluate(evaluation);
  });
}

hc_status hc_evaluate_limits(hc_evaluator* evaluator, const hc_tables* tables, hc_element kind, const hc_points* points,
                             const hc_points_out* positions, const hc_points_out* normals) {
  return Capi::guarded(Capi::contextOfEvaluator(evaluator), [&]() -> Result<void> {
    if (auto there = Capi::checkEvaluator(evaluator); !there) return there;
    if (auto there = Capi::checkLevel(tables, 0); !there) return there;
    const Capi::LimitEvaluation limits{*evaluator, *tables, kind, points, positions, normals};
    if (auto sound = Capi::check(limits); !sound) return sound;
    return Capi::evaluate(limits);
  });
}
