#!/usr/bin/env bash
# pkg_config.sh PREFIX FOLDER SOURCE COMPILER: builds the source by what the .pc files in the folder say, and runs it.
set -euo pipefail
export PKG_CONFIG_PATH=$2
flags=$(pkg-config --cflags --libs honeycomb-osd honeycomb-io)
# In words, as in anybody's makefile.
# shellcheck disable=SC2086
"$4" -std=c++20 -O1 "$3" -o "$1.by_pkg_config" $flags
"$1.by_pkg_config" "$1"/share/honeycomb/creature.{obj,pc2} 2
