"""The blinks of data/streams/talk.txt are those of people: lids close fast and open slower."""
import pathlib
import re
import unittest

TALK = pathlib.Path(__file__).resolve().parents[2] / "data/streams/talk.txt"
SHUT = 96  # percent: a keyframe that lies on the way within 4 percent is left out of the stream


def closures():
    """When each keyframe is reached, in ms, and how far the lids are closed then, in percent."""
    now = 0
    for line in TALK.read_text().splitlines():
        keyframe = re.fullmatch(r"([^#]*);(\d+)", line)
        if not keyframe:
            continue
        now += int(keyframe[2])
        closed = re.search(r"(?:^|,)45(?::(\d+))?(?=,|$)", keyframe[1])
        yield now, int(closed[1] or 100) if closed else 0


def blinks():
    """For each blink how long lids close, stay shut and open, in ms."""
    opened, shut, last_shut = 0, None, None
    for now, closed in closures():
        if closed >= SHUT:
            shut = now if shut is None else shut
            last_shut = now
        elif closed == 0:
            if shut is not None:
                yield shut - opened, last_shut - shut, now - last_shut
            opened, shut = now, None


class Blinks(unittest.TestCase):
    def test_lids_close_in_100_to_150_ms_and_open_slower(self):
        found = list(blinks())
        self.assertGreater(len(found), 10)
        for closing, shut, opening in found:
            self.assertTrue(100 <= closing <= 150, f"closing takes {closing} ms")
            self.assertLessEqual(shut, 60)
            self.assertTrue(1.3 * closing <= opening <= 250, f"opening takes {opening} ms")


if __name__ == "__main__":
    unittest.main()
