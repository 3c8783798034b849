#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "apps/cli/surface_evaluator.h"
#include "apps/cli/surface_options.h"
#include "far/base/result.h"
#include "far/tables/refinement.h"
#include "io/table_file.h"

namespace honeycomb::Cli {

/// The tables that a bake goes by: built for it, or of a table file. Stays in place as long as views of it are used.
class BakeTables {
 public:
  /// Errors: those of buildTables.
  static Result<BakeTables> build(const SurfacePlan& plan, const RunShape& shape);
  /// Of the mesh that was read. Errors: those of TableFile; invalidMesh where the table was made for another.
  static Result<BakeTables> open(const std::string& file, const MeshInput& input);

  SurfaceTables view() const;
  const Io::TableMesh& mesh() const { return mesh_; }
  std::int32_t faceCount() const { return static_cast<std::int32_t>(mesh_.faceOffsets.size()) - 1; }
  /// Null: of a file.
  const Far::Refinement* refinement() const { return refinement_ ? &*refinement_ : nullptr; }
  std::int32_t levels() const { return levels_; }
  /// What makes each step.
  const std::vector<std::string>& steps() const { return steps_; }
  std::int64_t byteCount() const { return file_ ? file_->byteCount() : refinement_->byteCount(); }

 private:
  std::optional<Far::Refinement> refinement_;
  std::optional<Io::TableFile> file_;
  const Far::TileTable* tiles_ = nullptr;
  Io::TableMesh mesh_;
  std::int32_t levels_ = 0;
  std::vector<std::string> steps_;
};

/// "akleman --boundary brick --tension paper": what makes each step, with the options of its scheme.
std::vector<std::string> describeSteps(const SchemeChain& chain, const ChainRequest& request,
                                       const SchemeOptions& options);

}  // namespace honeycomb::Cli
