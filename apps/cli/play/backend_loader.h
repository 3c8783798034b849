#pragma once

#include <memory>
#include <optional>
#include <string>

#include "apps/cli/play/background_work.h"
#include "apps/cli/play/stage.h"

namespace honeycomb::Cli::Play {

/// Brings the tables of further backends for the surface that a stage shows, one backend after another on a thread of
/// its own, so that the thread that draws goes on with the backend it has. Belongs to the thread of the stage, which
/// outlives it.
class BackendLoader {
 public:
  explicit BackendLoader(Stage& stage);

  /// Is the backend ready for Stage::pose? Where it isn't, it is being made so from now on: ask again. Errors: of
  /// Stage::prepare, once; asking again tries again.
  Result<bool> ready(const std::string& backend);

 private:
  struct Request {
    std::string backend;
    std::shared_ptr<const PlaySurface> surface;
  };

  using Work = BackgroundWork<Request, std::unique_ptr<Viewer::Poses>>;
  void collect();

  Stage& stage_;
  std::optional<Work::Outcome> failed_;  ///< until it is told
  Work work_;
};

}  // namespace honeycomb::Cli::Play
