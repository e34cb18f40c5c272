"""Fits what turns measures of a face into Action Units: ridge regressions, one for each AU.

A face is looked at twice, as its left side sees it and as its right side does: "own" is the side
that an AU is told for, "other" the other one. So left and right share their weights, and every
example counts twice.
"""

import collections

import numpy

SIDE = """brow-inner-up brow-middle-up brow-outer-up brow-inner-out aperture upper-lid-up lower-lid-up
corner-up corner-out corner-front nose-wing-up nose-wing-out cheek-up cheek-out cheek-front
nasolabial-up gaze-left gaze-up""".split()
MIDDLE = """brow-gap mouth-width lip-gap upper-lip-height lower-lip-height lips-height upper-lip-up
lower-lip-up chin-up chin-boss-up lips-front nose-tip-up mouth-left""".split()
# What no expression moves. The net bends it where a head nods; by the turn alone frowns would be nods.
STILL = [f"still-{name}-up" for name in """outer-eye inner-eye bridge-top bridge-high bridge-middle
bridge-low ridge tip tip-low tip-under septum nose-base temple-high temple ear jaw-hinge""".split()]
MIDDLE += STILL
TURN = ["turn-left", "turn-up", "tilt-left"]
# Towards the left on either side; turned round for the right one.
TOWARDS_LEFT = {"gaze-left", "mouth-left", "turn-left", "tilt-left"}
INPUTS = [f"own-{name}" for name in SIDE] + [f"other-{name}" for name in SIDE] + MIDDLE + TURN

ABOVE = ["own-brow-inner-up", "own-brow-outer-up", "own-aperture", "own-upper-lid-up",
         "own-lower-lid-up", "own-corner-up", "own-corner-out", "lip-gap", "mouth-width",
         "upper-lip-up", "lower-lip-up", "chin-up", "lips-height", "own-nose-wing-up"]
TIMES = [("lip-gap", "mouth-width"), ("lip-gap", "lower-lip-up"), ("lip-gap", "upper-lip-up"),
         ("lip-gap", "chin-boss-up"), ("lip-gap", "chin-up"), ("turn-left", "turn-left"),
         ("turn-up", "turn-up"), ("own-aperture", "own-aperture"), ("lip-gap", "lip-gap"),
         ("turn-left", "own-corner-out"), ("turn-left", "own-corner-up"),
         ("turn-up", "own-aperture"), ("turn-up", "own-brow-inner-up"),
         ("turn-up", "chin-up"), ("turn-up", "own-corner-up")]
FEATURES = ([(name,) for name in INPUTS] + [(name, "above") for name in ABOVE]
            + [(a, "times", b) for a, b in TIMES])

# What lies before or behind the eyes seems to move up or down when the head is raised or lowered, for
# landmarks are flatter than a face.
HEIGHTS = """brow-inner-up brow-middle-up brow-outer-up corner-up nose-wing-up cheek-up nasolabial-up
upper-lip-up lower-lip-up chin-up chin-boss-up nose-tip-up""".split()

# People differ in how much. What two standard deviations of it explain is not believed.
DOUBTED = 2.0
Seeming = collections.namedtuple("Seeming", "slope doubt_raised doubt_turned")

# How far a measure is off on a face that nobody has trained for: what it may not be trusted with.
DOUBT = {"aperture": 0.08, "gaze-left": 0.06, "gaze-up": 0.06, "turn-left": 0.05, "turn-up": 0.08,
         "tilt-left": 0.05, "corner-front": 0.06, "cheek-front": 0.06, "lips-front": 0.06}
DOUBT_OTHERWISE = 0.008
# An eye is shut when nothing is left of what it is open in the neutral face, be that much or little.
LEAST_APERTURE = 0.15
ACTIVE_COUNTS = 3.0
TURNED = (51, 53, 55)  # and the opposite
# How many times more than that they are trusted, most for the head's turn, which is seen alike on
# everybody; less where heads that nobody has trained for are read worse.
TRUST = {51: 8.0, 53: 16.0, 55: 8.0, 2: 1.0, 4: 1.0, 5: 4.0, 7: 1.0, 10: 0.25, 15: 1.0, 17: 0.5,
         23: 4.0, 26: 0.25, 45: 1.0}
