#include "apps/cli/play/backend_loader.h"

#include <utility>

namespace honeycomb::Cli::Play {

BackendLoader::BackendLoader(Stage& stage)
    : stage_(stage),
      work_([&stage](const Request& wanted) { return stage.prepare(wanted.backend, *wanted.surface); }) {}

void BackendLoader::collect() {
  auto outcome = work_.poll();
  // Of a surface that isn't shown any more nothing is wanted.
  if (!outcome || outcome->request.surface != stage_.shared()) return;
  if (outcome->built)
    stage_.add(outcome->request.backend, std::move(*outcome->built));
  else
    failed_ = std::move(outcome);
}

Result<bool> BackendLoader::ready(const std::string& backend) {
  collect();
  if (stage_.refinesBy(backend)) return true;
  if (failed_ && failed_->request.backend == backend && failed_->request.surface == stage_.shared())
    return tl::unexpected(std::exchange(failed_, std::nullopt)->built.error());
  if (!work_.busy()) work_.ask({backend, stage_.shared()});
  return false;
}

}  // namespace honeycomb::Cli::Play
