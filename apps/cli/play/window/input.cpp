#include "apps/cli/play/window/input.h"

#include <cmath>
#include <utility>

#include "apps/cli/formats.h"
#include "apps/cli/play/key_commands.h"
#include "apps/cli/play/window/glfw.h"
#include "apps/cli/play/window/interface.h"

namespace honeycomb::Cli::Play {
namespace {

constexpr float kTurnAPixel = 0.008f;  ///< radians
constexpr float kZoomAStep = 1.12f;

Key keyFrom(int key) {
  constexpr std::pair<int, Key> kNamed[] = {{GLFW_KEY_ESCAPE, Key::escape}, {GLFW_KEY_LEFT, Key::left},
                                            {GLFW_KEY_RIGHT, Key::right},   {GLFW_KEY_UP, Key::up},
                                            {GLFW_KEY_DOWN, Key::down},     {GLFW_KEY_HOME, Key::home},
                                            {GLFW_KEY_END, Key::end},       {GLFW_KEY_TAB, Key::tab},
                                            {GLFW_KEY_KP_ADD, keyOf('=')},  {GLFW_KEY_KP_SUBTRACT, keyOf('-')}};
  for (const auto& [from, to] : kNamed)
    if (from == key) return to;
  // GLFW numbers the others by what they type without shift, in capitals.
  return key < 256 ? static_cast<Key>(key) : static_cast<Key>(0);
}

}  // namespace

WindowInput::WindowInput(GLFWwindow* window, Player& player) : window_(window), player_(player) {
  glfwSetWindowUserPointer(window, this);
  glfwSetKeyCallback(window, onKey);
  glfwSetCursorPosCallback(window, onCursor);
  glfwSetScrollCallback(window, onScroll);
  glfwSetDropCallback(window, onDrop);
  glfwGetCursorPos(window, &x_, &y_);
}

WindowInput::~WindowInput() {
  glfwSetKeyCallback(window_, nullptr);
  glfwSetCursorPosCallback(window_, nullptr);
  glfwSetScrollCallback(window_, nullptr);
  glfwSetDropCallback(window_, nullptr);
}

WindowInput& WindowInput::of(GLFWwindow* window) {
  return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window));
}

void WindowInput::onKey(GLFWwindow* window, int key, int, int action, int modifiers) {
  if (action == GLFW_RELEASE || interfaceTakesKeys()) return;
  if ((modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0) return;
  press(of(window).player_, keyFrom(key));
}

void WindowInput::onCursor(GLFWwindow* window, double x, double y) {
  WindowInput& input = of(window);
  const auto dx = static_cast<float>(x - std::exchange(input.x_, x));
  const auto dy = static_cast<float>(y - std::exchange(input.y_, y));
  if (!interfaceTakesMouse() && input.player_.orbit()) input.drag(window, dx, dy);
}

void WindowInput::drag(GLFWwindow* window, float dx, float dy) {
  int width = 0;
  int height = 1;
  glfwGetWindowSize(window, &width, &height);
  const auto held = [window](int button) { return glfwGetMouseButton(window, button) == GLFW_PRESS; };
  if (held(GLFW_MOUSE_BUTTON_LEFT)) player_.orbit()->turn(-kTurnAPixel * dx, kTurnAPixel * dy);
  if (held(GLFW_MOUSE_BUTTON_RIGHT) || held(GLFW_MOUSE_BUTTON_MIDDLE))
    player_.orbit()->pan(dx / static_cast<float>(height), -dy / static_cast<float>(height));
}

void WindowInput::onScroll(GLFWwindow* window, double, double y) {
  WindowInput& input = of(window);
  if (interfaceTakesMouse() || !input.player_.orbit()) return;
  input.player_.orbit()->zoom(std::pow(kZoomAStep, static_cast<float>(y)));
}

void WindowInput::onDrop(GLFWwindow* window, int count, const char** paths) {
  Player& player = of(window).player_;
  // A mesh and its cache may be dropped together, in any order.
  for (const bool caches : {false, true})
    for (int i = 0; i < count; ++i)
      if (pointCache(paths[i]).has_value() == caches) player.openFile(paths[i]);
}

}  // namespace honeycomb::Cli::Play
