#!/usr/bin/env bash
# debian.sh BUILD FOLDER DATA: makes the Debian packages, unpacks them as a system's root and runs the program from there.
set -euo pipefail
rm -rf "$2" && mkdir -p "$2/root" && cd "$2"
cpack --config "$1/CPackConfig.cmake" -B "$2" >cpack.log || { cat cpack.log; exit 1; }
for package in honeycomb_*.deb libhoneycomb-dev_*.deb; do
  dpkg-deb --extract "$package" root
done
dpkg-deb --field honeycomb_*.deb Depends | grep -q libc6
dpkg-deb --field libhoneycomb-dev_*.deb Depends | grep -q libfmt-dev
[[ -f $(echo root/usr/include/honeycomb/far/topology/topology.h) ]]
root/usr/bin/honeycomb refine "root/usr/$3/honeycomb/creature.obj" fine.obj --levels 1 --quiet
grep -q ^f fine.obj
