#include "apps/cli/play/key_commands.h"

#include <fmt/format.h>

#include <array>

#include "apps/cli/play/live_options.h"

namespace honeycomb::Cli::Play {
namespace {

constexpr float kTurn = 0.13f;  ///< radians a key press
constexpr float kPan = 0.05f;   ///< of the picture's height
constexpr float kZoom = 1.15f;

template <class Move>
void withOrbit(Player& player, const Move& move) {
  if (player.orbit()) move(*player.orbit());
}

void changeLevels(Player& player, std::int32_t by) {
  SurfaceRequest request = player.request();
  setLevels(request, levelsOf(request) + by);
  player.change(std::move(request));
}

void changeScheme(Player& player, int direction) {
  SurfaceRequest request = player.request();
  // On from what was tried last, lest a scheme that the mesh isn't for bars the way.
  stepScheme(request, player.triedScheme(), direction);
  player.say("scheme " + request.surface.scheme.scheme);
  player.change(std::move(request));
}

void changeOption(Player& player, int direction) {
  const SchemeOption* option = player.chosenOption();
  if (option == nullptr) return player.say("this scheme has no options");
  SurfaceRequest request = player.request();
  stepOption(request, *option, direction);
  const bool on = request.surface.scheme.given(*option);
  const bool flag = option->kind == SchemeOption::Kind::flag;
  player.say(fmt::format("{} {}", option->name, flag ? (on ? "on" : "off") : request.surface.scheme.text(*option)));
  player.change(std::move(request));
}

void chooseOption(Player& player) {
  player.chooseNextOption();
  const SchemeOption* option = player.chosenOption();
  player.say(option == nullptr ? "this scheme has no options" : fmt::format("; and ' change {}", option->name));
}

void changeBoundary(Player& player) {
  SurfaceRequest request = player.request();
  if (choicesOf(request, kBoundaryOption).empty()) return player.say("this scheme has no boundary rules");
  stepOption(request, kBoundaryOption, 1);
  player.say("boundary " + request.surface.scheme.text(kBoundaryOption));
  player.change(std::move(request));
}

void toggleEdges(Player& player) {
  Appearance& look = player.appearance;
  look.edges = !look.edges.value_or(Viewer::looks()[look.look].edges);
}

template <std::size_t Look>
void show(Player& player) {
  player.appearance.look = Look;
  player.appearance.edges.reset();
}

constexpr std::array kCommands{
    KeyCommand{Key::space, "Space", "play, pause", [](Player& p) { p.clock.toggle(); }},
    KeyCommand{Key::left, "Left", "a frame back", [](Player& p) { p.clock.step(-1); }},
    KeyCommand{Key::right, "Right", "a frame onward", [](Player& p) { p.clock.step(1); }},
    KeyCommand{Key::home, "Home", "first frame", [](Player& p) { p.clock.scrub(0); }},
    KeyCommand{Key::end, "End", "last frame", [](Player& p) { p.clock.scrub(p.clock.frames() - 1); }},
    KeyCommand{Key::up, "Up", "twice as fast", [](Player& p) { p.clock.setSpeed(2 * p.clock.speed()); }},
    KeyCommand{Key::down, "Down", "half as fast", [](Player& p) { p.clock.setSpeed(0.5 * p.clock.speed()); }},
    KeyCommand{keyOf('R'), "R", "backwards", [](Player& p) { p.clock.setSpeed(-p.clock.speed()); }},
    KeyCommand{keyOf('L'), "L", "loop", [](Player& p) { p.clock.setLoop(!p.clock.loops()); }},
    KeyCommand{keyOf('1'), "1", "shaded by limit normals", show<0>},
    KeyCommand{keyOf('2'), "2", "flat", show<1>},
    KeyCommand{keyOf('3'), "3", "cells", show<2>},
    KeyCommand{keyOf('4'), "4", "sides of cells", show<3>},
    KeyCommand{keyOf('5'), "5", "planarity of cells", show<4>},
    KeyCommand{keyOf('6'), "6", "extraordinary cells", show<5>},
    KeyCommand{keyOf('E'), "E", "outline cells", toggleEdges},
    KeyCommand{keyOf('C'), "C", "control mesh", [](Player& p) { p.appearance.cage = !p.appearance.cage; }},
    KeyCommand{keyOf('N'), "N", "normals", [](Player& p) { p.appearance.normals = !p.appearance.normals; }},
    KeyCommand{keyOf('='), "+", "a level more", [](Player& p) { changeLevels(p, 1); }},
    KeyCommand{keyOf('-'), "-", "a level less", [](Player& p) { changeLevels(p, -1); }},
    KeyCommand{keyOf('M'), "M", "next scheme", [](Player& p) { changeScheme(p, 1); }},
    KeyCommand{keyOf('U'), "U", "scheme before", [](Player& p) { changeScheme(p, -1); }},
    KeyCommand{keyOf('Y'), "Y", "next boundary rule", changeBoundary},
    KeyCommand{keyOf('O'), "O", "choose the scheme's next option", chooseOption},
    KeyCommand{keyOf(';'), ";", "less of it", [](Player& p) { changeOption(p, -1); }},
    KeyCommand{keyOf('\''), "'", "more of it", [](Player& p) { changeOption(p, 1); }},
    KeyCommand{keyOf('B'), "B", "next backend", [](Player& p) { p.stepBackend(); }},
    KeyCommand{keyOf('V'), "V", "compare backends", [](Player& p) { p.comparing = !p.comparing; }},
    KeyCommand{keyOf('A'), "A", "turn left", [](Player& p) { withOrbit(p, [](Orbit& o) { o.turn(-kTurn, 0); }); }},
    KeyCommand{keyOf('D'), "D", "turn right", [](Player& p) { withOrbit(p, [](Orbit& o) { o.turn(kTurn, 0); }); }},
    KeyCommand{keyOf('W'), "W", "turn up", [](Player& p) { withOrbit(p, [](Orbit& o) { o.turn(0, kTurn); }); }},
    KeyCommand{keyOf('S'), "S", "turn down", [](Player& p) { withOrbit(p, [](Orbit& o) { o.turn(0, -kTurn); }); }},
    KeyCommand{keyOf('Z'), "Z", "closer", [](Player& p) { withOrbit(p, [](Orbit& o) { o.zoom(kZoom); }); }},
    KeyCommand{keyOf('X'), "X", "farther", [](Player& p) { withOrbit(p, [](Orbit& o) { o.zoom(1 / kZoom); }); }},
    KeyCommand{keyOf('['), "[", "move left", [](Player& p) { withOrbit(p, [](Orbit& o) { o.pan(-kPan, 0); }); }},
    KeyCommand{keyOf(']'), "]", "move right", [](Player& p) { withOrbit(p, [](Orbit& o) { o.pan(kPan, 0); }); }},
    KeyCommand{keyOf(','), ",", "move down", [](Player& p) { withOrbit(p, [](Orbit& o) { o.pan(0, -kPan); }); }},
    KeyCommand{keyOf('.'), ".", "move up", [](Player& p) { withOrbit(p, [](Orbit& o) { o.pan(0, kPan); }); }},
    KeyCommand{keyOf('F'), "F", "everything in the picture", [](Player& p) { p.frameAll(); }},
    KeyCommand{keyOf('P'), "P", "write a picture", [](Player& p) { p.screenshotWanted = true; }},
    KeyCommand{Key::tab, "Tab", "options", [](Player& p) { p.panels.options = !p.panels.options; }},
    KeyCommand{keyOf('G'), "G", "graphs", [](Player& p) { p.panels.graphs = !p.panels.graphs; }},
    KeyCommand{keyOf('/'), "?", "this list", [](Player& p) { p.panels.help = !p.panels.help; }},
    KeyCommand{keyOf('Q'), "Q", "quit", [](Player& p) { p.quit = true; }},
    KeyCommand{Key::escape, "Esc", "quit", [](Player& p) { p.quit = true; }}};

}  // namespace

std::span<const KeyCommand> keyCommands() {
  return kCommands;
}

bool press(Player& player, Key key) {
  for (const KeyCommand& command : kCommands)
    if (command.key == key) {
      player.dismissMessage();
      command.act(player);
      return true;
    }
  return false;
}

}  // namespace honeycomb::Cli::Play
