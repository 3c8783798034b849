#include "apps/cli/play/window/panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "apps/cli/play/key_commands.h"

namespace honeycomb::Cli::Play {
namespace {

constexpr float kPanelMargin = 12;
constexpr double kMessageSeconds = 3;
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                                    ImGuiWindowFlags_NoNav;

float widthOf(const char* text) {
  return ImGui::CalcTextSize(text).x;
}

// What stands right in the panel ends where graphs do.
constexpr float kGraphWidth = 220;

void row(const char* label, const std::string& value) {
  ImGui::TextDisabled("%s", label);
  ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + kGraphWidth - widthOf(value.c_str()));
  ImGui::TextUnformatted(value.c_str());
}

void plot(const char* label, const History& history, const std::string& value) {
  row(label, value);
  const auto values = history.values();
  ImGui::PlotLines(fmt::format("##{}", label).c_str(), values.data(), static_cast<int>(values.size()), 0, nullptr, 0,
                   std::max(1.15f * history.most(), 1e-3f), {kGraphWidth, 34});
}

std::string milliseconds(const History& history) {
  return fmt::format("{:.2f} ms", history.median());
}

void listKeys(std::size_t first, std::size_t end) {
  ImGui::BeginGroup();
  for (std::size_t i = first; i < end; ++i) {
    const KeyCommand& command = keyCommands()[i];
    ImGui::TextColored({0.94f, 0.75f, 0.34f, 1}, "%s", std::string(command.name).c_str());
    ImGui::SameLine(64);
    ImGui::TextUnformatted(std::string(command.help).c_str());
  }
  ImGui::EndGroup();
}

}  // namespace

void layOutGraphs(const Player& player, const InterfaceFacts& facts) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x - kPanelMargin, kPanelMargin}, ImGuiCond_Always, {1, 0});
  ImGui::Begin("graphs", nullptr, kFixed | ImGuiWindowFlags_NoInputs);
  const Histories& histories = player.histories;
  ImGui::Text("%.1f frames a second", facts.framesPerSecond);
  ImGui::TextDisabled("%s", facts.device.c_str());
  plot("evaluate", histories.evaluate, milliseconds(histories.evaluate));
  for (const Osd::LevelTime& level : histories.levels) {
    const std::string label = fmt::format(" device, level {}{}", level.level, level.limits ? " limits" : "");
    row(label.c_str(), fmt::format("{:.2f} ms", level.milliseconds));
  }
  plot("upload", histories.upload, milliseconds(histories.upload));
  plot("draw", histories.draw, milliseconds(histories.draw));
  if (player.comparing)
    plot("backends differ by", histories.difference, fmt::format("{:g} ulp", histories.difference.most()));
  ImGui::End();
}

void layOutTransport(Player& player) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  PlayClock& clock = player.clock;
  ImGui::SetNextWindowPos({0.5f * size.x, size.y - kPanelMargin}, ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowSize({std::min(760.0f, size.x - 2 * kPanelMargin), 0});
  ImGui::Begin("transport", nullptr, kFixed & ~ImGuiWindowFlags_AlwaysAutoResize);
  if (ImGui::Button(clock.playing() ? "pause" : "play", {58, 0})) clock.toggle();
  ImGui::SameLine();
  if (ImGui::Button("<")) clock.step(-1);
  ImGui::SameLine();
  if (ImGui::Button(">")) clock.step(1);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-250);
  int frame = clock.frame();
  if (ImGui::SliderInt("##frame", &frame, 0, clock.frames() - 1, "frame %d")) clock.scrub(frame);
  ImGui::SameLine();
  bool loop = clock.loops();
  if (ImGui::Checkbox("loop", &loop)) clock.setLoop(loop);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  auto speed = static_cast<float>(clock.speed());
  if (ImGui::SliderFloat("##speed", &speed, -4, 4, "speed %.2f")) clock.setSpeed(speed);
  ImGui::End();
}

void layOutHelp(Player& player) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * size.x, 0.5f * size.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::Begin("keys", &player.panels.help, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse);
  const std::size_t half = (keyCommands().size() + 1) / 2;
  listKeys(0, half);
  ImGui::SameLine(300);
  listKeys(half, keyCommands().size());
  ImGui::Separator();
  ImGui::TextDisabled("left button: turn      right or middle button: move      wheel: closer, farther");
  ImGui::TextDisabled("drop a mesh, or a point cache for the mesh there is, onto the window");
  ImGui::End();
}

void layOutMessage(const Player& player) {
  const bool fresh = !player.message().empty() && player.messageAge() < kMessageSeconds;
  if (!fresh && !player.building() && !player.awaited) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * size.x, size.y - 74}, ImGuiCond_Always, {0.5f, 1});
  ImGui::Begin("message", nullptr, kFixed | ImGuiWindowFlags_NoInputs);
  ImGui::PushTextWrapPos(640);
  if (player.building()) ImGui::TextDisabled("building tables ..");
  if (player.awaited) ImGui::TextDisabled("bringing the tables to %s ..", player.backend.current().c_str());
  if (fresh) ImGui::TextUnformatted(player.message().c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
}

}  // namespace honeycomb::Cli::Play
