#include "osd/vulkan/pruned_code.h"

#include <array>
#include <bit>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace honeycomb::Osd {
namespace {

using Words = std::span<const std::uint32_t>;

// SPIR-V 1.6, 2.3 "Physical Layout" and 3.32 "Instructions".
constexpr std::size_t kHeaderWords = 5;
constexpr std::uint32_t kSpecId = 1;  // the decoration

enum Opcode : std::uint32_t {
  kConstantTrue = 41,
  kConstantFalse = 42,
  kConstant = 43,
  kSpecConstantTrue = 48,
  kSpecConstantFalse = 49,
  kSpecConstant = 50,
  kSpecConstantOp = 52,
  kDecorate = 71,
  kLogicalOr = 166,
  kLogicalAnd = 167,
  kLogicalNot = 168,
  kIEqual = 170,
  kINotEqual = 171,
  kUGreaterThan = 172,
  kUGreaterThanEqual = 174,
  kULessThan = 176,
  kULessThanEqual = 178,
  kShiftRightLogical = 194,
  kBitwiseAnd = 199,
  kPhi = 245,
  kSelectionMerge = 247,
  kLabel = 248,
  kBranch = 249,
  kBranchConditional = 250
};

std::uint32_t opcodeOf(Words instruction) {
  return instruction[0] & 0xffffU;
}

/// False where the code ends within an instruction.
template <class Visit>
bool forEachInstruction(Words code, const Visit& visit) {
  for (std::size_t i = kHeaderWords; i < code.size();) {
    const std::size_t length = code[i] >> 16;
    if (length == 0 || length > code.size() - i) return false;
    visit(code.subspan(i, length));
    i += length;
  }
  return true;
}

/// Of unsigned numbers, and of truth values as 0 and 1; nothing for operations that no kernel branches on.
std::optional<std::uint32_t> result(std::uint32_t operation, std::uint32_t a, std::uint32_t b) {
  switch (operation) {
    case kLogicalOr:
      return a | b;
    case kLogicalAnd:
    case kBitwiseAnd:
      return a & b;
    case kLogicalNot:
      return a ^ 1U;
    case kIEqual:
      return a == b ? 1U : 0U;
    case kINotEqual:
      return a != b ? 1U : 0U;
    case kUGreaterThan:
      return a > b ? 1U : 0U;
    case kUGreaterThanEqual:
      return a >= b ? 1U : 0U;
    case kULessThan:
      return a < b ? 1U : 0U;
    case kULessThanEqual:
      return a <= b ? 1U : 0U;
    case kShiftRightLogical:
      return b < 32 ? std::optional(a >> b) : std::nullopt;
    default:
      return std::nullopt;
  }
}

/// What is known of a module's ids before it runs.
class KnownIds {
 public:
  explicit KnownIds(const Specialization& specialization)
      : constants_(std::bit_cast<std::array<std::uint32_t, kSpecializationCount>>(specialization)) {}

  void read(Words instruction) {
    const std::uint32_t opcode = opcodeOf(instruction);
    if (opcode == kLabel) label_ = instruction[1];
    if (opcode == kPhi) joins_.insert(label_);
    if (opcode == kDecorate && instruction.size() == 4 && instruction[2] == kSpecId)
      numbers_[instruction[1]] = instruction[3];
    if (instruction.size() < 3) return;
    if (const auto value = valueOf(instruction)) values_[instruction[2]] = *value;
  }
  /// The block that a conditional branch goes to whatever is computed. One that begins with a phi stays the target of
  /// the branches that its phi names.
  std::optional<std::uint32_t> target(Words branch) const {
    if (opcodeOf(branch) != kBranchConditional) return std::nullopt;
    const auto condition = values_.find(branch[1]);
    if (condition == values_.end()) return std::nullopt;
    const std::uint32_t taken = condition->second != 0 ? branch[2] : branch[3];
    const std::uint32_t other = condition->second != 0 ? branch[3] : branch[2];
    return joins_.contains(other) ? std::nullopt : std::optional(taken);
  }

 private:
  std::optional<std::uint32_t> valueOf(Words instruction) const {
    switch (opcodeOf(instruction)) {
      case kConstantTrue:
        return 1U;
      case kConstantFalse:
        return 0U;
      case kConstant:
        return instruction.size() == 4 ? std::optional(instruction[3]) : std::nullopt;
      case kSpecConstantTrue:
      case kSpecConstantFalse:
        return truth(specialized(instruction[2]));
      case kSpecConstant:
        return specialized(instruction[2]);
      case kSpecConstantOp:
        return computed(instruction);
      default:
        return std::nullopt;
    }
  }

  std::optional<std::uint32_t> specialized(std::uint32_t id) const {
    const auto number = numbers_.find(id);
    if (number == numbers_.end() || number->second >= kSpecializationCount) return std::nullopt;
    return constants_[number->second];
  }
  static std::optional<std::uint32_t> truth(std::optional<std::uint32_t> value) {
    return value && *value != 0 ? std::optional(1U) : value;
  }
  /// Of one operand or two.
  std::optional<std::uint32_t> computed(Words instruction) const {
    if (instruction.size() < 5 || instruction.size() > 6) return std::nullopt;
    const auto a = values_.find(instruction[4]), b = values_.find(instruction.back());
    if (a == values_.end() || b == values_.end()) return std::nullopt;
    return result(instruction[3], a->second, b->second);
  }

  std::array<std::uint32_t, kSpecializationCount> constants_;
  std::unordered_map<std::uint32_t, std::uint32_t> numbers_;  ///< constant_id of ids
  std::unordered_map<std::uint32_t, std::uint32_t> values_;
  std::unordered_set<std::uint32_t> joins_;  ///< blocks that begin with a phi
  std::uint32_t label_ = 0;
};

}  // namespace

std::vector<std::uint32_t> prunedCode(std::span<const std::uint32_t> code, const Specialization& specialization) {
  KnownIds known(specialization);
  if (!forEachInstruction(code, [&](Words instruction) { known.read(instruction); })) return {code.begin(), code.end()};
  std::vector<std::uint32_t> pruned(code.begin(), code.begin() + kHeaderWords);
  const auto append = [&](Words words) { pruned.insert(pruned.end(), words.begin(), words.end()); };
  // A selection is announced by the instruction before its branch; a loop's branch is announced otherwise, and stays.
  Words merge;
  forEachInstruction(code, [&](Words instruction) {
    if (opcodeOf(instruction) == kSelectionMerge) {
      merge = instruction;
      return;
    }
    const auto target = merge.empty() ? std::nullopt : known.target(instruction);
    if (target) append(std::array{(2U << 16) | kBranch, *target});
    if (!target) append(merge);
    if (!target) append(instruction);
    merge = {};
  });
  return pruned;
}

}  // namespace honeycomb::Osd