TRUST_OTHERWISE = 2.0

# Not 14 and 24: on a head that nobody has trained for they are not seen.
SIDED = [1, 2, 4, 5, 6, 7, 9, 10, 12, 15, 20, 45]
WHOLE = [17, 18, 22, 23, 25, 26, 28]
TURNING = {51: 52, 55: 56, 61: 62}  # left, and the other way
SIGNED = {53: 54, 63: 64}           # up, and the other way

# Which measures tell an AU, beside the turn of the head. What only happens to go along with it on
# drawn heads is not among them: people who smile have brows that do not move and chins that stay up.
BROWS = "brow-inner-up brow-middle-up brow-outer-up brow-inner-out brow-gap".split()
LIDS = "aperture upper-lid-up lower-lid-up gaze-up".split()
EYES = LIDS + ["gaze-left"]
CHEEKS = """cheek-up cheek-out cheek-front nasolabial-up nose-wing-up nose-wing-out
nose-tip-up""".split()
# A mouth's outline and the heights of its lips are seen from the front too.
OUTLINE = "corner-up corner-out mouth-width".split()
CORNERS = OUTLINE + ["corner-front", "mouth-left"]
HEIGHTS_OF_LIPS = "lip-gap upper-lip-height lower-lip-height lips-height".split()
LIPS = HEIGHTS_OF_LIPS + ["upper-lip-up", "lower-lip-up", "lips-front"]
CHIN = ["chin-up", "chin-boss-up"]
MOUTH = CHEEKS + CORNERS + LIPS + CHIN
TOLD_BY = {
    **{number: BROWS + LIDS for number in (1, 2)},
    # A smile draws the brows down a little too.
    4: BROWS + EYES + CHEEKS + CORNERS + LIPS,
    **{number: BROWS + EYES + CHEEKS for number in (5, 45)},
    6: EYES + CHEEKS + CORNERS,
    7: EYES + ["brow-inner-up", "brow-outer-up", "cheek-up"],
    9: BROWS + CHEEKS + LIPS,
    **{number: MOUTH for number in (10, 15, 20, 28)},
    17: OUTLINE + LIPS + CHIN,
    **{number: OUTLINE + LIPS for number in (18, 22)},
    23: OUTLINE + HEIGHTS_OF_LIPS,
    12: CHEEKS + CORNERS + LIPS,
    # Where the chin is says nothing of lips that are shut.
    25: LIPS + ["corner-out", "mouth-width"] + [("lip-gap", "times", name) for name in CHIN],
    # Not the gap of the lips, which is wide in every smile that bares the teeth: a jaw that drops
    # takes chin and lower lip along.
    26: CHIN + ["lower-lip-up"],
    53: SIDE + MIDDLE,
    61: ["gaze-left"],
    63: EYES + BROWS,
}


def neutral_of(rows):
    """The median face of the given rows; `rows`: measures by name."""
    return {name: float(numpy.median([row[name] for row in rows])) for name in rows[0]}


def seeming_of(people):
    """{height: Seeming}, over all people and from one to another."""
    slopes = slopes_of(people)
    each = [slopes_of([examples]) for examples in people]
    spread = {name: DOUBTED * numpy.std([one[name] for one in each], axis=0) for name in HEIGHTS}
    return {name: Seeming(slopes[name][0], *spread[name]) for name in HEIGHTS}


