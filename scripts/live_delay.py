#!/usr/bin/env python3
"""Measures how long a live face takes from a line of its source to the drawn frame.

    scripts/live_delay.py [--bin FOLDER] [--rate HZ] [--seconds S] [--jitter MS] [--window]
                          [--default] [--check]

Writes rows of an OpenFace recording into a FIFO that au-transmitter serves, HZ (30) a second for S
(20) seconds, each up to --jitter (0) ms late, and lets face-player --live play them over loopback.
Every row is a face of its own (AU 1 and 2 count), so that the player's log (--log-level trace) says
by the clock that both programs share when which row was reached. Without --window the player is
headless: it computes 50 faces a keyframe and draws none. With it the player has a window, on a
display of its own (Xvfb) unless there is one, and the end is the moment at which the frame that
shows the row has been handed to the display; a software renderer may need far more than 17 ms for
one, which is said.
--default leaves --live out. Prints the delays, beside what was aimed at: one interval of the source
and one frame of a display with 60 Hz. --check exits 1 when the median is above that.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading
import time

from programs import Transmitter

DISPLAY_FRAME_MS = 1000 / 60
HEADER = "face_id,timestamp,success,AU01_r,AU02_r\n"
REACHED = re.compile(r"reached \{([^}]*)\} at ([0-9.]+)")
DRAWN = re.compile(r"drawn at ([0-9.]+)")


def face_of(row):
    """AU 1 and 2 in percent: every row its own for the first 10,000."""
    return 1 + row % 100, 1 + row // 100 % 100


def text_of(face):
    return ",".join(f"{au}" if percent == 100 else f"{au}:{percent}"
                    for au, percent in zip((1, 2), face))


def write_rows(fifo, options):
    """Returns when which face was written."""
    written = {}
    state = 12345
    with open(fifo, "wb", buffering=0) as pipe:
        pipe.write(HEADER.encode())
        begin = time.monotonic()
        for row in range(int(options.rate * options.seconds)):
            one, two = face_of(row)
            state = (state * 1103515245 + 12345) % 2**31
            late = options.jitter / 1000 * (state / 2**31)
            time.sleep(max(0.0, begin + row / options.rate + late - time.monotonic()))
            line = f"0,{row / options.rate:.3f},1,{one / 20:.3f},{two / 20:.3f}\n"
            written[text_of((one, two))] = time.monotonic()
            pipe.write(line.encode())
    return written


class Log:
    """Reads the player's log while it runs."""

    def __init__(self, stream, window):
        self.ends = {}
        self.frames = []
        self.other = []
        self.window = window
        self.thread = threading.Thread(target=self.read, args=(stream,))
        self.thread.start()

    def read(self, stream):
        waiting = []
        for line in stream:
            reached, drawn = REACHED.search(line), DRAWN.search(line)
            if reached and self.window:
                waiting.append(reached[1])
            elif reached:
                self.ends.setdefault(reached[1], float(reached[2]))
            elif drawn:
                self.frames.append(float(drawn[1]))
                for face in waiting:
                    self.ends.setdefault(face, float(drawn[1]))
                waiting.clear()
            else:
                self.other.append(line)


def play(options, folder):
    binaries = options.bin
    fifo, stats = folder / "face.fifo", folder / "stats.json"
    os.mkfifo(fifo)
    server = Transmitter(binaries, "--dead-band", "0", "--source-timeout", "1", fifo)
    command = [binaries / "face-player", "--log-level", "trace", "--stats", stats, server.address]
    command += [] if options.default else ["--live"]
    command += ["--no-config", "--exit-at-end"] if options.window else ["--headless"]
    if options.window and "DISPLAY" not in os.environ:
        command = ["xvfb-run", "-a", "-s", "-screen 0 800x600x24", *command[:1], "--size",
                   "640x480", *command[1:]]
    player = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    log = Log(player.stderr, options.window)
    written = write_rows(fifo, options)
    try:
        player.wait(60)
    finally:
        player.kill()
        server.stop()
    log.thread.join()
    if player.returncode != 0:
        sys.exit("face-player failed: " + "".join(log.other[-5:]))
    between = [1000 * (after - before) for before, after in zip(log.frames, log.frames[1:])]
    frame_ms = statistics.median(between) if between else None
    return written, log.ends, frame_ms, json.loads(stats.read_text(encoding="utf-8"))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=pathlib.Path("build/release/bin"))
    parser.add_argument("--rate", type=float, default=30)
    parser.add_argument("--seconds", type=float, default=20)
    parser.add_argument("--jitter", type=float, default=0)
    parser.add_argument("--window", action="store_true")
    parser.add_argument("--default", action="store_true")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.window and "DISPLAY" not in os.environ and not shutil.which("xvfb-run"):
        sys.exit("--window needs a display or xvfb-run")
    with tempfile.TemporaryDirectory() as folder:
        written, ends, frame_ms, stats = play(options, pathlib.Path(folder))

    # Rows are reached in their order; what looks like an earlier one is the face on its way to
    # neutral, after the last.
    rows = {face: row for row, face in enumerate(written)}
    last, delays = -1, []
    for face, end in ends.items():
        if rows.get(face, -1) > last:
            last = rows[face]
            delays.append(1000 * (end - written[face]))
    if not delays:
        sys.exit("no row was reached")
    delays.sort()
    interval = 1000 / options.rate
    aim = interval + DISPLAY_FRAME_MS
    median = statistics.median(delays)
    said = (f"{len(written)} rows at {options.rate:g} Hz, jitter {options.jitter:g} ms, "
            f"{'window' if options.window else 'headless'}"
            f"{', without --live' if options.default else ', --live'}\n"
            f"line to {'drawn frame' if options.window else 'face'}: {len(delays)} measured, "
            f"median {median:.1f} ms, 95 % within {delays[int(len(delays) * 0.95)]:.1f} ms, "
            f"longest {delays[-1]:.1f} ms\n"
            f"{f'this display draws a frame every {frame_ms:.1f} ms' + chr(10) if frame_ms else ''}"
            f"one interval and one display frame: {aim:.1f} ms; median / that: {median / aim:.2f}\n"
            f"the player's own account: median {stats['live_delay_p50_ms']} ms, "
            f"longest {stats['live_delay_max_ms']} ms, target {stats['live_delay_target_ms']} ms, "
            f"{stats['stalls']} stalls, {stats['keyframes_dropped']} dropped\n")
    sys.stdout.write(said)
    return 1 if options.check and median > aim else 0


if __name__ == "__main__":
    sys.exit(main())
