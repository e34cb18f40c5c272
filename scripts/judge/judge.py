#!/usr/bin/env python3
"""Shows a face to recognisers that nobody here wrote: which emotion they see in the prototypes, and
whether landmarks move as the Action Units say.

    scripts/judge/run PROGRAMS MODELS OUT [--face FACE ...] [--camera CAMERA ...] [--against FIGURES]

PROGRAMS: the folder of the built face-player and face-measures. MODELS: data/models, which
scripts/install_models.sh fills. OUT: gets pictures/ (what is there is not drawn again: give another OUT
for another face of the same name), report.md and figures.csv. --face: default and marek, or folders of
others. --camera: front and three-quarter. --against: the figures.csv of another run; what fell by more
than twice its noise is listed, and the exit code is 1.
"""

import argparse
import concurrent.futures
import csv
import math
import os
import statistics
import subprocess
import sys
import tomllib

EMOTIONS = ["surprise", "fear", "disgust", "anger", "happiness", "sadness"]
STRENGTHS = [25, 50, 80, 100]  # percent
LETTERS = {"A": 10, "B": 25, "C": 50, "D": 80, "E": 100}
SIZE = 600
# The same picture seen a little differently: what changes then is the recogniser's own noise.
VARIANTS = ["null", "crop=0.97*iw:0.97*ih:0.01*iw:0.01*ih", "crop=0.93*iw:0.93*ih:0.03*iw:0.06*ih",
            "eq=brightness=0.06", "eq=brightness=-0.06", "rotate=0.03:c=gray", "rotate=-0.03:c=gray"]
# What an AU must move by FACS, and its direction; what stands together is added.
MOVES = {
    1: "+brow-inner-up", 2: "+brow-outer-up", 4: "-brow-inner-up", 5: "+aperture", 6: "+lower-lid-up",
    7: "-aperture", 9: "+nose-wing-up", 10: "+upper-lip-up", 11: "+nasolabial-up", 12: "+corner-up",
    13: "+corner-up", 14: "+mouth-width", 15: "-corner-up", 16: "-lower-lip-up", 17: "+lower-lip-up",
    18: "-mouth-width", 20: "+mouth-width", 22: "+lips-height", 23: "-upper-lip-height lower-lip-height",
    24: "-upper-lip-height lower-lip-height", 25: "+lip-gap", 26: "-chin-up", 27: "-chin-up",
    28: "-upper-lip-height lower-lip-height", 34: "+cheek-out", 43: "-aperture", 45: "-aperture",
}
LEAST_MOVE = 0.5  # percent of the distance of the eyes' outer corners; less is not seen


class Picture:
    """One still: `kind` is neutral, emotion or au, `name` what is shown of it, `strength` in percent."""

    def __init__(self, face, camera, kind, name, strength, aus):
        self.face, self.camera, self.kind, self.name = face, camera, kind, name
        self.strength, self.aus = strength, aus

    def file(self):
        return f"{self.kind}_{self.name}_{self.strength:03}.png"


def head_of(face):
    return os.path.basename(os.path.normpath(face))


def scaled(aus, strength):
    """'1,5B' at 50 percent is '1:50,5:12'."""
    terms = []
    for term in aus.split(","):
        number, percent = (term[:-1], LETTERS[term[-1]]) if term[-1] in LETTERS else (term, 100)
        terms.append(f"{number}:{max(1, percent * strength // 100)}")
    return ",".join(terms)


def pictures_of(face, camera, expressions):
    pictures = [Picture(face, camera, "neutral", "neutral", 0, "0")]
    for strength in STRENGTHS:
        pictures += [Picture(face, camera, "emotion", name, strength, scaled(expressions[name], strength))
                     for name in EMOTIONS]
        pictures += [Picture(face, camera, "au", f"{number:02}", strength, f"{number}:{strength}")
                     for number in MOVES]
    return sorted(pictures, key=Picture.file)


def draw(programs, folder, picture):
    path = os.path.join(folder, picture.file())
    if not os.path.exists(path):
        part = path + ".part.png"
        subprocess.run([os.path.join(programs, "face-player"), "pose", picture.aus, "--face", picture.face,
                        "--camera", picture.camera, "--size", f"{SIZE}x{SIZE}", "--png", part, "-q"],
                       check=True)
        os.rename(part, path)


