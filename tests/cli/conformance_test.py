"""`certet conformance` writes the committed kit."""

import pathlib

from program import ProgramTest

KIT = pathlib.Path(__file__).parents[1] / "conformance" / "kit.json"


class ConformanceTest(ProgramTest):

    def setUp(self):
        super().setUp()
        self.kit = KIT.read_text(encoding="utf-8")

    def test_goes_to_stdout(self):
        run = self.run_certet("conformance")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(run.stdout, self.kit)
        self.assertEqual(self.files(), [])

    def test_goes_to_a_file(self):
        run = self.run_certet("conformance", "-o", "kit.json")
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "", ""))
        self.assertEqual((self.folder / "kit.json").read_text(encoding="utf-8"), self.kit)
        self.assertEqual(self.files(), ["kit.json"])

    def test_goes_into_a_folder(self):
        (self.folder / "kits").mkdir()
        self.assertEqual(self.run_certet("conformance", "-o", "kits").returncode, 0)
        written = self.folder / "kits" / "certet-conformance.json"
        self.assertEqual(written.read_text(encoding="utf-8"), self.kit)

    def test_says_where_it_cannot_write(self):
        self.assert_fails(6, ["nowhere/kit.json", "no such folder"],
                          "conformance", "-o", "nowhere/kit.json")
        self.assert_fails(2, ["extra"], "conformance", "extra")
