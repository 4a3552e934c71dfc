"""`pip install ./cpp/python` in a fresh virtual environment, and the module tried there."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["CERTET_SOURCE"])
TRY = """
import certet
import numpy as np

box = ((-1.2,) * 3, (1.2,) * 3)
ball = certet.mesh(lambda p: (p**2).sum(1) - 1, bounds=box, size=0.2)
same = certet.mesh(certet.Solid("x^2 + y^2 + z^2 - 1", bounds=box), size=0.2)
assert not certet.check(ball).failures and ball.checksum == same.checksum
labels = np.zeros((20, 20, 20), np.uint8)
labels[5:15, 5:15, 5:15], labels[8:12, 8:12, 8:12] = 1, 2
mesh = certet.mesh(labels)
certet.write(mesh, "labels.vtu")
assert len(certet.read("labels.vtu").tets) == len(mesh.tets)
print(certet.__file__, certet.__version__)
"""


def missing():
    """What pip would need, in words; none."""
    needed = ("setuptools", "wheel", "numpy", "pip")
    lacking = [name for name in needed
               if subprocess.run([sys.executable, "-c", f"import {name}"],
                                 capture_output=True).returncode]
    return f"{', '.join(lacking)} missing" if lacking else ""


@unittest.skipIf(missing(), missing())
class Pip(unittest.TestCase):
    def test_it_installs_and_works(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            source = folder / "certet"
            shutil.copytree(SOURCE / "cpp", source / "cpp",
                            ignore=shutil.ignore_patterns("build", "*.egg-info", "__pycache__"))
            shutil.copy(SOURCE / "CMakeLists.txt", source)
            subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", folder / "venv"],
                           check=True)
            python = folder / "venv" / "bin" / "python"
            done = subprocess.run(
                [python, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps",
                 source / "cpp" / "python"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
            tried = subprocess.run([python, "-c", TRY], cwd=folder, env=environment, text=True,
                                   capture_output=True)
            self.assertEqual(tried.returncode, 0, tried.stderr)
            file, version = tried.stdout.split()
            self.assertTrue(file.startswith(str(folder / "venv")), file)
            self.assertIn(f"VERSION {version} ", (SOURCE / "CMakeLists.txt").read_text())


if __name__ == "__main__":
    unittest.main()
