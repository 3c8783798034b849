#pragma once

#include "apps/cli/play/window/interface.h"

namespace honeycomb::Cli::Play {

/// The parts of the interface.
void layOutOptions(Player& player, const InterfaceFacts& facts);
void layOutTransport(Player& player);
void layOutGraphs(const Player& player, const InterfaceFacts& facts);
void layOutHelp(Player& player);
void layOutMessage(const Player& player);

}  // namespace honeycomb::Cli::Play
