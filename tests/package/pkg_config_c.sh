#!/usr/bin/env bash
# pkg_config_c.sh PREFIX LIBRARIES SOURCE: builds a source in C by what honeycomb-c.pc says, and runs it.
set -euo pipefail
flags=$(PKG_CONFIG_PATH=$2/pkgconfig pkg-config --cflags --libs honeycomb-c)
# In words, as in anybody's makefile.
# shellcheck disable=SC2086
cc -std=c99 -O1 "$3" -o "$1.by_pkg_config_c" $flags -lm
LD_LIBRARY_PATH=$2 "$1.by_pkg_config_c"
