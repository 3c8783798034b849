"""playback_without_matplotlib.py PLAYBACK arguments...: runs the example where there is no matplotlib, and reads the mesh
that it writes then."""
import runpy
import sys

import honeycomb

sys.modules["matplotlib"] = None
del sys.argv[0]
runpy.run_path(sys.argv[0], run_name="__main__")
print(honeycomb.Mesh.read("playback.obj"))
