#include "apps/cli/play/options.h"

namespace honeycomb::Cli::Play {

Result<void> playInWindow(const PlayCommand&, const Session&) {
  return fail(ErrorCode::unsupported,
              "this build has no window; write pictures with --headless --output frame_%04d.png, or build with "
              "libglfw3-dev, libimgui-dev and -DHONEYCOMB_WINDOW=ON");
}

}  // namespace honeycomb::Cli::Play
