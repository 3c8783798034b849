#include "apps/cli/play/player.h"

#include <fmt/format.h>

#include <array>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "apps/cli/formats.h"
#include "apps/cli/play/live_options.h"

namespace honeycomb::Cli::Play {
namespace {

constexpr double kSeenSeconds = 0.5;  ///< that a message stays at least
constexpr std::array<const char*, 5> kCycle{"auto", "serial", "simd", "tbb", "vulkan"};

}  // namespace

Player::Player(SurfaceRequest request, Appearance look, BackendChoice choice, BackgroundBuild::Build build,
               std::optional<double> turntable)
    : appearance(look),
      backend(std::move(choice)),
      request_(std::move(request)),
      shown_(request_),
      triedScheme_(request_.surface.scheme.scheme),
      turntable_(turntable),
      build_(std::move(build)) {
  build_.ask(request_);
}

bool Player::update(double seconds, float aspect) {
  aspect_ = aspect;
  messageAge_ += seconds;
  clock.advance(seconds);
  auto outcome = build_.poll();
  if (!outcome) return false;
  const auto before = surface_;
  take(std::move(*outcome));
  return surface_ != before;
}

void Player::take(BackgroundBuild::Outcome outcome) {
  if (!outcome.built) {
    if (!surface_) failure_ = outcome.built.error();
    say(outcome.built.error().message);
    request_ = shown_;
    return;
  }
  const bool sameFile = surface_ && outcome.request.surface.input == shown_.surface.input;
  surface_ = *outcome.built;
  shown_ = std::move(outcome.request);
  clock.change(surface_->frameCount(), surface_->framesPerSecond());
  backend.restart();
  histories = {};
  if (!sameFile || !orbit_) {
    orbit_.reset();
    frameAll();
  }
  if (!sameFile && !surface_->input().notes.empty()) say(fmt::format("{}", fmt::join(surface_->input().notes, "\n")));
}

void Player::change(SurfaceRequest request) {
  request_ = std::move(request);
  triedScheme_ = request_.surface.scheme.scheme;
  build_.ask(request_);
}

void Player::openFile(const std::string& path) {
  SurfaceRequest request = request_;
  request.animation.frames.clear();
  if (pointCache(path)) {
    request.animation.cache = path;
  } else {
    request.surface.input = path;
    request.animation.cache.clear();
    // What was asked of one scene isn't in another.
    const ReadOptions& before = request_.surface.read;
    ReadOptions& read = request.surface.read = {};
    read.dropIsolated = before.dropIsolated;
    read.splitNonManifold = before.splitNonManifold;
    read.quads = before.quads;
  }
  change(std::move(request));
}

void Player::useBackend(const std::string& name) {
  auto choice = BackendChoice::parse(name);
  if (!choice) return say(choice.error().message);
  backend = std::move(*choice);
  histories = {};
  say("refined by " + name);
}

void Player::stepBackend() {
  const auto found = std::find(kCycle.begin(), kCycle.end(), backend.asked());
  useBackend(found == kCycle.end() || found + 1 == kCycle.end() ? kCycle.front() : *(found + 1));
}

void Player::deviceLost() {
  useBackend("tbb");
  say("the Vulkan device was lost and opened anew; frames are refined on the CPU (tbb) from now on");
}

bool Player::backendFailed(const Error& error) {
  if (backend.drop()) return true;
  say(error.message);
  if (backend.current() == "tbb") return false;
  useBackend("tbb");
  say(error.message + "; refined by tbb from now on");
  return true;
}

void Player::report(const FrameReport& frame) {
  backend.took(frame.evaluate + frame.upload);
  histories.evaluate.add(static_cast<float>(frame.evaluate));
  histories.upload.add(static_cast<float>(frame.upload));
  histories.draw.add(static_cast<float>(frame.draw));
  histories.levels = frame.levels;
}

Orbit Player::view() const {
  Orbit orbit = *orbit_;
  if (turntable_) orbit.turn(static_cast<float>(glm::radians(*turntable_ * clock.frame() / clock.frames())), 0);
  return orbit;
}

void Player::frameAll() {
  if (!surface_) return;
  if (orbit_)
    orbit_->frameAll(surface_->outline(), surface_->bounds(), aspect_);
  else if (turntable_)
    orbit_ = Orbit::turntable(surface_->outline(), surface_->bounds(), aspect_);
  else
    orbit_ = Orbit::framing(surface_->outline(), surface_->bounds(), aspect_);
}

void Player::say(std::string message) {
  message_ = std::move(message);
  messageAge_ = 0;
}

void Player::dismissMessage() {
  if (messageAge_ > kSeenSeconds) message_.clear();
}

const SchemeOption* Player::chosenOption() const {
  const auto options = optionsOf(request_);
  return options.empty() ? nullptr : options[chosenOption_ % options.size()];
}

}  // namespace honeycomb::Cli::Play
