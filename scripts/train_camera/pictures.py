"""Renders random faces and has face-measures measure them: the examples that train.py learns from.

Each person is a variation of a shipped head (facegen's NUMBER); each film of a person is a stream of
random sets of Action Units, one picture each, the first ones neutral. Everything follows from the
seeds, so the same programs give the same examples.
"""

import csv
import os
import random
import shutil
import subprocess

# AUs that are learnt, with a side where a side can be seen.
SIDED = [1, 2, 4, 5, 6, 7, 9, 10, 12, 14, 15, 20, 45]
WHOLE = [17, 18, 22, 23, 24, 25, 26, 28]
# What else moves a face, so that it is not taken for one of those.
OTHERS = [11, 13, 16, 34]
LIPS = [[10], [12], [12], [14], [15], [16], [17], [18], [20], [22], [23], [24], [28], [13], [34],
        [15, 17], [10, 12], [20, 16], [9], [9, 10], [11]]
NEUTRAL_PICTURES = 6
SIZE = 320


def intensity(rng):
    return max(5, round(100 * rng.random() ** 1.3))


def random_face(rng):
    """{'12': percent, 'L12': percent, ...}"""
    aus = {}

    def show(number, percent=None):
        percent = percent or intensity(rng)
        if number in SIDED and rng.random() < 0.25:
            aus[f"L{number}"] = percent
            aus[f"R{number}"] = max(1, round(percent * rng.random()))
            if rng.random() < 0.5:
                aus[f"L{number}"], aus[f"R{number}"] = aus[f"R{number}"], aus[f"L{number}"]
        else:
            aus[str(number)] = percent

    for brow in (1, 2, 4):
        if rng.random() < 0.3:
            show(brow)
    lids = rng.choice([0, 0, 0, 5, 7, 45, 45])
    if lids:
        show(lids)
    if rng.random() < 0.3:
        show(6)
    for _ in range(rng.choice([0, 1, 1, 2])):
        for number in rng.choice(LIPS):
            show(number)
    if rng.random() < 0.5:
        show(25)
    if rng.random() < 0.35 and "24" not in aus and "28" not in aus:
        show(26)
    if rng.random() < 0.7:
        for one, other in ((51, 52), (53, 54), (55, 56)):
            aus[str(rng.choice([one, other]))] = round(60 * rng.random() ** 1.5)
    if rng.random() < 0.4:
        for one, other in ((61, 62), (63, 64)):
            aus[str(rng.choice([one, other]))] = round(80 * rng.random())
    return aus


def make_person(programs, data, folder, head, number):
    """A face folder of its own beside a link to the shipped one, whose muscles it may name."""
    os.makedirs(folder, exist_ok=True)
    for shipped in os.listdir(os.path.join(data, "faces")):
        place = os.path.join(folder, shipped)
        if os.path.isdir(os.path.join(data, "faces", shipped)) and not os.path.exists(place):
            shutil.copytree(os.path.join(data, "faces", shipped), place)
    face = os.path.join(folder, head)
    subprocess.run([os.path.join(programs, "facegen"), face, head, str(number)], check=True)
    return face


def light(rng):
    """How the film is seen: brightness, contrast, colour, sharpness, and a little narrower."""
    return (f"eq=brightness={rng.uniform(-0.12, 0.1):.3f}:contrast={rng.uniform(0.75, 1.2):.3f}"
            f":saturation={rng.uniform(0.4, 1.3):.3f}:gamma={rng.uniform(0.75, 1.3):.3f}"
            f",gblur=sigma={rng.uniform(0.01, 0.9):.3f}")


def measure_film(programs, models, film, size, filters, out):
    """Runs face-measures over a film; `size` is (width, height) behind the filters."""
    decode = subprocess.Popen(["ffmpeg", "-v", "error", "-i", film, "-vf", filters, "-f", "rawvideo",
                               "-pix_fmt", "rgb24", "-"], stdout=subprocess.PIPE)
    with open(out, "w", encoding="utf-8") as table:
        subprocess.run([os.path.join(programs, "face-measures"), models, *map(str, size)],
                       stdin=decode.stdout, stdout=table, check=True)
    decode.stdout.close()
    decode.wait()


def write_stream(path, faces):
    with open(path, "w", encoding="utf-8") as stream:
        stream.write("Beg_Stream\n")
        for face in faces:
            terms = ",".join(f"{au}:{percent}" for au, percent in face.items() if percent > 0)
            stream.write((terms or "0") + ";100\n")
        stream.write("End_Stream\n")


def examples_of(programs, data, models, work, head, number, pictures):
    """Rows (measures as a dict, set as a dict) of one person; kept in `work` for the next run."""
    name = f"{head}_{number}"
    rng = random.Random(f"{name} {pictures}")
    faces = [{} for _ in range(NEUTRAL_PICTURES)]
    faces += [random_face(rng) for _ in range(pictures - NEUTRAL_PICTURES)]
    table = os.path.join(work, name + ".csv")
    if not os.path.exists(table):
        person = make_person(programs, data, os.path.join(work, name), head, number)
        stream, film = (os.path.join(work, name + ending) for ending in (".txt", ".mp4"))
        write_stream(stream, faces)
        subprocess.run([os.path.join(programs, "face-player"), "play", stream, "--headless", "-q",
                        "--record", film, "--fps", "10", "--fast", "--size", f"{SIZE}x{SIZE}",
                        "--rules", "none", "--face", person], check=True)
        measure_film(programs, models, film, (SIZE, SIZE), light(rng), table + ".part")
        os.rename(table + ".part", table)
        shutil.rmtree(os.path.join(work, name))
    with open(table, encoding="utf-8") as rows:
        return [({key: float(value) for key, value in row.items()},
                 faces[int(row["picture"]) - 1]) for row in csv.DictReader(rows)
                if row["picture"] != "0"]
