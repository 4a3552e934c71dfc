"""The notebook of the examples, run anew: it prints what it shows."""

import os
import pathlib
import unittest
import unittest.mock

try:
    import nbformat
    from jupyter_client.kernelspec import find_kernel_specs
    from nbclient import NotebookClient

    missing = "" if "python3" in find_kernel_specs() else "the kernel of notebooks is missing"
except ImportError as error:
    missing = f"no notebook runs here: {error}"

EXAMPLES = pathlib.Path(os.environ["CERTET_EXAMPLES"])


def printed(notebook):
    """What each cell prints, in however many parts, and the kinds of what it shows."""
    cells = [[output for output in cell.outputs if output.get("name") != "stderr"]
             for cell in notebook.cells if cell.cell_type == "code"]
    return [("".join(output.get("text", "") for output in cell),
             [sorted(output.data) for output in cell if "data" in output]) for cell in cells]


@unittest.skipIf(missing, missing)
class Notebooks(unittest.TestCase):
    def test_they_print_what_they_show(self):
        found = sorted(EXAMPLES.glob("notebook/*.ipynb"))
        self.assertTrue(found)
        path = os.path.dirname(os.environ["CERTET"]) + os.pathsep + os.environ["PATH"]
        for file in found:
            with self.subTest(file.name), unittest.mock.patch.dict(os.environ, {"PATH": path}):
                notebook = nbformat.read(file, as_version=4)
                shown = printed(notebook)
                self.assertGreater(len(shown), 3)
                NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
                self.assertEqual(printed(notebook), shown)


if __name__ == "__main__":
    unittest.main()