def seen_by(command, folder, names, variant, twice=False):
    """The table that a recogniser, which reads raw pictures, writes of those of a folder whose names
    match, in their order. `twice`: one that follows a face sees each picture twice; its second row
    counts."""
    decode = subprocess.Popen(["ffmpeg", "-v", "error", "-framerate", "1", "-pattern_type", "glob", "-i",
                               os.path.join(folder, names), "-vf",
                               f"{variant},scale={SIZE}:{SIZE},fps={2 if twice else 1}", "-f", "rawvideo",
                               "-pix_fmt", "rgb24", "-"], stdout=subprocess.PIPE)
    table = subprocess.run(command, stdin=decode.stdout, stdout=subprocess.PIPE, text=True, check=True)
    decode.stdout.close()
    if decode.wait() != 0:
        sys.exit(f"judge: ffmpeg cannot read {folder}")
    rows = list(csv.DictReader(table.stdout.splitlines()))
    if twice:
        rows = [row for row in rows if int(row["picture"]) % 2 == 1]
    for row in rows:
        row["picture"] = int(row["picture"]) // (2 if twice else 1)
    return rows


def noise_of(values):
    return statistics.stdev(values) if len(values) > 1 else 0.0


def emotion_figures(pictures, tables):
    """What each network makes of neutral and of the emotions. `tables`: one of each variant."""
    by_place = {}
    for table in tables:
        for row in table:
            by_place.setdefault((row["picture"], row["network"]), []).append(row)
    figures = []
    for (place, network), rows in sorted(by_place.items()):
        picture = pictures[place]
        sure = {name: statistics.mean(float(row[name]) for row in rows)
                for name in EMOTIONS + ["neutral"]}
        figures.append({"judge": network, "head": head_of(picture.face), "camera": picture.camera,
                        "kind": picture.kind, "name": picture.name, "strength": picture.strength,
                        "value": sure[picture.name],
                        "noise": noise_of([float(row[picture.name]) for row in rows]),
                        "seen": max(sure, key=sure.get)})
    return figures


def measured(row, what):
    """A sum of measures, in percent of the distance of the eyes' outer corners; both sides' mean."""
    total = 0.0
    for name in what.split():
        sides = [float(row[key]) for key in (name, "left-" + name, "right-" + name) if key in row]
        total += 100 * statistics.mean(sides)
    return total


def au_figures(pictures, tables):
    by_place = [{row["picture"]: row for row in table} for table in tables]
    places = {picture.file(): place for place, picture in enumerate(pictures)}
    rest = places[Picture(None, None, "neutral", "neutral", 0, None).file()]
    figures = []
    for place, picture in enumerate(pictures):
        if picture.kind != "au":
            continue
        sign, what = MOVES[int(picture.name)][0], MOVES[int(picture.name)][1:]
        moved = [(1 if sign == "+" else -1) * (measured(table[place], what) - measured(table[rest], what))
                 for table in by_place if place in table and rest in table]
        figures.append({"judge": "landmarks", "head": head_of(picture.face), "camera": picture.camera,
                        "kind": "au", "name": picture.name, "strength": picture.strength,
                        "value": statistics.mean(moved) if moved else math.nan,
                        "noise": noise_of(moved), "seen": f"{len(moved)} of {len(tables)}"})
    return figures


def correlation(xs, ys):
    if len(set(ys)) < 2 or any(math.isnan(y) for y in ys):
        return math.nan
    return statistics.correlation(xs, ys)


def verdict(values, noise):
    """Of what an AU moves at STRENGTHS."""
    last = values[-1]
    if any(math.isnan(value) for value in values):
        return "face not found"
    if last < -max(LEAST_MOVE, 2 * noise):
        return "wrong way"
    if last < max(LEAST_MOVE, 2 * noise):
        return "not seen"
    steps = zip([0.0, *values], values)
    return "grows" if all(after > before - max(0.15, noise) for before, after in steps) else "seen"


def groups_of(figures, *keys):
    groups = {}
    for figure in figures:
        groups.setdefault(tuple(figure[key] for key in keys), []).append(figure)
    return groups


