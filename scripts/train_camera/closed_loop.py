#!/usr/bin/env python3
"""Plays a stream on a head, films it, and compares what a film is read as with what was played.

    closed_loop.py PROGRAMS WORK STREAM [--weights FILE] [--head HEAD]... [--neutral auto]

PROGRAMS: the folder of the built programs and their data, with the models. STREAM: a stream file, or a
table that au-transmitter reads. WORK keeps what was filmed. --weights: those of somebody who never saw the
head (train.py --without HEAD --out FILE). Prints r and mean error in percent of every AU that is played and of those
that are not, which are false alarms. --neutral auto straightens head and eyes of a table before it is played.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys

import numpy

import fit

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from stream_file import face_at, read_stream  # noqa: E402

FPS = 12
SIZE = 320
TURNS = [(51, 52), (53, 54), (55, 56), (61, 62), (63, 64)]


def convert(programs, source, out, *options, **environment):
    subprocess.run([programs / "au-transmitter", "convert", *options, source, out], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   env={**os.environ, **environment})
    return read_stream(out)


def film_of(programs, work, stream, head):
    film = work / f"{stream.stem}_{head}.mp4"
    if not film.exists():
        part = work / f"part_{film.name}"
        subprocess.run([programs / "face-player", "play", stream, "--headless", "-q", "--fast",
                        "--record", part, "--fps", str(FPS), "--size", f"{SIZE}x{SIZE}", "--rules",
                        "none", "--face", head], check=True)
        part.rename(film)
    return film


def data_with(programs, work, weights):
    """The programs' data folder with other weights."""
    data = work / "data"
    if not data.exists():
        shutil.copytree(programs / "data", data)
    shutil.copyfile(weights, data / "camera" / "action_units.txt")
    return data


def shown(keyframes, times, number):
    """The intensity of an AU, the mean of both sides, in percent."""
    faces = [face_at(keyframes, seconds) for seconds in times]
    return numpy.array([numpy.mean([max(face.get(str(number), 0), face.get(side + str(number), 0))
                                    for side in "LR"]) for face in faces])


def compare(played, read):
    """Rows of (name, r or None when it is not played, mean error)."""
    times = numpy.arange(int(FPS * min(played[-1][0], read[-1][0])) - 1) / FPS
    # What a picture shows is reached when it ends.
    said_at = times + 1 / FPS
    signals = {str(n): (n, None) for n in fit.SIDED + fit.WHOLE}
    signals.update({f"{a}/{b}": (a, b) for a, b in TURNS})
    rows = []
    for name, (one, other) in signals.items():
        truth, said = shown(played, times, one), shown(read, said_at, one)
        if other:
            truth, said = truth - shown(played, times, other), said - shown(read, said_at, other)
        if name == "26":
            truth = numpy.maximum(truth, shown(played, times, 27))
        r = None
        if truth.std() > 0:
            r = numpy.corrcoef(truth, said)[0, 1] if said.std() > 0 else 0.0
        rows.append((name, r, numpy.abs(truth - said).mean()))
    return rows


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("stream", type=pathlib.Path)
    parser.add_argument("--weights", type=pathlib.Path)
    parser.add_argument("--head", action="append")
    parser.add_argument("--neutral")
    options = parser.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    weights = options.weights or options.programs / "data" / "camera" / "action_units.txt"
    data = data_with(options.programs, options.work, weights)
    neutral = ["--neutral", options.neutral] if options.neutral else []
    stream = options.work / ("_".join([options.stream.stem, *neutral[1:]]) + ".txt")
    played = convert(options.programs, options.stream, stream, *neutral)
    for head in options.head or ["default", "marek"]:
        film = film_of(options.programs, options.work, stream, head)
        read = convert(options.programs, film, options.work / "read.txt", AUCAST_DATA=str(data))
        rows = compare(played, read)
        print(f"{stream.stem} on {head}\n| AU | r | mean error, % |\n|---|---|---|")
        for name, r, error in rows:
            print(f"| {name} | {'' if r is None else f'{r:.2f}'} | {error:.1f} |")
        aus = [row for row in rows if "/" not in row[0]]
        print(f"mean r {numpy.mean([row[1] for row in aus if row[1] is not None]):.2f}, "
              f"mean error {numpy.mean([row[2] for row in aus]):.1f} %\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