def slopes_of(people):
    """{height: by how much it seems to move for each radian that the head is raised, and turned}."""
    numbers = sorted({int(au.strip("LR")) for examples in people for _, face, _ in examples
                      for au in face if int(au.strip("LR")) < 51})
    causes, heights = [], {name: [] for name in HEIGHTS}
    for examples in people:
        for row, face, neutral in examples:
            for left in (True, False):
                side, sign = ("left-", 1) if left else ("right-", -1)
                turned = sign * (row["turn-left"] - neutral["turn-left"])
                causes.append([row["turn-up"] - neutral["turn-up"], abs(turned), turned, 1,
                               shown(face, 63, left) - shown(face, 64, left)]
                              + [shown(face, number, left) for number in numbers])
                for name in HEIGHTS:
                    measure = side + name if name in SIDE else name
                    heights[name].append(row[measure] - neutral[measure])
    causes = numpy.array(causes)
    squares = causes.T @ causes + 1e-3 * numpy.eye(causes.shape[1])
    return {name: numpy.linalg.solve(squares, causes.T @ numpy.array(values))[:2]
            for name, values in heights.items()}


def levelled(row, neutral, seeming):
    """The measures without what only seems to move."""
    raised = row["turn-up"] - neutral["turn-up"]
    turned = row["turn-left"] - neutral["turn-left"]
    level = dict(row)
    for name, seems in seeming.items():
        doubt = seems.doubt_raised * abs(raised) + seems.doubt_turned * abs(turned)
        for measure in ("left-" + name, "right-" + name) if name in SIDE else (name,):
            change = row[measure] - neutral[measure] - seems.slope * raised
            level[measure] = neutral[measure] + change - min(max(change, -doubt), doubt)
    return level


def levelled_people(people, seeming):
    return [[(levelled(row, neutral, seeming), face, neutral) for row, face, neutral in examples]
            for examples in people]


def inputs_of(row, neutral, left):
    """What one side sees of a face, against the neutral face."""
    own, other = ("left-", "right-") if left else ("right-", "left-")
    sign = 1 if left else -1
    values = []
    for side in (own, other):
        for name in SIDE:
            value = row[side + name] - neutral[side + name]
            if name == "aperture":
                value /= max(neutral[side + name], LEAST_APERTURE)
            values.append(sign * value if name in TOWARDS_LEFT else value)
    for name in MIDDLE + TURN:
        value = row[name] - neutral[name]
        values.append(sign * value if name in TOWARDS_LEFT else value)
    return values


def features_of(inputs):
    place = {name: index for index, name in enumerate(INPUTS)}
    columns = []
    for feature in FEATURES:
        column = inputs[:, place[feature[0]]]
        if feature[1:] == ("above",):
            column = numpy.maximum(column, 0)
        elif len(feature) == 3:
            column = column * inputs[:, place[feature[2]]]
        columns.append(column)
    return numpy.stack(columns, axis=1)


def plain(name):
    return name.split("-", 1)[1] if name.startswith(("own-", "other-")) else name


def tells(feature, number):
    """Whether a feature may tell an AU; of head turns everything may, but STILL
    only of nods."""
    names = {plain(name) for name in feature[::2]}
    told = {*TOLD_BY.get(number, names - {*STILL}), *TURN}
    return feature in told or names <= told


def doubt_of(feature, scale):
    def doubt(name):
        return DOUBT.get(plain(name), DOUBT_OTHERWISE)
    if len(feature) == 3:
        return 0.5 * scale + doubt(feature[0]) * doubt(feature[2])
    return doubt(feature[0])


def shown(face, number, left):
    """What the set shows of an AU on one side, [0,1]."""
    sided = face.get(("L" if left else "R") + str(number), 0)
    return max(face.get(str(number), 0), sided) / 100


def targets_of(face, left):
    sign = 1 if left else -1
    sided = [shown(face, number, left) for number in SIDED]
    whole = [shown(face, number, left) for number in WHOLE]
    whole[WHOLE.index(26)] = max(whole[WHOLE.index(26)], shown(face, 27, left))
    # The jaw takes the lips along: FACS scores 25 with 26.
    turning = [sign * (shown(face, a, left) - shown(face, b, left)) for a, b in TURNING.items()]
    signed = [shown(face, a, left) - shown(face, b, left) for a, b in SIGNED.items()]
    return sided + whole + turning + signed


