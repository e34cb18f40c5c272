"""Follows what scripts/facegen/people/README.md says about a person of one's own, to the letter.

    person_readme_test.py --bin FOLDER

In a copy of the folders that the lines name; then the person has to look at the viewer.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
README = ROOT / "scripts/facegen/people/README.md"
PNG = b"\x89PNG"


def told():
    """The file of the person, and the commands."""
    chapter = README.read_text().split("## A person of one's own\n")[1].split("\n## ")[0]
    lines = [line[4:] for line in chapter.splitlines() if line.startswith("    ") or not line]
    begin = lines.index("# anna.toml")
    end = lines.index("", begin)
    commands = [line for line in lines[end:] if line]
    return "\n".join(lines[begin:end]) + "\n", "\n".join(commands)


class PersonOfOnesOwn(unittest.TestCase):
    def test_the_lines_make_somebody_who_looks_at_the_viewer(self):
        person, commands = told()
        self.assertIn("facegen", commands)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "anna.toml").write_text(person)
            (folder / "build/release").mkdir(parents=True)
            (folder / "build/release/bin").symlink_to(OPTIONS.bin)
            (folder / "data/faces").mkdir(parents=True)
            for face in (ROOT / "data/faces").iterdir():
                (folder / "data/faces" / face.name).symlink_to(face)
            self.run_in(folder, ["bash", "-eu", "-c", commands])
            self.assertEqual((folder / "anna.png").read_bytes()[:4], PNG)
            # A path of its own takes the place of the shipped face's.
            said = self.run_in(folder, [OPTIONS.bin / "test_default_face",
                                        "--gtest_filter=DefaultFaceMesh.LooksAtTheViewerNotPastHim"],
                               AUCAST_SHIPPED_FACE=str(folder / "data/faces/anna"))
            self.assertIn("[  PASSED  ] 1 test", said)

    def run_in(self, folder, command, **variables):
        done = subprocess.run(command, cwd=folder, env={**os.environ, **variables},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", type=lambda word: pathlib.Path(word).resolve(), required=True)
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
