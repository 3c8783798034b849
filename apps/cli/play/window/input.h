#pragma once

#include "apps/cli/play/player.h"

struct GLFWwindow;

namespace honeycomb::Cli::Play {

/// Brings what happens to a window to a player: keys, the mouse, files dropped. Both outlive it, and it stays in place.
class WindowInput {
 public:
  /// Made before ImGui's side, which passes on what it is told.
  WindowInput(GLFWwindow* window, Player& player);
  ~WindowInput();
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;

 private:
  static WindowInput& of(GLFWwindow* window);
  static void onKey(GLFWwindow* window, int key, int scancode, int action, int modifiers);
  static void onCursor(GLFWwindow* window, double x, double y);
  static void onScroll(GLFWwindow* window, double x, double y);
  static void onDrop(GLFWwindow* window, int count, const char** paths);
  void drag(GLFWwindow* window, float dx, float dy);

  GLFWwindow* window_;
  Player& player_;
  double x_ = 0, y_ = 0;
};

}  // namespace honeycomb::Cli::Play
