#include "apps/cli/info_report.h"

#include <fmt/format.h>

#include <iterator>

#include "apps/cli/console.h"
#include "apps/cli/json_text.h"
#include "apps/cli/mesh_facts.h"
#include "far/tables/bounds.h"

namespace honeycomb::Cli {
namespace {

using Json = nlohmann::ordered_json;

Json histogramJson(const Histogram& histogram) {
  Json json = Json::object();
  for (const auto& entry : histogram) json[std::to_string(entry.first)] = entry.second;
  return json;
}

/// "3: 120   4: 80"
std::string histogramText(const Histogram& histogram) {
  std::string text;
  for (const auto& entry : histogram)
    text += fmt::format("{}{}: {}", text.empty() ? "" : "   ", entry.first, grouped(entry.second));
  return text;
}

std::string boundariesText(const std::vector<std::int64_t>& loops) {
  constexpr std::size_t kShown = 8;
  if (loops.empty()) return "none, the mesh is closed";
  std::string text = fmt::format("{}, of", grouped(std::ssize(loops)));
  for (std::size_t i = 0; i < loops.size() && i < kShown; ++i)
    text += fmt::format("{} {}", i == 0 ? "" : ",", grouped(loops[i]));
  return text + (loops.size() > kShown ? ", ... edges" : " edges");
}

bool fits(const LevelSize& size, std::int64_t memory) {
  return size.counts.halfEdges <= kMostHalfEdges && size.runBytes <= memory;
}

std::string levelsText(const MeshReport& report) {
  std::string text =
      fmt::format("\n{:>5} {:<13} {:>17} {:>17} {:>17} {:>17} {:>10} {:>10} {:>10}\n", "level", "made by", "vertices",
                  "edges", "faces", "half-edges", "tables", "points", "whole run");
  for (const LevelSize& size : report.sizes) {
    const Far::LevelCounts& counts = size.counts;
    const std::string_view mark = counts.halfEdges > kMostHalfEdges ? "  past 2^31 half-edges"
                                  : !fits(size, report.memory)      ? "  more than is free"
                                  : counts.exact                    ? ""
                                                                    : "  at most";
    fmt::format_to(std::back_inserter(text), "{:>5} {:<13} {:>17} {:>17} {:>17} {:>17} {:>10} {:>10} {:>10}{}\n",
                   size.level, size.step.empty() ? "IN" : size.step, grouped(counts.vertices), grouped(counts.edges),
                   grouped(counts.faces), grouped(counts.halfEdges), humanBytes(counts.bytes),
                   humanBytes(size.pointBytes), humanBytes(size.runBytes), mark);
  }
  return text + fmt::format("bytes are predictions for single precision and one frame; {} of memory is free\n",
                            humanBytes(report.memory));
}

Json levelsJson(const MeshReport& report) {
  Json levels = Json::array();
  for (const LevelSize& size : report.sizes) {
    levels.push_back({{"level", size.level},
                      {"step", size.step.empty() ? Json() : Json(size.step)},
                      {"vertices", size.counts.vertices},
                      {"edges", size.counts.edges},
                      {"faces", size.counts.faces},
                      {"half_edges", size.counts.halfEdges},
                      {"boundary_edges", size.counts.boundaryEdges},
                      {"exact", size.counts.exact},
                      {"table_bytes", size.counts.bytes},
                      {"point_bytes", size.pointBytes},
                      {"run_bytes", size.runBytes},
                      {"fits", fits(size, report.memory)}});
  }
  return levels;
}

std::string droppedText(const MeshInput& input) {
  return input.dropped() == 0 ? "" : fmt::format("   ({} isolated left out)", grouped(input.dropped()));
}

/// Clips, nodes and notes, where there are any.
std::string sceneText(const MeshInput& input) {
  std::string text;
  const auto out = std::back_inserter(text);
  if (input.frames) fmt::format_to(out, "  {:<12} {}\n", "frames", grouped(input.frames->info().frameCount));
  for (const Io::SceneClip& clip : input.clips)
    fmt::format_to(out, "  {:<12} '{}': {:.4g} seconds, {}\n", "clip", clip.name, clip.seconds,
                   counted(clip.keys, "key"));
  for (const Io::SceneNode& node : input.nodes)
    fmt::format_to(out, "  {:<12} '{}': {}, {}{}{}\n", "node", node.name,
                   node.vertices == 1 ? "1 vertex" : grouped(node.vertices) + " vertices", counted(node.faces, "face"),
                   node.skinned ? ", skinned" : "", node.morphed ? ", morphed" : "");
  for (const std::string& note : input.notes) fmt::format_to(out, "  {:<12} {}\n", "note", note);
  return text;
}

void addScene(Json& json, const MeshInput& input) {
  if (input.frames) json["frames"] = input.frames->info().frameCount;
  if (!input.notes.empty()) json["notes"] = input.notes;
  if (input.nodes.empty()) return;
  Json clips = Json::array(), nodes = Json::array();
  for (const Io::SceneClip& clip : input.clips)
    clips.push_back({{"name", clip.name}, {"seconds", clip.seconds}, {"keys", clip.keys}});
  for (const Io::SceneNode& node : input.nodes)
    nodes.push_back({{"name", node.name},
                     {"vertices", node.vertices},
                     {"faces", node.faces},
                     {"skinned", node.skinned},
                     {"morphed", node.morphed}});
  json["clips"] = clips;
  json["nodes"] = nodes;
}

}  // namespace

std::string meshText(const MeshReport& report) {
  const MeshFacts facts = gatherFacts(report.topology);
  const Far::Box<double> bounds = Far::bounds<double>(report.input.mesh.positions);
  const Far::Topology& topology = report.topology;
  std::string text = report.input.file + "\n";
  const auto row = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "  {:<12} {}\n", name, value);
  };
  row("vertices", grouped(topology.vertexCount()) + droppedText(report.input));
  row("edges", grouped(topology.edgeCount()));
  row("faces", grouped(topology.faceCount()));
  row("half-edges", grouped(topology.halfEdgeCount()));
  row("sides", histogramText(countSides(report.input.mesh.polygons)));
  row("valences", histogramText(facts.valences));
  row("boundaries", boundariesText(facts.boundaryLoops));
  row("components", grouped(facts.components));
  row("Euler", fmt::format("V - E + F = {}, genus {}", topology.eulerCharacteristic(), facts.genus));
  row("bounds", fmt::format("{:.6g} {:.6g} {:.6g} to {:.6g} {:.6g} {:.6g}", bounds.low[0], bounds.low[1], bounds.low[2],
                            bounds.high[0], bounds.high[1], bounds.high[2]));
  row("defects", "none");
  return text + sceneText(report.input) + levelsText(report);
}

