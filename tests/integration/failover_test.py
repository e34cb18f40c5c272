"""scripts/failover with a face-player that does not start.

    failover_test.py --bin FOLDER --scripts FOLDER
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile
import unittest

PATIENCE = 60.0  # seconds until the test gives up waiting
ARGUMENTS = argparse.Namespace()


class Failover(unittest.TestCase):
    def test_says_that_a_player_does_not_start(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "au-transmitter").symlink_to(ARGUMENTS.bin / "au-transmitter")
            player = folder / "face-player"
            player.write_text("#!/bin/sh\necho 'no face here' >&2\nexit 4\n")
            player.chmod(0o755)
            done = subprocess.run(
                [ARGUMENTS.scripts / "failover", "--bin", folder, "--players", "1", "--viewers", "2",
                 "--seconds", "1"], capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 1)
        self.assertIn("face-player does not play: no face here", done.stderr)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    parser.add_argument("--scripts", type=pathlib.Path, required=True)
    parser.parse_args(namespace=ARGUMENTS)
    unittest.main(argv=sys.argv[:1])


if __name__ == "__main__":
    main()
