#pragma once

#include "chain/choice.h"
#include "chain/scheme_chain.h"
#include "chain/scheme_options.h"
#include "chain/schemes.h"
#include "chain/words.h"

/// The command line speaks of schemes, their options and of choices among names as chain/ does.
namespace honeycomb::Cli {
using namespace Chain;
}
