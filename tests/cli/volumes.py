"""OpenVDB volumes, which a program of the tests writes where OpenVDB is there."""

import os
import subprocess

WRITE_VOLUMES = os.environ.get("CERTET_WRITE_VOLUMES", "")


class WithVolumes:
    """Before the ProgramTest that a test is: its folder has the volumes, or the test is skipped."""

    def setUp(self):
        super().setUp()
        if not WRITE_VOLUMES:
            self.skipTest("without OpenVDB")
        subprocess.run([WRITE_VOLUMES, self.folder], check=True)
