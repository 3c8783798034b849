#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <filesystem>
#include <utility>

#include "apps/cli/play/live_options.h"
#include "apps/cli/play/window/panel.h"

namespace honeycomb::Cli::Play {
namespace {

constexpr float kFieldWidth = 132;  ///< of what options are changed with

/// A list of names to choose from; the chosen one, or nothing.
template <class Names>
std::optional<std::string> combo(const char* label, const std::string& current, const Names& names) {
  std::optional<std::string> chosen;
  ImGui::SetNextItemWidth(kFieldWidth);
  if (!ImGui::BeginCombo(label, current.c_str())) return chosen;
  for (const auto& entry : names) {
    std::string name(entry);
    if (ImGui::Selectable(name.c_str(), name == current)) chosen = std::move(name);
  }
  ImGui::EndCombo();
  return chosen;
}

/// A text that is taken when Enter is pressed.
std::optional<std::string> textField(const char* label, std::string text) {
  ImGui::SetNextItemWidth(kFieldWidth);
  if (ImGui::InputText(label, &text, ImGuiInputTextFlags_EnterReturnsTrue)) return text;
  return std::nullopt;
}

void layOutOption(Player& player, const SchemeOption& option) {
  SurfaceRequest request = player.request();
  SchemeOptions& values = request.surface.scheme;
  const std::string label = std::string(option.name.substr(2));
  if (option.kind == SchemeOption::Kind::flag) {
    bool on = values.given(option);
    if (!ImGui::Checkbox(label.c_str(), &on)) return;
    stepOption(request, option, 1);
    return player.change(std::move(request));
  }
  const std::vector<std::string> choices = choicesOf(request, option);
  const std::string current = values.text(option);
  const auto wanted = choices.empty() ? textField(label.c_str(), current)
                                      : combo(label.c_str(), current.empty() ? choices.front() : current, choices);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(option.help).c_str());
  if (!wanted) return;
  if (!values.set(option, *wanted)) return player.say(fmt::format("{} {}: that is no number", option.name, *wanted));
  player.change(std::move(request));
}

void layOutScheme(Player& player) {
  SurfaceRequest request = player.request();
  std::vector<std::string> names;
  for (const SchemeEntry& entry : schemes()) names.emplace_back(entry.name);
  auto wanted = combo("scheme", request.surface.scheme.scheme, names);
  const auto chain = textField("chain", request.surface.scheme.scheme);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("schemes level by level, such as akleman:1,half-box:2; then Enter");
  if (chain) wanted = chain;
  if (wanted) {
    setScheme(request, *wanted);
    return player.change(std::move(request));
  }
  int levels = levelsOf(request);
  ImGui::SetNextItemWidth(kFieldWidth);
  if (ImGui::InputInt("level", &levels)) {
    setLevels(request, levels);
    return player.change(std::move(request));
  }
  for (const SchemeOption* option : optionsOf(request)) layOutOption(player, *option);
}

void layOutBackend(Player& player) {
  constexpr std::array kNames{"auto", "serial", "simd", "tbb", "vulkan"};
  if (const auto wanted = combo("backend", player.backend.asked(), kNames)) player.useBackend(*wanted);
  if (player.backend.asked() == "auto")
    ImGui::TextDisabled(player.backend.settled() ? "fastest: %s" : "trying %s", player.backend.current().c_str());
  ImGui::Checkbox("compare backends", &player.comparing);
}

void layOutLook(Player& player, const InterfaceFacts& facts) {
  Appearance& appearance = player.appearance;
  const auto looks = Viewer::looks();
  std::vector<std::string> names;
  for (const Viewer::Look& look : looks) names.emplace_back(look.name);
  if (const auto wanted = combo("view", names[appearance.look], names)) {
    appearance.look = *lookNamed(*wanted);
    appearance.edges.reset();
  }
  bool edges = appearance.edges.value_or(looks[appearance.look].edges);
  if (ImGui::Checkbox("outlines", &edges)) appearance.edges = edges;
  ImGui::SameLine();
  ImGui::Checkbox("cage", &appearance.cage);
  ImGui::SameLine();
  ImGui::Checkbox("normals", &appearance.normals);
  if (looks[appearance.look].flatness)
    ImGui::Text("worst cell: %.4f of its size from flat", static_cast<double>(facts.bend.most));
}

}  // namespace

void layOutOptions(Player& player, const InterfaceFacts& facts) {
  ImGui::SetNextWindowPos({12, 12});
  ImGui::Begin("options", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  const PlaySurface& surface = *player.surface();
  const Far::Topology& last = surface.refinement().last().topology;
  ImGui::TextUnformatted(std::filesystem::path(surface.file()).filename().string().c_str());
  ImGui::TextDisabled("%s cells, %s vertices", grouped(last.faceCount()).c_str(), grouped(last.vertexCount()).c_str());
  ImGui::Separator();
  layOutScheme(player);
  ImGui::Separator();
  layOutBackend(player);
  ImGui::Separator();
  layOutLook(player, facts);
  ImGui::Separator();
  ImGui::TextDisabled("? keys   P picture   Tab hide");
  ImGui::End();
}

}  // namespace honeycomb::Cli::Play
