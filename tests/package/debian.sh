#!/usr/bin/env bash
# debian.sh BUILD FOLDER DATA [PYTHON]: makes the Debian packages, unpacks them as a system's root and runs the program, and
# with PYTHON the module, from there.
set -euo pipefail
rm -rf "$2" && mkdir -p "$2/root" && cd "$2"
cpack --config "$1/CPackConfig.cmake" -B "$2" >cpack.log || { cat cpack.log; exit 1; }
for package in honeycomb_*.deb libhoneycomb-dev_*.deb ${4:+python3-honeycomb_*.deb}; do
  dpkg-deb --extract "$package" root
done
dpkg-deb --field honeycomb_*.deb Depends | grep -q libc6
dpkg-deb --field libhoneycomb-dev_*.deb Depends | grep -q libfmt-dev
[[ -f $(echo root/usr/include/honeycomb/far/topology/topology.h) ]]
root/usr/bin/honeycomb refine "root/usr/$3/honeycomb/creature.obj" fine.obj --levels 1 --quiet
grep -q ^f fine.obj
[[ -n "${4:-}" ]] || exit 0
dpkg-deb --field python3-honeycomb_*.deb Depends | grep -q python3-numpy
PYTHONPATH=root/usr/lib/python3/dist-packages "$4" -B -c "
import honeycomb
mesh = honeycomb.Mesh.read('fine.obj')
assert honeycomb.refine(mesh)[0].shape[0] > len(mesh.points) and 'root/usr' in honeycomb.__file__"
