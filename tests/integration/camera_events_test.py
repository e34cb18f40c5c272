"""scripts/camera_events on streams and marks of the test's own.

    camera_events_test.py --script FILE
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PATIENCE = 60.0  # seconds until a test gives up waiting
SCRIPT = pathlib.Path()
FAILS = """#!/bin/sh
echo "au-transmitter: no face is seen" >&2
exit 3
"""


def mark(kind, start, end, **more):
    return {"kind": kind, "start": start, "peak": (start + end) / 2, "end": end, **more}


class CameraEventsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.stream = self.folder / "film.txt"

    def run_script(self, marks, *options, film=None):
        path = self.folder / "marks.json"
        path.write_text(marks if isinstance(marks, str) else json.dumps({"film.mp4": marks}))
        return subprocess.run([sys.executable, SCRIPT, path, film or self.stream, "--bin",
                               self.folder, *options], capture_output=True, text=True,
                              timeout=PATIENCE, check=False)

    def write(self, *keyframes):
        """The first one is reached when the film's first picture ends."""
        self.stream.write_text("Beg_Stream\n0;40\n" + "".join(line + "\n" for line in keyframes)
                               + "End_Stream\n")

    def row(self, kind, marks, *options):
        done = self.run_script(marks, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = [line for line in done.stdout.splitlines() if line.startswith(f"| {kind} ")]
        return lines[0].strip("| ").split(" | ")[1:]

    def test_a_rise_at_a_mark_is_found_and_others_are_false(self):
        # Blinks at 1.0, 3.0 and 5.0 s of twelve; half a blink by 20 % is none.
        blink = ["0;800", "45:60;100", "0;100"]
        self.write("0;100", *blink, "0;1000", *blink, "0;1000", *blink, "0;1000", "45:20;100",
                   "0;100", "0;5660")
        self.assertEqual(self.row("blink", [mark("blink", 0.9, 1.1),
                                            mark("blink", 2.9, 3.1, unsure=True)]),
                         ["1 of 1", "1 of 1", "5.0 (1)"])
        self.assertEqual(self.row("blink", [mark("blink", 0.9, 1.1), mark("blink", 7.2, 7.3),
                                            mark("eyes_shut", 2.5, 5.5)]),
                         ["1 of 2", "0 of 0", "0.0 (0)"])

    def test_one_event_finds_one_mark(self):
        self.write("0;900", "45:60;100", "0;100", "0;2000")
        self.assertEqual(self.row("blink", [mark("blink", 0.8, 1.0), mark("blink", 1.1, 1.2)])[0],
                         "1 of 2")

    def test_an_event_finds_a_sure_mark_before_an_unsure_one(self):
        self.write("0;900", "45:60;100", "0;100", "0;2000")
        self.assertEqual(self.row("blink", [mark("blink", 0.9, 1.0, unsure=True),
                                            mark("blink", 0.8, 1.2), mark("blink", 0.95, 1.0)]),
                         ["1 of 2", "0 of 1", "0.0 (0)"])

    def test_no_peak_is_lost_between_two_looks(self):
        self.write("0;1003", "45:26;7", "0;7", "0;1000")
        self.assertEqual(self.row("blink", [mark("blink", 1, 1.02)])[0], "1 of 1")

    def test_what_shows_when_the_film_begins_is_an_event_and_what_stays_is_one(self):
        self.write("12:60;10", "12:65;1000", "12:50;1000", "12:70;1000")
        self.assertEqual(self.row("smile", [mark("smile", 0, 3)]), ["1 of 1", "0 of 0", "0.0 (0)"])
        self.assertEqual(self.row("smile", []), ["0 of 0", "0 of 0", f"{60 / 3.05:.1f} (1)"])

    def test_a_side_that_comes_and_goes_is_no_event(self):
        self.write("12:60;10", *["L12:57,R12:57;1000", "12:60;1000"] * 2)
        self.assertEqual(self.row("smile", [mark("smile", 0, 0.1)]),
                         ["1 of 1", "0 of 0", "0.0 (0)"])

    def test_the_greater_of_1_and_2_raises_the_brows_of_either_side_by_half(self):
        self.write("0;1000", "1:10,L2:60;200", "0;200", "0;1000", "L2:40;200", "0;200", "0;1000")
        self.assertEqual(self.row("brow_raise", [mark("brow_raise", 1, 1.4)]),
                         ["1 of 1", "0 of 0", "0.0 (0)"])

    def test_a_turn_is_found_in_the_direction_that_is_named_first(self):
        # 20 % of 35 degrees are 7, of 22 degrees 4.4.
        self.write("0;1000", "51:20,53:20;300", "51:20,53:20;2000", "52:10;300", "52:10;1000")
        to_the_left, back = mark("turn", 1, 1.3, direction="left (+up)"), mark("turn", 3.3, 3.6)
        self.assertEqual(self.row("turn", [to_the_left, {**back, "direction": "right"}]),
                         ["2 of 2", "0 of 0", "0.0 (0)"])
        self.assertEqual(self.row("turn", [to_the_left, {**back, "direction": "tilt right"}])[::2],
                         ["1 of 2", "0.0 (0)"])
        self.assertEqual(self.row("turn", [])[2].split()[1], "(2)")

    def test_the_list_has_each_mark_and_each_false_alarm(self):
        self.write("0;900", "45:60;100", "0;100", "12:60;1000", "12:60;1000")
        marks = [mark("blink", 0.9, 1.0), mark("turn", 1, 2, direction="up")]
        out = self.run_script(marks, "--list").stdout
        self.assertRegex(out, r"film.mp4 blink  0.90 to 1.00 s: 0\.\d+ to 1\.\d+ s")
        self.assertIn("film.mp4 turn up 1.00 to 2.00 s: not found", out)
        self.assertIn("film.mp4 smile  false: ", out)

    def test_what_is_wrong_is_said_with_its_exit_code(self):
        self.write("0;100")
        for marks in ("[", "[]", '{"film.mp4": [{"kind": "blink"}]}', '{"other.mp4": []}',
                      json.dumps({"film.mp4": [mark("turn", 0, 1)]}),
                      json.dumps({"film.mp4": [{**mark("blink", 1, 2), "peak": 3}]})):
            done = self.run_script(marks)
            self.assertEqual((done.returncode, done.stdout), (2, ""), marks)
            self.assertRegex(done.stderr, "^camera_events: .*\n$")
        done = self.run_script([], film=self.folder / "film.mp4")
        self.assertEqual(done.returncode, 1)
        self.assertIn("au-transmitter: No such file", done.stderr)
        program = self.folder / "au-transmitter"
        program.write_text(FAILS)
        program.chmod(0o755)
        done = self.run_script([], film=self.folder / "film.mp4")
        self.assertEqual((done.returncode, done.stderr), (3, "au-transmitter: no face is seen\n"))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--script", type=pathlib.Path, required=True)
    options, rest = parser.parse_known_args()
    SCRIPT = options.script.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
