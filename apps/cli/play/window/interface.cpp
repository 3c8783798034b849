#include "apps/cli/play/window/interface.h"

#include <imgui.h>
#include <imgui_impl_glfw.h>

#include "apps/cli/play/window/panel.h"

namespace honeycomb::Cli::Play {
namespace {

ImVec4 rgba(unsigned rgb, float opacity) {
  return {static_cast<float>((rgb >> 16) & 255u) / 255, static_cast<float>((rgb >> 8) & 255u) / 255,
          static_cast<float>(rgb & 255u) / 255, opacity};
}

void paint(ImGuiStyle& style) {
  const auto set = [&style](ImGuiCol which, unsigned rgb, float opacity) { style.Colors[which] = rgba(rgb, opacity); };
  set(ImGuiCol_WindowBg, 0x1d2429, 0.86f);
  set(ImGuiCol_PopupBg, 0x1d2429, 0.97f);
  set(ImGuiCol_Border, 0xffffff, 0.07f);
  set(ImGuiCol_Text, 0xeceae4, 1);
  set(ImGuiCol_TextDisabled, 0x98a3a6, 1);
  set(ImGuiCol_FrameBg, 0xffffff, 0.08f);
  set(ImGuiCol_FrameBgHovered, 0xffffff, 0.14f);
  set(ImGuiCol_FrameBgActive, 0xffffff, 0.20f);
  set(ImGuiCol_Button, 0x86b8a6, 0.30f);
  set(ImGuiCol_ButtonHovered, 0x86b8a6, 0.50f);
  set(ImGuiCol_ButtonActive, 0x86b8a6, 0.75f);
  set(ImGuiCol_Header, 0x86b8a6, 0.30f);
  set(ImGuiCol_HeaderHovered, 0x86b8a6, 0.45f);
  set(ImGuiCol_HeaderActive, 0x86b8a6, 0.60f);
  set(ImGuiCol_SliderGrab, 0xe0a83a, 1);
  set(ImGuiCol_SliderGrabActive, 0xf0be57, 1);
  set(ImGuiCol_CheckMark, 0xe0a83a, 1);
  set(ImGuiCol_PlotLines, 0x86b8a6, 1);
  set(ImGuiCol_Separator, 0xffffff, 0.10f);
  set(ImGuiCol_TitleBg, 0x161b1f, 0.95f);
  set(ImGuiCol_TitleBgActive, 0x161b1f, 0.95f);
}

}  // namespace

InterfaceContext::InterfaceContext(GLFWwindow* window) {
  ImGui::CreateContext();
  // Where windows were moved to is nobody's business but this run's.
  ImGui::GetIO().IniFilename = nullptr;
  ImGuiStyle& style = ImGui::GetStyle();
  ImGui::StyleColorsDark();
  paint(style);
  style.WindowRounding = 6;
  style.FrameRounding = 4;
  style.GrabRounding = 4;
  style.WindowBorderSize = 1;
  style.WindowPadding = {12, 10};
  style.ItemSpacing = {8, 6};
  ImGui_ImplGlfw_InitForVulkan(window, true);
}

InterfaceContext::~InterfaceContext() {
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void layOutInterface(Player& player, const InterfaceFacts& facts) {
  if (player.panels.options && player.surface()) layOutOptions(player, facts);
  if (player.panels.options && player.surface()) layOutTransport(player);
  if (player.panels.graphs && player.surface()) layOutGraphs(player, facts);
  if (player.panels.help) layOutHelp(player);
  layOutMessage(player);
}

bool interfaceTakesMouse() {
  return ImGui::GetIO().WantCaptureMouse;
}

bool interfaceTakesKeys() {
  return ImGui::GetIO().WantTextInput;
}

}  // namespace honeycomb::Cli::Play
