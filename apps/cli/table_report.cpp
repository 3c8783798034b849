#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "apps/cli/json_text.h"
#include "apps/cli/table_commands.h"
#include "far/base/stopwatch.h"
#include "io/table_file.h"

namespace honeycomb::Cli {
namespace {

using Io::TableFile;

std::string tableText(const std::string& name, const TableFile& file) {
  std::string text = fmt::format(
      "{}: {}, mesh {:016x}\n  control mesh  {} vertices, {} faces\n  last level    {} vertices, {} faces\n", name,
      humanBytes(file.byteCount()), file.info().meshHash, grouped(file.info().inputVertices),
      grouped(file.info().inputFaces), grouped(file.vertexCount()), grouped(file.faceCount()));
  for (std::size_t k = 0; k < file.info().steps.size(); ++k)
    text += fmt::format("  level {:<7} {}\n", k + 1, file.info().steps[k]);
  for (const Io::TablePrimvar& primvar : file.info().primvars)
    text += fmt::format("  primvar       {} {}\n", primvar.name, primvar.length);
  text += fmt::format("  limits        {}\n  tiles         {}\n", file.hasLimits() ? "yes" : "no",
                      file.hasTiles() ? "yes" : "no");
  for (const Io::TableSection& section : file.sections())
    text += fmt::format("  {:>12}  {:>12}  {}\n", section.offset, humanBytes(std::ssize(section.bytes)), section.name);
  return text;
}

std::string tableJson(const std::string& name, const TableFile& file) {
  auto sections = nlohmann::ordered_json::array();
  for (const Io::TableSection& section : file.sections())
    sections.push_back({{"name", section.name},
                        {"offset", section.offset},
                        {"bytes", section.bytes.size()},
                        {"elements", section.count},
                        {"checksum", fmt::format("{:016x}", section.checksum)}});
  auto primvars = nlohmann::ordered_json::object();
  for (const Io::TablePrimvar& primvar : file.info().primvars) primvars[primvar.name] = primvar.length;
  return jsonText({{"file", name},
                   {"bytes", file.byteCount()},
                   {"mesh_hash", fmt::format("{:016x}", file.info().meshHash)},
                   {"control_vertices", file.info().inputVertices},
                   {"control_faces", file.info().inputFaces},
                   {"control_points", file.controlPoints()},
                   {"levels", file.levelCount()},
                   {"steps", file.info().steps},
                   {"vertices", file.vertexCount()},
                   {"faces", file.faceCount()},
                   {"primvars", primvars},
                   {"limits", file.hasLimits()},
                   {"tiles", file.hasTiles()},
                   {"sections", sections}});
}

Result<void> tableInfo(const std::string& name, const Session& session) {
  const Result<TableFile> file = TableFile::open(name);
  if (!file) return tl::unexpected(file.error());
  return printResult(session.json ? tableJson(name, *file) : tableText(name, *file));
}

Result<void> tableCheck(const std::string& name, const Session& session) {
  Stopwatch stopwatch;
  const Result<TableFile> file = TableFile::open(name);
  if (!file) return tl::unexpected(file.error());
  const double openMs = stopwatch.lap();
  if (auto sound = file->check(); !sound) return sound;
  const double checkMs = stopwatch.lap();
  if (session.json)
    return printResult(jsonText(
        {{"file", name}, {"bytes", file->byteCount()}, {"sound", true}, {"open_ms", openMs}, {"check_ms", checkMs}}));
  return printResult(fmt::format("{}: sound, {}\n", name, humanBytes(file->byteCount())));
}

std::string differenceText(const Io::TableDifference& difference, const std::string& first, const std::string& second) {
  if (difference.element >= 0)
    return fmt::format("{}: differs from element {} on", difference.section, difference.element);
  return fmt::format("{}: only in {}", difference.section, difference.inFirst ? first : second);
}

/// Differences are results, and an error in the end.
Result<void> tableDiff(const std::string& first, const std::string& second, const Session& session) {
  const Result<TableFile> a = TableFile::open(first);
  if (!a) return tl::unexpected(a.error());
  const Result<TableFile> b = TableFile::open(second);
  if (!b) return tl::unexpected(b.error());
  const std::vector<Io::TableDifference> found = Io::differences(*a, *b);
  const bool sameMesh = a->info().meshHash == b->info().meshHash;
  std::string text = sameMesh ? "" : "control meshes: differ\n";
  auto sections = nlohmann::ordered_json::array();
  for (const Io::TableDifference& difference : found) {
    text += differenceText(difference, first, second) + "\n";
    sections.push_back({{"section", difference.section},
                        {"element", difference.element},
                        {"in_first", difference.inFirst},
                        {"in_second", difference.inSecond}});
  }
  if (session.json) text = jsonText({{"same_mesh", sameMesh}, {"sections", sections}});
  if (auto printed = printResult(text); !printed) return printed;
  if (found.empty() && sameMesh) return {};
  return fail(ErrorCode::invalidFile,
              fmt::format("{} and {} differ in {}", first, second,
                          found.empty() ? "their control mesh" : counted(std::ssize(found), "section")));
}

/// A subcommand that takes one table file.
void addOfFile(CLI::App& table, Command& command, const std::string& name, const std::string& help,
               Result<void> (*act)(const std::string&, const Session&)) {
  const auto file = std::make_shared<std::string>();
  CLI::App* subcommand = table.add_subcommand(name, help);
  subcommand->add_option("FILE", *file, "Table file (.hct)")->required();
  addSessionOptions(*subcommand, command.session);
  subcommand->callback(
      [file, act, &command] { command.action = [file, act](const Session& session) { return act(*file, session); }; });
}

}  // namespace

void addTableInfo(CLI::App& table, Command& command) {
  addOfFile(table, command, "info", "What a table file has, section by section", tableInfo);
}

void addTableCheck(CLI::App& table, Command& command) {
  addOfFile(table, command, "check", "Compare all checksums and prove all indices of a table file", tableCheck);
}

void addTableDiff(CLI::App& table, Command& command) {
  struct Files {
    std::string first, second;
  };
  const auto files = std::make_shared<Files>();
  CLI::App* subcommand =
      table.add_subcommand("diff", "The sections in which two table files differ; exit 1 if they do");
  subcommand->add_option("A", files->first, "Table file (.hct)")->required();
  subcommand->add_option("B", files->second, "Table file (.hct)")->required();
  addSessionOptions(*subcommand, command.session);
  subcommand->callback([files, &command] {
    command.action = [files](const Session& session) { return tableDiff(files->first, files->second, session); };
  });
}

}  // namespace honeycomb::Cli
