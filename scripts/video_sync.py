#!/usr/bin/env python3
"""Measures, in a recorded video's pictures and samples, whether face and sound stay together.

    scripts/video_sync.py [--bin FOLDER] [--minutes M] [--fps N] [--size WxH] [--video FILE] [--check]

Makes a stream whose mouth opens and closes every two seconds, and a sound file that hums in just
those moments; au-transmitter serves both, and face-player records them as an MP4 of M (10) minutes.
Then, for each moment, the middle of what is seen (how dark the mouth is, weighted by time) is
compared with the middle of what is heard. Prints the first, the last, the least and the most; above
0 the face is early. --check exits 1 beyond -15 to +45 ms. --video measures a video that was made so
before. Needs ffmpeg; a minute of video takes about a minute.
"""

import argparse
import array
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import wave

from programs import Transmitter

RATE = 16000
SOUND_RATE = 48000
PERIOD = 2.0   # seconds
MIDDLE = 1.6   # of the period: when the mouth is widest
HALF = 0.4     # the mouth opens, and closes, within this time
REACH = 0.6    # so far from the middle is looked
ALLOWED_MS = (-15, 45)


def write_talk(folder, count):
    with open(folder / "marks.txt", "w", encoding="ascii") as file:
        file.write("Beg_Stream\n" + "0;1200\n27;400\n0;400\n" * count + "End_Stream\n")
    hum = array.array("h", bytes(2 * int(PERIOD * RATE)))
    for i in range(int(2 * HALF * RATE)):
        loud = 0.5 - 0.5 * math.cos(math.pi * i / (HALF * RATE))
        at = int((MIDDLE - HALF) * RATE) + i
        if at < len(hum):
            hum[at] = int(12000 * loud * math.sin(2 * math.pi * 300 * i / RATE))
    with wave.open(str(folder / "marks.wav"), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(RATE)
        for _ in range(count):
            file.writeframes(hum.tobytes())


def record(options, folder):
    video = folder / "marks.mp4"
    with Transmitter(options.bin, folder / "marks.txt") as server:
        subprocess.run([options.bin / "face-player", "--headless", server.address, "--fps",
                        str(options.fps), "--size", options.size, "--record", video], check=True)
    return video


def decoded(video, *how):
    process = subprocess.run(["ffmpeg", "-v", "error", "-i", video, *how, "-"], check=True,
                             stdout=subprocess.PIPE)
    return process.stdout


def middle(values, begin, rate, base):
    """Of what is above the base, in seconds; nothing where there is too little."""
    above = [max(value - base, 0) for value in values]
    whole = sum(above)
    if whole == 0:
        return None
    return begin + sum(i * value for i, value in enumerate(above)) / whole / rate


def darkness(video, options):
    """Of the mouth's part of each picture."""
    width, height = 32, 32
    pictures = decoded(video, "-vf", f"scale={width}:{height}", "-pix_fmt", "gray", "-f", "rawvideo")
    size = width * height
    left, right, top, bottom = width * 3 // 8, width * 5 // 8, height * 9 // 16, height * 13 // 16
    dark = []
    for begin in range(0, len(pictures) - size + 1, size):
        rows = (pictures[begin + y * width + left:begin + y * width + right]
                for y in range(top, bottom))
        dark.append(-sum(sum(row) for row in rows))
    return dark


def shifts(video, options):
    """For each moment: how early the face is, in ms."""
    dark = darkness(video, options)
    sound = array.array("h", decoded(video, "-ac", "1", "-ar", str(SOUND_RATE), "-f", "s16le"))
    found = []
    for k in range(int(len(dark) / options.fps / PERIOD)):
        at = k * PERIOD + MIDDLE
        first = max(int((at - REACH) * options.fps), 0)
        seen = dark[first:int((at + REACH) * options.fps)]
        low, high = min(seen), max(seen)
        face = middle(seen, first / options.fps, options.fps, low + 0.3 * (high - low))
        first = int((at - REACH) * SOUND_RATE)
        heard = [abs(sample) for sample in sound[first:int((at + REACH) * SOUND_RATE):8]]
        voice = middle(heard, first / SOUND_RATE, SOUND_RATE / 8, 600) if heard else None
        if face is not None and voice is not None:
            found.append(1000 * (voice - face))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    root = pathlib.Path(__file__).resolve().parent.parent
    parser.add_argument("--bin", type=pathlib.Path, default=root / "build" / "release" / "bin")
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--fps", type=int, default=25)
    parser.add_argument("--size", default="64x64")
    parser.add_argument("--video", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        video = options.video
        if video is None:
            write_talk(folder, int(options.minutes * 60 / PERIOD))
            video = record(options, folder)
        found = shifts(video, options)
    if not found:
        sys.exit("nothing was found in the video")
    print(f"{len(found)} moments: the face is early by {found[0]:.1f} ms at first and "
          f"{found[-1]:.1f} ms at last, {min(found):.1f} to {max(found):.1f} ms in between")
    good = ALLOWED_MS[0] <= min(found) and max(found) <= ALLOWED_MS[1]
    return 1 if options.check and not good else 0


if __name__ == "__main__":
    sys.exit(main())