def write_report(path, figures):
    emotions = [figure for figure in figures if figure["kind"] in ("emotion", "neutral")]
    lines = ["# What recognisers see", "", "How sure a network is of what was meant, mean of "
             f"{len(VARIANTS)} views ± their standard deviation; in brackets what it sees instead.", ""]
    for (judge,), seen in groups_of(emotions, "judge").items():
        columns = [f"{strength} %" for strength in STRENGTHS]
        lines += [f"## {judge}", "", "| head, camera | | " + " | ".join(columns) + " |",
                  "|---|---|" + "---|" * len(columns)]
        right = total = 0
        for (head, camera, name), row in groups_of(seen, "head", "camera", "name").items():
            cells = []
            for figure in sorted(row, key=lambda one: one["strength"]):
                instead = "" if figure["seen"] == name else f" ({figure['seen']})"
                cells.append(f"{figure['value']:.2f} ± {figure['noise']:.2f}{instead}")
                if figure["kind"] == "emotion":
                    right, total = right + (not instead), total + 1
            cells += [""] * (len(columns) - len(cells))
            lines.append(f"| {head}, {camera} | {name} | " + " | ".join(cells) + " |")
        lines += ["", f"Seen as meant: {right} of {total}.", ""]
    lines += ["## Landmarks", "", "How far each AU moves what it must, in percent of the distance of the eyes' outer "
              "corners. r: of strength and movement.", "",
              "| head, camera | AU | measure | " + " | ".join(f"{s} %" for s in STRENGTHS) +
              " | noise | r | |", "|---|---|---|" + "---|" * (len(STRENGTHS) + 3)]
    counts = {}
    moved = [figure for figure in figures if figure["kind"] == "au"]
    for (head, camera, name), row in groups_of(moved, "head", "camera", "name").items():
        row = sorted(row, key=lambda one: one["strength"])
        values = [figure["value"] for figure in row]
        noise = row[-1]["noise"]
        word = verdict(values, noise)
        counts.setdefault((head, camera), []).append(word)
        r = correlation([0.0, *STRENGTHS], [0.0, *values])
        lines.append(f"| {head}, {camera} | {int(name)} | {MOVES[int(name)]} | " +
                     " | ".join(f"{value:.1f}" for value in values) + f" | {noise:.1f} | {r:.2f} | {word} |")
    lines.append("")
    for (head, camera), words in counts.items():
        lines.append(f"{head}, {camera}: {words.count('grows')} of {len(words)} AUs grow with their strength, "
                     f"{words.count('seen')} more are seen.")
    with open(path, "w", encoding="utf-8") as report:
        report.write("\n".join(lines) + "\n")


KEYS = ["judge", "head", "camera", "kind", "name", "strength"]


def write_figures(path, figures):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, KEYS + ["value", "noise", "seen"])
        writer.writeheader()
        for figure in figures:
            writer.writerow(figure | {"value": f"{figure['value']:.4f}", "noise": f"{figure['noise']:.4f}"})


def fallen(figures, path):
    """What fell by more than twice its noise against the figures of another run."""
    with open(path, encoding="utf-8") as file:
        before = {tuple(row[key] for key in KEYS): row for row in csv.DictReader(file)}
    found = []
    for figure in figures:
        old = before.get(tuple(str(figure[key]) for key in KEYS))
        if not old:
            continue
        # The views are few: noise below this is luck.
        least = LEAST_MOVE / 2 if figure["kind"] == "au" else 0.02
        noise = max(figure["noise"], float(old["noise"]), least)
        if not figure["value"] >= float(old["value"]) - 2 * noise:
            found.append(" ".join(str(figure[key]) for key in KEYS) +
                         f": {figure['value']:.2f}, {float(old['value']):.2f} before, noise {noise:.2f}")
    return found


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("programs")
    parser.add_argument("models")
    parser.add_argument("out")
    parser.add_argument("--face", action="append")
    parser.add_argument("--camera", action="append")
    parser.add_argument("--against")
    options = parser.parse_args()
    with open(os.path.join(options.programs, "data", "expressions.toml"), "rb") as file:
        expressions = {one["name"]: one.get("aus") for one in tomllib.load(file)["expression"]}
    emotions = ["node", os.path.join(os.path.dirname(os.path.abspath(__file__)), "emotions.mjs"), str(SIZE), str(SIZE)]
    landmarks = [os.path.join(options.programs, "face-measures"), options.models, str(SIZE), str(SIZE)]
    figures = []
    for face in options.face or ["default", "marek"]:
        for camera in options.camera or ["front", "three-quarter"]:
            folder = os.path.join(options.out, "pictures", f"{head_of(face)}_{camera}")
            os.makedirs(folder, exist_ok=True)
            pictures = pictures_of(face, camera, expressions)
            with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
                list(pool.map(lambda one, folder=folder: draw(options.programs, folder, one), pictures))
            print(f"{head_of(face)}, {camera}: {len(pictures)} pictures", file=sys.stderr)
            felt = [picture for picture in pictures if picture.kind != "au"]
            figures += emotion_figures(felt, [seen_by(emotions, folder, "[en]*_???.png", variant)
                                              for variant in VARIANTS])
            figures += au_figures(pictures, [seen_by(landmarks, folder, "*_???.png", variant, twice=True)
                                             for variant in VARIANTS])
    write_report(os.path.join(options.out, "report.md"), figures)
    write_figures(os.path.join(options.out, "figures.csv"), figures)
    print(os.path.join(options.out, "report.md"))
    if options.against:
        worse = fallen(figures, options.against)
        print("\n".join(worse) or "Nothing fell by more than twice its noise.")
        sys.exit(1 if worse else 0)


if __name__ == "__main__":
    main()
