#!/usr/bin/env python3
"""Plays a stream on a head, films it, and compares what a film is read as with what was played.

    closed_loop.py PROGRAMS WORK STREAM [--weights FILE] [--head HEAD]... [--neutral auto]
                   [--limit]

PROGRAMS: the folder of the built programs and their data, with the models. STREAM: a stream file, or a
table that au-transmitter reads. WORK keeps what was filmed. --weights: those of somebody who never saw the
head (train.py --without HEAD --out FILE). Prints r and mean error in percent of every AU that is played and of those
that are not, which are false alarms. --neutral auto straightens head and eyes of a table before it is played.
--limit prints beside each r the one of weights that know the very film: they are fitted on three of any four pieces
of 5 s and read the fourth. More than that is hardly to be had from the landmarks of the film.
"""

import argparse
import csv
import os
import pathlib
import shutil
import subprocess
import sys

import numpy

import fit
import pictures

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from stream_file import face_at, read_stream  # noqa: E402

FPS = 12
SIZE = 320
PIECE = 5        # seconds
PIECES = 4
SHRINK = 0.03    # of the weights that know the film
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


SIGNALS = {**{str(n): (n, None) for n in fit.SIDED + fit.WHOLE},
           **{f"{a}/{b}": (a, b) for a, b in TURNS}}


def signal(keyframes, times, name):
    """An AU in percent, or one of two opposites, less the other."""
    one, other = SIGNALS[name]
    values = shown(keyframes, times, one)
    if name == "26":
        values = numpy.maximum(values, shown(keyframes, times, 27))
    return values - shown(keyframes, times, other) if other else values


def agreement(truth, said):
    """r, or None when it is not played."""
    if truth.std() == 0:
        return None
    return numpy.corrcoef(truth, said)[0, 1] if said.std() > 0 else 0.0


def compare(played, read):
    """{name: (r or None, mean error)}."""
    times = numpy.arange(int(FPS * min(played[-1][0], read[-1][0])) - 1) / FPS
    rows = {}
    for name in SIGNALS:
        # What a picture shows is reached when it ends.
        truth, said = signal(played, times, name), signal(read, times + 1 / FPS, name)
        rows[name] = (agreement(truth, said), numpy.abs(truth - said).mean())
    return rows


def limits(programs, film, played):
    """{name: r or None} of weights that know the film."""
    table = film.with_suffix(".csv")
    pictures.measure_film(programs, programs / "data" / "models", film, (SIZE, SIZE), "null", table)
    with open(table, encoding="utf-8") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    neutral = fit.neutral_of(rows)
    left, right = (fit.features_of(numpy.array([fit.inputs_of(row, neutral, side) for row in rows]))
                   for side in (True, False))
    features = numpy.concatenate([left + right, left - right], axis=1)
    features = (features - features.mean(axis=0)) / (features.std(axis=0) + 1e-9)
    x = numpy.concatenate([numpy.ones((len(features), 1)), features], axis=1)
    times = numpy.array([row["picture"] for row in rows]) / FPS
    piece = (times // PIECE).astype(int) % PIECES
    shrink = SHRINK * numpy.diag([0.0] + [1.0] * features.shape[1])
    found = {}
    for name in SIGNALS:
        truth = signal(played, times, name)
        said = numpy.zeros(len(truth))
        for k in range(PIECES):
            known = x[piece != k]
            weights = numpy.linalg.solve(known.T @ known + len(known) * shrink,
                                         known.T @ truth[piece != k])
            said[piece == k] = x[piece == k] @ weights
        found[name] = agreement(truth, said)
    return found


def told(r):
    return "" if r is None else f"{r:.2f}"


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("stream", type=pathlib.Path)
    parser.add_argument("--weights", type=pathlib.Path)
    parser.add_argument("--head", action="append")
    parser.add_argument("--neutral")
    parser.add_argument("--limit", action="store_true")
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
        most = limits(options.programs, film, played) if options.limit else {}
        print(f"{stream.stem} on {head}\n| AU | r | mean error, % |{' at most |' if most else ''}\n"
              f"|---|---|---|{'---|' if most else ''}")
        for name, (r, error) in rows.items():
            print(f"| {name} | {told(r)} | {error:.1f} |" + (f" {told(most[name])} |" if most else ""))
        aus = [row for name, row in rows.items() if "/" not in name]
        print(f"mean r {numpy.mean([r for r, _ in aus if r is not None]):.2f}, "
              f"mean error {numpy.mean([error for _, error in aus]):.1f} %\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
