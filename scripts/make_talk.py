#!/usr/bin/env python3
"""Writes a believable talk as a stream of timed keyframes.

usage: make_talk.py                the stream goes to stdout
       make_talk.py --check FILE   exit 1 if FILE is not what would be written

A talk is a list of phrases in syllables. Every movement is an event with onset, apex and offset on
one channel; a channel is the largest (AUs) or the sum (head and gaze, which have two directions) of
its events. Wherever an event begins, peaks or ends a keyframe is written, unless the ones around it
say the same.

  mouth    4 to 5 syllables a second: the vowel opens and shapes it, the consonant closes it
  brows    raised on stressed syllables, lowered in doubt
  blinks   about 17 a minute, 120 ms down and 200 ms up
  smiles   onset 400 ms, offset 600 ms, a little weaker on one side
  head     nods on stress, turns and tilts with the phrase
  gaze     leaves the listener in pauses and comes back before the next phrase
"""
import argparse
import random
import sys

from stream_file import write_or_check

GRID_MS = 40        # every moment is a multiple of this: a camera of 25 pictures a second
GAP_MS_MAX = 400    # longest keyframe
PERCENT_MIN = 3     # weaker is absent
TOLERANCE = 4       # percent: what nobody sees in a keyframe left out
SEED = 1978

# Phrases: the pause before, the mood, the syllables. A capital letter marks stress.
PHRASES = (
    (600, "smile", "gu-tE mor-ning E-vry-bo-dy"),
    (500, "open", "I want tu sho ju a fEIs"),
    (300, "open", "that kon-sIsts of no-thing but nAm-bers"),
    (700, "doubt", "ju mait bi-lIv that a pik-tshur iz bIg"),
    (400, "doubt", "and mu-ving pik-tshurs ar E-ven bIg-ger"),
    (500, "surprise", "but a smAIl iz on-li fOr nAm-bers"),
    (800, "smile", "wan siks twElv and for-tIn"),
    (600, "open", "e-vry nAm-ber iz wan mUv-ment of the fEIs"),
    (300, "open", "the brAU the lId the lIp the tshOU"),
    (500, "open", "wi send on-li thIs O-ver the wAI-er"),
    (300, "doubt", "a fju bAits at a tAim"),
    (700, "surprise", "and far a-wEI a nA-ther fEIs wEIks Up"),
    (500, "smile", "it smAIls wen I smAIl"),
    (400, "sad", "and iz sEd wen I am sEd"),
    (800, "surprise", "O thEr it iz a-gEn"),
    (500, "open", "thEr ar no pik-tshurs in be-twIn"),
    (300, "open", "the mAs-sels mUv the skIn and thAt iz Ol"),
    (700, "smile", "thEnk ju for luk-ing"),
    (400, "smile", "and pliz smAIl bAk"),
)

# What a vowel does to the mouth, in percent.
VOWELS = {
    "a": {25: 85, 26: 60},
    "e": {25: 70, 26: 35, 20: 30},
    "i": {25: 55, 26: 15, 20: 50},
    "o": {25: 65, 26: 45, 22: 50},
    "u": {25: 40, 26: 15, 18: 60, 22: 30},
    "y": {25: 50, 26: 15, 20: 35},
}
# What a consonant before the vowel does.
CONSONANTS = {
    "b": {23: 35, 17: 25}, "p": {23: 45, 17: 30}, "m": {23: 35, 17: 20},
    "f": {16: 30, 25: 15}, "v": {16: 25, 25: 15}, "w": {18: 55, 22: 25},
    "t": {25: 25, 16: 10}, "s": {25: 20, 20: 25}, "l": {25: 35}, "r": {25: 25, 22: 25},
}

# Channels with two directions: positive is the first AU.
DIRECTIONS = {"turn": (51, 52), "pitch": (53, 54), "tilt": (55, 56), "look": (61, 62),
              "lift": (63, 64)}


