#include "apps/cli/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "apps/cli/ranks.h"

namespace honeycomb::Cli {
namespace {

void writeLine(std::string line) {
  if (!speaks()) return;
  // File names may hold line breaks; the contract is one line.
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace

bool speaks() {
  static const bool isFirst = rankOfMany().rank == 0;
  return isFirst;
}

bool stderrIsTerminal() {
  return isatty(STDERR_FILENO) == 1;
}

void printError(const Error& error) {
  writeLine(fmt::format("error: {}", error.message));
}

void printNote(const Session& session, std::string_view text) {
  if (!session.quiet && stderrIsTerminal()) writeLine(std::string(text));
}

Result<void> printResult(std::string_view text) {
  if (!speaks()) return {};
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) return fail(ErrorCode::unwritable, "standard output can't be written; is its disk full?");
  return {};
}

std::string grouped(std::int64_t number) {
  const std::string digits = fmt::format("{}", number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const bool between = i > 0 && digits[i - 1] != '-' && (digits.size() - i) % 3 == 0;
    if (between) text.push_back(',');
    text.push_back(digits[i]);
  }
  return text;
}

std::string humanBytes(std::int64_t bytes) {
  static constexpr std::array kUnits{"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
  if (bytes < 1000) return fmt::format("{} bytes", bytes);
  std::size_t unit = 0;
  auto value = static_cast<double>(bytes);
  for (; value >= 999.95 && unit + 1 < kUnits.size(); ++unit) value /= 1000;
  return fmt::format("{:.1f} {}", value, kUnits[unit]);
}

std::string counted(std::int64_t number, std::string_view singular) {
  return fmt::format("{} {}{}", grouped(number), singular, number == 1 ? "" : "s");
}

}  // namespace honeycomb::Cli
