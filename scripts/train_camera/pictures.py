"""Renders random faces and has face-measures measure them: the examples that train.py learns from.

Each person is a variation of a shipped head (facegen's NUMBER) that does each Action Unit in a way of
their own; each film of a person is a stream of random sets of AUs, one picture each, the first ones
neutral. Everything follows from the seeds, so the same programs give the same examples.
"""

import csv
import math
import os
import random
import re
import shutil
import subprocess

# AUs that are learnt, with a side where a side can be seen.
SIDED = [1, 2, 4, 5, 6, 7, 9, 10, 12, 14, 15, 20, 45]
WHOLE = [17, 18, 22, 23, 24, 25, 26, 28]
# What else moves a face, so that it is not taken for one of those.
OTHERS = [11, 13, 16, 34]
LIPS = [[10], [12], [12], [14], [15], [16], [17], [18], [20], [22], [23], [24], [28], [13], [34],
        [15, 17], [10, 12], [20, 16], [9], [9, 10], [11]]
# How far people differ: muscles by this in an AU, and how strong the AU is in all.
MUSCLE_SPREAD = 0.2
STRENGTH = {12: (0.8, 1.9), 45: (1, 1)}  # shipped heads smile less broadly than people
STRENGTH_OTHERWISE = (0.75, 1.3)
# What some people do more than the shipped heads, up to: a smile and parted lips bare the upper teeth
# without 10, and cheeks and smile draw the brows down without 4.
MORE = {12: {"levator_labii": 0.5, "nasalis": 0.5, "depressor_supercilii": 0.25},
        25: {"levator_labii": 1.2, "depressor_labii": 0.8, "jaw": 0.3},
        6: {"depressor_supercilii": 0.4, "procerus": 0.15},
        64: {"lid_close": 0.3}}
HEAD = 51  # the first AU of head and eyes, which turn alike on everybody
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

    smiles = rng.random() < 0.3
    for brow in (1, 2, 4):
        if rng.random() < (0.1 if smiles else 0.3):
            show(brow)
    lids = rng.choice([0, 0, 0, 5, 7, 45, 45])
    if lids:
        show(lids)
    if rng.random() < (0.6 if smiles else 0.3):
        show(6)
    if smiles:
        show(12, rng.randint(25, 100))
    for _ in range(rng.choice([0, 0, 0, 1] if smiles else [0, 1, 1, 2])):
        for number in rng.choice(LIPS):
            show(number)
    if rng.random() < (0.7 if smiles else 0.5):
        show(25)
    if rng.random() < (0.25 if smiles else 0.35) and "24" not in aus and "28" not in aus:
        show(26)
    if rng.random() < 0.7:
        for one, other in ((51, 52), (53, 54), (55, 56)):
            aus[str(rng.choice([one, other]))] = round(60 * rng.random() ** 1.5)
    if rng.random() < 0.4:
        for one, other in ((61, 62), (63, 64)):
            aus[str(rng.choice([one, other]))] = round(80 * rng.random())
    return aus


def most_of(name):
    """What a muscle or another channel may be at most."""
    if name == "jaw":
        return 4
    return 1 if name.startswith(("lid_", "crease_")) else 2


def moved(drive):
    """How much an AU moves: all but the lines that it draws."""
    return sum(value for name, value in drive.items()
               if not name.startswith(("crease_", "glabella_")))


def varied_drives(text, rng):
    """What each AU does, in a way of somebody's own, and how much more it moves: {number: factor}.
    `text`: that of aus.toml."""
    number, strengths, lines = 0, {}, []

    def vary(match):
        shipped = {name: float(value) for name, value in re.findall(r"(\w+) = ([0-9.]+)", match[1])}
        strength = rng.uniform(*STRENGTH.get(number, STRENGTH_OTHERWISE))
        drive = {name: value * strength * math.exp(rng.gauss(0, MUSCLE_SPREAD))
                 for name, value in shipped.items()} if number < HEAD else dict(shipped)
        for name, most in MORE.get(number, {}).items():
            drive[name] = drive.get(name, 0) + most * rng.random()
        drive = {name: min(value, most_of(name)) for name, value in drive.items()}
        if number < HEAD:
            strengths[number] = moved(drive) / moved(shipped)
        return "drive = { " + ", ".join(f"{name} = {value:.3f}" for name, value in drive.items()) + " }"

    for line in text.splitlines(keepends=True):
        if line.startswith("number = "):
            number = int(line.split("=")[1])
        lines.append(re.sub(r"drive = \{ (.*) \}", vary, line))
    return "".join(lines), strengths


def drives_of(data, head, number):
    """aus.toml of a person, and how much more they do in each AU. 0 is the shipped head."""
    with open(os.path.join(data, "faces", "default", "aus.toml"), encoding="utf-8") as file:
        text = file.read()
    return varied_drives(text, random.Random(f"{head} {number}")) if number else (text, {})


def as_shipped(face, strengths):
    """The set that makes a shipped head look as somebody does who shows `face`."""
    return {au: percent * strengths.get(int(au.strip("LR")), 1) for au, percent in face.items()}


def make_person(programs, data, folder, head, number):
    """A face folder of its own beside copies of the shipped ones, whose muscles it may name."""
    os.makedirs(folder, exist_ok=True)
    for shipped in os.listdir(os.path.join(data, "faces")):
        place = os.path.join(folder, shipped)
        if os.path.isdir(os.path.join(data, "faces", shipped)) and not os.path.exists(place):
            shutil.copytree(os.path.join(data, "faces", shipped), place)
    with open(os.path.join(folder, "default", "aus.toml"), "w", encoding="utf-8") as file:
        file.write(drives_of(data, head, number)[0])
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
    """Rows (measures as a dict, set as a dict, as_shipped()) of one person; kept in `work` for the next
    run."""
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
    strengths = drives_of(data, head, number)[1]
    faces = [as_shipped(face, strengths) for face in faces]
    with open(table, encoding="utf-8") as rows:
        return [({key: float(value) for key, value in row.items()},
                 faces[int(row["picture"]) - 1]) for row in csv.DictReader(rows)
                if row["picture"] != "0"]