class Talk:
    def __init__(self):
        self.generator = random.Random(SEED)
        self.events = []    # (channel, [(ms, percent), ...])
        self.now = 0

    def between(self, low, high):
        """Only random() itself is used: it is the same in every version of Python."""
        return low + (high - low) * self.generator.random()

    def chance(self, probability):
        return self.generator.random() < probability

    def add(self, channel, start, onset, apex, offset, percent):
        """A movement that rises for `onset` ms, stays for `apex` and falls for `offset`."""
        moments = [start, start + onset, start + onset + apex, start + onset + apex + offset]
        levels = [0, percent, percent, 0]
        points = []
        for moment, level in zip(moments, levels):
            on_grid = max(0, round(moment / GRID_MS)) * GRID_MS
            points.append((on_grid, level))
        self.events.append((channel, points))

    def blink(self, at):
        self.add((45, ""), at, 120, 40, 200, 100)

    def smile(self, start, length, percent):
        weaker = "L" if self.chance(0.5) else "R"
        stronger = "R" if weaker == "L" else "L"
        self.add((12, stronger), start, 400, length, 600, percent)
        self.add((12, weaker), start + 40, 400, length - 40, 600, 0.85 * percent)
        self.add((6, ""), start + 80, 420, length - 100, 560, 0.6 * percent)

    def mood(self, name, start, length):
        if name == "smile":
            self.smile(start - 200, length, self.between(45, 75))
            self.add("tilt", start, 500, length - 300, 700, self.between(-18, 18))
        elif name == "doubt":
            self.add((4, ""), start, 300, length - 200, 400, self.between(30, 50))
            self.add((7, ""), start, 300, length - 200, 400, self.between(15, 30))
            self.add("tilt", start - 100, 500, length, 600, self.between(12, 25))
        elif name == "surprise":
            for number, percent in ((1, 70), (2, 75), (5, 40)):
                self.add((number, ""), start - 100, 200, 0.4 * length, 500, percent)
            self.add("pitch", start - 100, 300, 0.5 * length, 500, self.between(8, 15))
        elif name == "sad":
            for number, percent in ((1, 60), (4, 35), (15, 35)):
                self.add((number, ""), start - 100, 500, length, 700, percent)
            self.add("pitch", start, 500, length, 700, self.between(-25, -15))

    def syllable(self, text, length):
        """The consonant in front, then the vowel's opening and closing."""
        low = text.lower()
        stress = text != low
        strength = self.between(0.85, 1.0) if stress else self.between(0.5, 0.75)
        consonant = CONSONANTS.get(low[0])
        lead = 0.3 * length if consonant else 0.0
        if consonant:
            for number, percent in consonant.items():
                self.add((number, ""), self.now - 0.1 * length, 0.2 * length, 0.1 * length,
                         0.2 * length, percent)
        vowel = next(letter for letter in low if letter in VOWELS)
        for number, percent in VOWELS[vowel].items():
            self.add((number, ""), self.now + lead, 0.35 * length, 0.1 * length, 0.45 * length,
                     percent * strength)
        if stress:
            raised = self.between(25, 50)
            self.add((1, ""), self.now - 60, 140, 80, 240, 0.7 * raised)
            self.add((2, ""), self.now - 60, 140, 80, 240, raised)
            self.add("pitch", self.now, 120, 20, 220, self.between(-20, -8))

    def phrase(self, pause, mood, text):
        before = self.now
        self.now += pause
        words = text.split()
        syllables = [part for word in words for part in word.split("-")]
        lengths = [self.between(200, 260) * (1.25 if part != part.lower() else 1.0)
                   for part in syllables]
        whole = sum(lengths)
        self.mood(mood, self.now, whole)
        self.add("turn", self.now - 200, 500, whole - 400, 600, self.between(-22, 22))
        if pause >= 500:
            # Thinking: the eyes go aside and up, and are back when the phrase begins.
            stay = pause - 300
            self.add("look", before, 100, stay, 100, self.between(20, 45) *
                     (1 if self.chance(0.5) else -1))
            self.add("lift", before, 100, stay, 100, self.between(-10, 25))
        for part, length in zip(syllables, lengths):
            self.syllable(part, length)
            self.now += length
        self.now = round(self.now / GRID_MS) * GRID_MS

    def blinks(self):
        """Every 2.5 to 4.5 seconds: on average 17 a minute."""
        at = 1200.0
        while at < self.now:
            self.blink(at)
            at += self.between(2500, 4500)

    def level(self, channel, moment):
        levels = [0.0]
        for name, points in self.events:
            if name == channel and points[0][0] <= moment <= points[-1][0]:
                levels.append(interpolated(points, moment))
        return sum(levels) if channel in DIRECTIONS else max(levels)

    def keyframes(self):
        moments = {0}
        for _, points in self.events:
            moments.update(moment for moment, _ in points)
        moments.add(max(moments) + GAP_MS_MAX)
        ordered = sorted(moments)
        for first, second in zip(ordered, ordered[1:]):
            moments.update(range(first + GAP_MS_MAX, second, GAP_MS_MAX))
        channels = sorted({channel for channel, _ in self.events}, key=str)
        poses = [(moment, [self.level(channel, moment) for channel in channels])
                 for moment in sorted(moments)]
        kept = thinned(poses)
        for (before, _), (moment, levels) in zip(kept, kept[1:]):
            yield f"{packet(channels, levels)};{moment - before}"


def packet(channels, levels):
    terms = {}
    for channel, level in zip(channels, levels):
        if channel in DIRECTIONS:
            term = (DIRECTIONS[channel][0 if level > 0 else 1], "")
        else:
            term = channel
        percent = min(100, int(abs(level) + 0.5))
        if percent >= PERCENT_MIN:
            terms[term] = percent
    words = [side + str(number) + (f":{percent}" if percent < 100 else "")
             for (number, side), percent in sorted(terms.items())]
    return ",".join(words) or "0"


def thinned(poses):
    """Leaves out every pose that lies on the way between its neighbours within TOLERANCE."""
    kept = [poses[0]]
    waiting = []
    for pose in poses[1:]:
        if waiting and not (pose[0] - kept[-1][0] <= GAP_MS_MAX and
                            all(on_the_way(kept[-1], middle, pose) for middle in waiting)):
            kept.append(waiting[-1])
            waiting = []
        waiting.append(pose)
    return kept + waiting[-1:]


def on_the_way(first, middle, last):
    share = (middle[0] - first[0]) / (last[0] - first[0])
    return all(abs(low + (high - low) * share - level) <= TOLERANCE
               for low, level, high in zip(first[1], middle[1], last[1]))


def interpolated(points, moment):
    for (begin, low), (end, high) in zip(points, points[1:]):
        if begin <= moment <= end:
            return high if end == begin else low + (high - low) * (moment - begin) / (end - begin)
    return 0.0


def stream():
    talk = Talk()
    for pause, mood, text in PHRASES:
        talk.phrase(pause, mood, text)
    talk.blinks()
    lines = ["# Somebody speaks: mouth, brows, blinks, smiles, head and gaze.",
             "# Written by scripts/make_talk.py; change that, not this.", "Beg_Stream"]
    lines += talk.keyframes()
    lines.append("End_Stream")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", metavar="FILE")
    options = parser.parse_args()
    return write_or_check(stream(), options.check)


if __name__ == "__main__":
    sys.exit(main())
