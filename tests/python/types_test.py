"""Type stubs, as mypy reads them in a user's own strict code."""

import os
import shutil
import subprocess
import tempfile
import textwrap
import unittest

PACKAGE = os.environ["PYTHONPATH"].split(os.pathsep)[0]
RIGHT = """
    import certet
    import numpy as np

    labels = np.zeros((8, 8, 8), np.uint8)
    mesh: certet.Mesh = certet.mesh_image(labels, spacing=(1, 1, 2), size=1.0, keep="largest")
    least: float = certet.quality(mesh).min_dihedral
    patches: list[certet.Patch] = mesh.patches()
    finer = certet.mesh_image(labels, target_tets=10_000, method="key", order=2, progress=True)
    both = certet.mesh(certet.Solid("sphere:1") - certet.Solid("box:1,1,1"), size=0.1)
    certet.write(both, "both.vtu")
    """
WRONG = {"grade='x'": "grade", "method='fine'": "method", "siz=1": "siz", "order=3": "order",
         "keep=1.5": "keep", "spacing='1'": "spacing"}


@unittest.skipUnless(shutil.which("mypy"), "mypy is missing")
class Types(unittest.TestCase):
    def mypy(self, *arguments):
        return subprocess.run(["mypy", "--enable-incomplete-feature=Unpack", "--cache-dir",
                               self.folder.name, *arguments],
                              env={**os.environ, "MYPYPATH": PACKAGE}, text=True,
                              capture_output=True)

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def strictly(self, text):
        script = os.path.join(self.folder.name, "user.py")
        with open(script, "w") as file:
            file.write(textwrap.dedent(text))
        return self.mypy("--strict", "--follow-imports=silent", script)

    def test_a_users_code_is_right(self):
        done = self.strictly(RIGHT)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_what_is_wrong_is_found(self):
        for option, word in WRONG.items():
            done = self.strictly(f"{textwrap.dedent(RIGHT)}\ncertet.mesh_image(labels, {option})\n")
            self.assertEqual(done.returncode, 1, option)
            self.assertIn(word, done.stdout)

    def test_the_package_itself(self):
        done = self.mypy("--ignore-missing-imports", os.path.join(PACKAGE, "certet"))
        self.assertEqual(done.returncode, 0, done.stdout)


if __name__ == "__main__":
    unittest.main()
