"""install.py PROJECT FOLDER: what a user does with the module in a build folder, without a network."""
import pathlib
import shutil
import subprocess
import sys

project, folder = map(pathlib.Path, sys.argv[1:3])
shutil.rmtree(folder, ignore_errors=True)
subprocess.run([sys.executable, "-m", "pip", "install", "--no-index", "--no-build-isolation", "--no-deps", "--no-cache-dir",
                "--disable-pip-version-check", "--root-user-action=ignore", "--target", folder, project],
               check=True, timeout=250)
extensions = list(folder.glob("honeycomb/_honeycomb*.so"))
assert len(extensions) == 1, f"pip installed the extensions {extensions}"
tag, = folder.glob("honeycomb-*.dist-info/WHEEL")
assert "Root-Is-Purelib: false" in tag.read_text(encoding="utf-8"), "the wheel would go to any platform"
