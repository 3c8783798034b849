#pragma once

#include <span>
#include <string_view>

#include "apps/cli/play/player.h"

namespace honeycomb::Cli::Play {

/// A key: what it types, in capitals, or one of those below.
enum class Key : int { escape = 256, left, right, up, down, home, end, tab, space = ' ' };
constexpr Key keyOf(char typed) {
  return static_cast<Key>(typed);
}

/// What a key does. All that can be done by the mouse can be done by keys.
struct KeyCommand {
  Key key;
  std::string_view name;  ///< of the key, as the help has it
  std::string_view help;
  void (*act)(Player&);
};

/// All of them, in the order of the help.
std::span<const KeyCommand> keyCommands();

/// Does what the key is for, and puts the last message away. False where it is for nothing.
bool press(Player& player, Key key);

}  // namespace honeycomb::Cli::Play
