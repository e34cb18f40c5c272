#!/usr/bin/env python3
"""Compares the voice that face-player hears with the sound file that au-transmitter serves.

    scripts/voice_check.py [--bin FOLDER] [--check] [STREAM [OPTION...]]

Serves STREAM (data/streams/lecture.txt), which has a sound file of its name beside it, with the
given options of au-transmitter over loopback; face-player writes what it hears with --sound. Prints
how far one lags behind the other (the sound of a recording begins with its first row, a keyframe
late), how well their envelopes agree (correlation, 10 ms), how many samples each has, and how many
of the packets sent were played. The last packet is filled up: of a sound that is no multiple of 60
ms up to as much more silence is heard, as it is of one that ends before the face. --check exits 1
unless the lag is 0.0 ms, the correlation 0.95 or more, the numbers of samples are equal (but
for that filling) and every packet is played. Needs ffmpeg, which reads the sound file.
"""

import argparse
import array
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from programs import Transmitter

RATE = 48000
LAG_MOST = RATE // 20
STEP = RATE // 100


def samples_of(path):
    process = subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-ac", "1", "-ar", str(RATE),
                              "-f", "s16le", "-"], check=True, stdout=subprocess.PIPE)
    return array.array("h", process.stdout)


def correlation(one, other):
    count = min(len(one), len(other))
    one, other = one[:count], other[:count]
    mean_one, mean_other = sum(one) / count, sum(other) / count
    product = sum((a - mean_one) * (b - mean_other) for a, b in zip(one, other))
    power = sum((a - mean_one)**2 for a in one) * sum((b - mean_other)**2 for b in other)
    return product / math.sqrt(power) if power > 0 else 0.0


def lag_of(source, heard):
    """In samples: where two seconds of the source, at its loudest, are found in what is heard."""
    length = 2 * RATE
    begin = max(range(LAG_MOST, max(len(source) - length - LAG_MOST, LAG_MOST + 1), RATE),
                key=lambda at: sum(abs(x) for x in source[at:at + length:16]))
    part = source[begin:begin + length]

    def agreement(lag, every):
        other = heard[begin + lag:begin + lag + length]
        return sum(a * b for a, b in zip(part[::every], other[::every]))

    rough = max(range(-LAG_MOST, LAG_MOST + 1, 4), key=lambda lag: agreement(lag, 7))
    return max(range(rough - 4, rough + 5), key=lambda lag: agreement(lag, 1))


def envelope(samples):
    return [math.sqrt(sum(x * x for x in samples[i:i + STEP:2]) / STEP)
            for i in range(0, len(samples) - STEP + 1, STEP)]


def sound_beside(stream):
    for ending in (".wav", ".flac", ".opus", ".ogg", ".mp3"):
        if stream.with_suffix(ending).exists():
            return stream.with_suffix(ending)
    sys.exit(f"there is no sound file beside {stream}")


def play(options, folder):
    """The statistics of server and player."""
    with Transmitter(options.bin, "--stats", folder / "server.json", options.stream,
                     *options.options) as server:
        subprocess.run([options.bin / "face-player", "--headless", server.address, "--sound",
                        folder / "heard.wav", "--stats", folder / "player.json"], check=True)
    return [json.loads((folder / name).read_text()) for name in ("server.json", "player.json")]


def packet_samples(options):
    at = options.index("--voice-frame") if "--voice-frame" in options else None
    return RATE * (60 if at is None else int(options[at + 1])) // 1000


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    root = pathlib.Path(__file__).resolve().parent.parent
    parser.add_argument("--bin", type=pathlib.Path, default=root / "build" / "release" / "bin")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("stream", nargs="?", type=pathlib.Path,
                        default=root / "data" / "streams" / "lecture.txt")
    parser.add_argument("options", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    source = samples_of(sound_beside(options.stream))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        server, player = play(options, folder)
        heard = samples_of(folder / "heard.wav")
    lag = lag_of(source, heard)
    agreement = correlation(envelope(source), envelope(heard[max(lag, 0):]))
    sent, played = server["voice_packets"], player["voice_packets"] - player["voice_late"]
    # A face that outlasts its voice goes on in silence.
    packet = packet_samples(options.options)
    whole = max(-(-len(source) // packet) * packet, round(player["media_seconds"] * RATE))
    print(f"lag {1000 * lag / RATE:.2f} ms ({lag} samples); envelopes correlate with {agreement:.3f}; "
          f"{len(source)} samples in the file, {len(heard)} heard; {played} of {sent} packets played")
    good = (abs(lag) * 1000 / RATE < 0.05 and agreement >= 0.95 and len(heard) == whole
            and sent == played)
    return 1 if options.check and not good else 0


if __name__ == "__main__":
    sys.exit(main())