OUTPUTS = SIDED + WHOLE + list(TURNING) + list(SIGNED)


def table_of(people):
    """Features and targets of every picture from both sides; `people`: lists of (row, face, neutral)."""
    inputs, targets = [], []
    for examples in people:
        for row, face, neutral in examples:
            for left in (True, False):
                inputs.append(inputs_of(row, neutral, left))
                targets.append(targets_of(face, left))
    return features_of(numpy.array(inputs)), numpy.array(targets)


def fit(people):
    """Weights: a row for each output, a bias before one number for each feature."""
    features, targets = table_of(people)
    scale = features.std(axis=0)
    doubt = numpy.array([1e-3] + [doubt_of(f, s) for f, s in zip(FEATURES, scale)])
    x = numpy.concatenate([numpy.ones((len(features), 1)), features], axis=1)
    weights = numpy.zeros((len(OUTPUTS), x.shape[1]))
    for row, number, target in zip(weights, OUTPUTS, targets.T):
        used = numpy.array([True] + [tells(feature, number) for feature in FEATURES])
        trust = TRUST.get(number, TRUST_OTHERWISE)
        # An AU is absent from most pictures; those that show it count more. A head is always turned.
        active = 1.0 if number in TURNED else ACTIVE_COUNTS
        count = numpy.where(target != 0, active, 1.0)
        seen = x[:, used]
        squares = (seen * count[:, None]).T @ seen + numpy.diag((doubt[used] / trust) ** 2) * count.sum()
        row[used] = numpy.linalg.solve(squares, (seen * count[:, None]).T @ target)
    return weights


def thresholds_of(weights, people):
    """How much of each output is only noise: what makes the mean error of `people` least."""
    features, targets = table_of(people)
    raw = features @ weights[:, 1:].T + weights[:, :1].T
    best = []
    for k, number in enumerate(OUTPUTS):
        if number in TURNING or number in SIGNED:
            best.append(0.0)
            continue
        errors = [(numpy.abs(rise(raw[:, k], t) - targets[:, k]).mean(), t)
                  for t in numpy.arange(0, 0.11, 0.02)]
        best.append(min(errors)[1])
    return best


def rise(raw, threshold):
    return numpy.clip((raw - threshold) / (1 - threshold), 0, 1)


def write(path, weights, thresholds, seeming, neutral):
    kinds = {**{n: "sided" for n in SIDED}, **{n: "whole" for n in WHOLE},
             **{n: "turning" for n in TURNING}, **{n: "signed" for n in SIGNED}}
    with open(path, "w", encoding="utf-8") as out:
        out.write("# What Action Units are told by, from the measures of a face against the neutral\n"
                  "# face. Written by scripts/train_camera/train.py; README.md there describes it.\n")
        out.write("neutral-side " + " ".join(
            f"{(neutral['left-' + n] + neutral['right-' + n]) / 2 * (n not in TOWARDS_LEFT):.4f}"
            for n in SIDE) + "\n")
        out.write("neutral-middle " + " ".join(
            f"{neutral[n] * (n not in TOWARDS_LEFT):.4f}" for n in MIDDLE) + "\n")
        for line, field in (("raised", "slope"), ("raised-doubt", "doubt_raised"),
                            ("turned-doubt", "doubt_turned")):
            for part, names in (("-side", SIDE), ("-middle", MIDDLE)):
                values = [getattr(seeming[name], field) if name in seeming else 0 for name in names]
                out.write(" ".join([line + part, *(f"{value:.4f}" for value in values)]) + "\n")
        for feature in FEATURES:
            out.write("feature " + " ".join(feature) + "\n")
        for k, number in enumerate(OUTPUTS):
            out.write(f"au {number} {kinds[number]} {thresholds[k]:.2f} "
                      + " ".join(f"{w:.4g}" for w in weights[k]) + "\n")
