"""Reads stream files, and writes those that are made by script."""

import re
import sys


def read_stream(path):
    """[(seconds, {'L12': percent, ...})]: when each set of a stream file is reached. Intensities are
    those in percent, as au-transmitter writes them; one without is 100."""
    keyframes, at = [], 0.0
    for line in path.read_text(encoding="utf-8").splitlines():
        match = re.fullmatch(r"([LR0-9:.,+]+);(\d+)", line.split("#")[0].strip())
        if match is None:
            continue
        at += int(match[2]) / 1000
        terms = [term.partition(":") for term in re.split("[,+]", match[1]) if term != "0"]
        keyframes.append((at, {name: float(percent or 100) for name, _, percent in terms}))
    return keyframes


def with_sides_of(face, other):
    """The same face; what `other` tells for each side is told for each side."""
    told = {}
    for name, percent in face.items():
        sides = {side + name for side in "LR"}
        told.update(dict.fromkeys(sides if sides & other.keys() else {name}, percent))
    return told


def face_at(keyframes, seconds):
    """The AUs on the way from one keyframe to the next, in percent."""
    before, shown = 0.0, {}
    for at, aus in keyframes:
        if at >= seconds:
            way = (seconds - before) / (at - before) if at > before else 1
            shown, aus = with_sides_of(shown, aus), with_sides_of(aus, shown)
            return {name: (1 - way) * shown.get(name, 0) + way * aus.get(name, 0)
                    for name in shown.keys() | aus.keys()}
        before, shown = at, aus
    return shown


def write_or_check(text, check):
    """Prints a stream file, or compares it with the file `check` if that is a name; an exit code."""
    if check is None:
        sys.stdout.write(text)
        return 0
    with open(check, encoding="ascii", newline="") as file:
        if file.read() == text:
            return 0
    print(f"{check} is not what {sys.argv[0]} writes", file=sys.stderr)
    return 1
