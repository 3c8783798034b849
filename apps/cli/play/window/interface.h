#pragma once

#include "apps/cli/play/player.h"

struct GLFWwindow;

namespace honeycomb::Cli::Play {

/// ImGui's context and its GLFW side, which share the window's callbacks; its look is ours.
class InterfaceContext {
 public:
  explicit InterfaceContext(GLFWwindow* window);
  ~InterfaceContext();
  InterfaceContext(const InterfaceContext&) = delete;
  InterfaceContext& operator=(const InterfaceContext&) = delete;
};

/// What the interface says about the window beside the player's own.
struct InterfaceFacts {
  std::string device;
  double framesPerSecond = 0;
  Viewer::Bend bend;  ///< of the worst cell, in the view of planarity
};

/// Lays out everything over the picture; what the user changes goes into the player.
void layOutInterface(Player& player, const InterfaceFacts& facts);

/// Does the interface want the mouse, the keyboard?
bool interfaceTakesMouse();
bool interfaceTakesKeys();

}  // namespace honeycomb::Cli::Play
