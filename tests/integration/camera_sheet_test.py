"""scripts/camera_sheet with programs of our own in the place of au-transmitter and face-player.

    camera_sheet_test.py --script FILE
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile
import unittest

PATIENCE = 60.0  # seconds until a test gives up waiting
SCRIPT = pathlib.Path()

# A stream of two seconds, of which the second one smiles; what the film's pictures show is reached when
# they end, after 40 ms.
TRANSMITTER = """#!/bin/sh
[ "$1" = convert ] || exit 2
case $2 in *bad.mp4) echo "au-transmitter: bad.mp4: no face is seen in it" >&2; exit 3;; esac
printf 'Beg_Stream\\n0;40\\n0;959\\n12:80,6:40,L4:20,26:3;1\\n12:80,6:40,L4:20,26:3;1000\\nEnd_Stream\\n' >"$3"
"""
# Draws red, then blue; keeps what it was asked for.
PLAYER = """#!/bin/sh
echo "$*" >"$(dirname "$0")/asked"
while [ "$1" != --record ]; do shift; done
ffmpeg -v error -y -f lavfi -i color=red:s=320x320:r=25:d=1 \\
    -f lavfi -i color=blue:s=320x320:r=25:d=1 -filter_complex concat "$2"
"""
WIDTH, FILM_HEIGHT, TEXT_HEIGHT, PADDING = 320, 180, 44, 4
CELL = (WIDTH + PADDING, FILM_HEIGHT + WIDTH + TEXT_HEIGHT + PADDING)


def colour(pixel):
    """'red' of a pixel that is mostly red."""
    names = {(1, 0, 0): "red", (0, 0, 1): "blue", (1, 1, 0): "yellow", (0, 1, 0): "green"}
    return names.get(tuple(int(value > 90) for value in pixel), str(tuple(pixel)))


class Sheet:
    """The pixels of a PNG."""

    def __init__(self, path):
        size = subprocess.run(
            ["ffprobe", "-v", "error", "-show_entries", "stream=width,height", "-of", "csv=p=0",
             path], capture_output=True, text=True, check=True).stdout
        self.width, self.height = map(int, size.split(","))
        self.rgb = subprocess.run(
            ["ffmpeg", "-v", "error", "-i", path, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
            capture_output=True, check=True).stdout

    def pixel(self, x, y):
        return self.rgb[3 * (y * self.width + x):][:3]

    def cell(self, column, row):
        """The colours of film and drawn face, and how many pixels are letters in each line."""
        left, top = column * CELL[0], row * CELL[1]
        letters = [sum(min(self.pixel(x, y)) > 150 for x in range(left, left + WIDTH)
                       for y in range(first, first + TEXT_HEIGHT // 2))
                   for first in (top + FILM_HEIGHT + WIDTH,
                                 top + FILM_HEIGHT + WIDTH + TEXT_HEIGHT // 2)]
        return (colour(self.pixel(left + WIDTH // 2, top + FILM_HEIGHT // 2)),
                colour(self.pixel(left + WIDTH // 2, top + FILM_HEIGHT + WIDTH // 2)), letters)


class CameraSheetTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name, text in (("au-transmitter", TRANSMITTER), ("face-player", PLAYER)):
            program = self.folder / name
            program.write_text(text)
            program.chmod(0o755)
        self.film = self.folder / "film.mp4"
        subprocess.run(["ffmpeg", "-v", "error", "-f", "lavfi", "-i",
                        "color=yellow:s=640x360:r=24:d=1", "-f", "lavfi", "-i",
                        "color=lime:s=640x360:r=24:d=1", "-filter_complex", "concat", self.film],
                       check=True)

    def run_script(self, *arguments):
        return subprocess.run([sys.executable, SCRIPT, "--bin", self.folder, *map(str, arguments)],
                              capture_output=True, text=True, timeout=PATIENCE, cwd=self.folder,
                              check=False)

    def sheet(self, *arguments):
        out = self.folder / "sheet.png"
        done = self.run_script(self.film, "--out", out, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return Sheet(out)

    def test_each_cell_has_film_and_drawn_face_of_one_moment(self):
        sheet = self.sheet("--columns", 3)
        self.assertEqual((sheet.width, sheet.height), (3 * CELL[0] - PADDING, 2 * CELL[1] - PADDING))
        cells = [sheet.cell(k % 3, k // 3) for k in range(4)]
        self.assertEqual([cell[0] for cell in cells], ["yellow", "yellow", "green", "green"])
        self.assertEqual([cell[1] for cell in cells], ["red", "red", "blue", "blue"])

    def test_the_aus_of_the_moment_stand_under_it(self):
        sheet = self.sheet()
        neutral, smile = sheet.cell(0, 0)[2], sheet.cell(3, 0)[2]
        self.assertGreater(neutral[0], 20, "the time")
        self.assertGreater(smile[0], 2 * neutral[0], "time and three AUs; 26 is too weak")
        self.assertEqual([neutral[1], smile[1]], [0, 0], "the second line is for more than four")

    def test_what_is_drawn_of_a_picture_is_what_it_shows_when_it_ends(self):
        sheet = self.sheet("--from", 0.95, "--to", 0.96)
        self.assertEqual(sheet.cell(0, 0)[:2], ("yellow", "blue"))

    def test_only_the_part_that_is_asked_for(self):
        sheet = self.sheet("--from", 1.2, "--to", 1.8, "--every", 0.2, "--face", "marek")
        self.assertEqual(sheet.width, 3 * CELL[0] - PADDING)
        self.assertEqual(sheet.cell(0, 0)[:2], ("green", "blue"))
        self.assertIn("--face marek", (self.folder / "asked").read_text())

    def test_the_sheet_is_named_after_the_film(self):
        self.assertEqual(self.run_script(self.film).returncode, 0)
        self.assertTrue((self.folder / "film_sheet.png").exists())

    def test_what_fails_is_said_with_its_exit_code(self):
        done = self.run_script(self.folder / "bad.mp4")
        self.assertEqual((done.returncode, done.stderr.strip()),
                         (3, "au-transmitter: bad.mp4: no face is seen in it"))
        for wrong in (["--columns", 0], ["--columns", "x"], ["--every", 0], ["--from", -1],
                      ["--from", 2, "--to", 1], ["--from", "nan"]):
            done = self.run_script(self.film, *wrong)
            self.assertEqual(done.returncode, 2, f"{wrong}: {done.stderr}")
            self.assertNotIn("Traceback", done.stderr)
        done = self.run_script(self.film, "--from", 5)
        self.assertEqual(done.returncode, 1)
        self.assertIn("ends at 2 s", done.stderr)
        (self.folder / "face-player").unlink()
        done = self.run_script(self.film)
        self.assertEqual(done.returncode, 1)
        self.assertIn("face-player: No such file", done.stderr)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--script", type=pathlib.Path, required=True)
    options, rest = parser.parse_known_args()
    SCRIPT = options.script.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
