#!/usr/bin/env python3
"""Repeats the measurement of the thesis' table 5.5 with the programs of this build.

    scripts/table_5_5.py [--bin FOLDER] [--cycles N]      default: build/release/bin, 5 cycles

For each of the six expressions: au-transmitter serves it alone, face-player receives it with the
table's settings (buffer 100, playout 30, threshold 40 %, speed 250 ms) in the classic protocol.
Prints the averages over the cycles: bytes and seconds at the sender, bytes and seconds at the
receiver, seconds of playback, and the share of one second of a 100 Mbit/s link that the bytes take
(payload only). The thesis' own last column is about a thousand times too large, because it counts a
megabyte as 1,024 bytes.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

from programs import Transmitter

EXPRESSIONS = ("surprise", "fear", "disgust", "anger", "happiness", "sadness")
LINK_BYTES_PER_SECOND = 100_000_000 / 8


def cycle(binaries: pathlib.Path, folder: pathlib.Path, name: str):
    """One transmission of one expression: the statistics of both sides."""
    sent, received = folder / "sent.json", folder / "received.json"
    stream = binaries / "data" / "streams" / f"{name}.txt"
    with Transmitter(binaries, "--stats", sent, stream) as server:
        subprocess.run(
            [binaries / "face-player", "--headless", server.address, "--protocol", "classic",
             "--buffer", "100", "--playout", "30", "--threshold", "40", "--speed", "250",
             "--stats", received],
            check=True)
    return json.loads(sent.read_text()), json.loads(received.read_text())


def main() -> int:
    root = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, default=root / "build/release/bin")
    parser.add_argument("--cycles", type=int, default=5)
    options = parser.parse_args()
    if not (options.bin / "face-player").exists():
        print(f"{options.bin} has no face-player: build first, or name the folder with --bin",
              file=sys.stderr)
        return 1

    print(f"{'':<10} {'bytes':>6} {'send':>10} {'bytes':>9} {'receive':>10} {'playback':>10} "
          f"{'share of a':>14}")
    print(f"{'':<10} {'sent':>6} {'s':>10} {'received':>9} {'s':>10} {'s':>10} "
          f"{'100 Mbit/s link':>15}")
    with tempfile.TemporaryDirectory() as folder:
        for name in EXPRESSIONS:
            runs = [cycle(options.bin, pathlib.Path(folder), name) for _ in range(options.cycles)]

            def mean(side, key):
                return sum(run[side][key] for run in runs) / len(runs)

            sent_bytes = mean(0, "bytes")
            share = 100 * sent_bytes / LINK_BYTES_PER_SECOND
            print(f"{name.capitalize():<10} {sent_bytes:>6.0f} "
                  f"{mean(0, 'send_seconds'):>10.6f} "
                  f"{mean(1, 'bytes_received'):>9.0f} {mean(1, 'receive_seconds'):>10.6f} "
                  f"{mean(1, 'playback_seconds'):>10.4f} {share:>13.6f} %")
    return 0


if __name__ == "__main__":
    sys.exit(main())