std::string meshJson(const MeshReport& report) {
  const MeshFacts facts = gatherFacts(report.topology);
  const Far::Box<double> bounds = Far::bounds<double>(report.input.mesh.positions);
  Json json{{"file", report.input.file},
            {"vertices", report.topology.vertexCount()},
            {"edges", report.topology.edgeCount()},
            {"faces", report.topology.faceCount()},
            {"half_edges", report.topology.halfEdgeCount()},
            {"dropped_vertices", report.input.dropped()},
            {"sides", histogramJson(countSides(report.input.mesh.polygons))},
            {"valences", histogramJson(facts.valences)},
            {"boundary_loops", facts.boundaryLoops},
            {"components", facts.components},
            {"euler_characteristic", report.topology.eulerCharacteristic()},
            {"genus", facts.genus},
            {"bounds", {{"low", bounds.low}, {"high", bounds.high}}},
            {"defects", Json::array()},
            {"memory_bytes", report.memory},
            {"levels", levelsJson(report)}};
  addScene(json, report.input);
  return jsonText(json);
}

std::string defectsText(const DefectList& list) {
  const Far::Polygons& polygons = list.input.mesh.polygons;
  std::string text =
      fmt::format("{}\n  {:<12} {}{}\n  {:<12} {}\n  {:<12} {}\n  {:<12} {}\n\n", list.input.file, "vertices",
                  grouped(polygons.vertexCount), droppedText(list.input), "faces", grouped(polygons.faceCount()),
                  "sides", histogramText(countSides(polygons)), "defects", grouped(std::ssize(list.defects)));
  for (const Far::Defect& defect : list.defects) {
    const DefectReport entry = report(list.input, defect);
    fmt::format_to(std::back_inserter(text), "{}: {}: {}\n", placeInFile(list.input, entry.line), entry.what,
                   entry.remedy);
  }
  return text + fmt::format("face and vertex numbers count from 1{}\n", countedAs(list.input)) + sceneText(list.input);
}

std::string defectsJson(const DefectList& list) {
  Json defects = Json::array();
  for (const Far::Defect& defect : list.defects) {
    const DefectReport entry = report(list.input, defect);
    defects.push_back({{"line", entry.line > 0 ? Json(entry.line) : Json()},
                       {"face", entry.face > 0 ? Json(entry.face) : Json()},
                       {"vertex", entry.vertex > 0 ? Json(entry.vertex) : Json()},
                       {"what", entry.what},
                       {"remedy", entry.remedy}});
  }
  const Far::Polygons& polygons = list.input.mesh.polygons;
  Json json{{"file", list.input.file},
            {"vertices", polygons.vertexCount},
            {"faces", polygons.faceCount()},
            {"dropped_vertices", list.input.dropped()},
            {"sides", histogramJson(countSides(polygons))},
            {"defects", defects}};
  addScene(json, list.input);
  return jsonText(json);
}

}  // namespace honeycomb::Cli
