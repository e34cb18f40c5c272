#!/usr/bin/env python3
"""Measures whether the lips that au-speaker makes are shut when the voice says p, b and m.

    scripts/lips_check.py [--bin FOLDER] [--language L] [--video FILE] [--check] [TEXT]
    scripts/lips_check.py --reading [--bin FOLDER] [--check] [TEXT]

TEXT is a lecture as au-speaker reads it (scripts/lecture_words.txt; reading_words.txt).

First form, a typed lecture. The truth is the WAV itself: before the burst of p and b, and during m,
its energy above some 1000 Hz dips. The lips are those of the video: face-player draws a hundred
pictures a second, in which the mouth's dark and its teeth are counted (head still, --gestures 0).
Prints how many closures are shut in the pictures, how far the middle of the shut lips is from the
middle of the dip (lips that stay shut for more than 0.2 s are right all the while), and at which lag
the mouth's opening and the voice's envelope agree best. --video: measures a video that was made so
before; making it takes some minutes.

Second form, a recorded voice with its transcript: another synthesiser (flite's slt, by its library)
reads TEXT and says itself where each p, b and m is, within which its WAV dips; au-speaker --voice
gets the WAV and the words. Prints how far from the middle of the dip the lips press most (AU 24 of
the stream).

--check exits 1 when a closure is missing or the median is above 25 ms, or, of a reading, above 30 ms
or 90 % above 80 ms.
"""

import argparse
import array
import ctypes
import math
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import wave

FPS = 100
SIZE = 200
BOX = (80, 120, 116, 152)  # the middle of the mouth in a picture of SIZE: left, right, top, bottom
LIPS = ("p", "b", "m")
NEAR_S = 0.12  # a dip and the shut lips are looked for so near the sound's mark
STEP = 0.005   # seconds: the envelope's


def read_wav(path):
    with wave.open(str(path)) as file:
        if file.getsampwidth() != 2 or file.getnchannels() != 1:
            sys.exit(f"{path} is not mono with 16 bits")
        samples = array.array("h", file.readframes(file.getnframes()))
        return samples, file.getframerate()


def envelope(samples, rate, order):
    """Of each STEP the loudness; `order`: how often the difference is taken first, against hums."""
    signal = [float(sample) for sample in samples]
    for _ in range(order):
        signal = [b - a for a, b in zip(signal, signal[1:])]
    length = int(rate * STEP)
    return [math.sqrt(sum(x * x for x in signal[i:i + length]) / length)
            for i in range(0, len(signal) - length + 1, length)]


def smoothed(values, reach):
    sums = [0.0]
    for value in values:
        sums.append(sums[-1] + value)
    return [(sums[min(i + reach + 1, len(values))] - sums[max(i - reach, 0)]) /
            (min(i + reach + 1, len(values)) - max(i - reach, 0)) for i in range(len(values))]


def low_stretch(values, step, mark, share, near_s=NEAR_S):
    """Where the values are low around their least near `mark`: begin, end and least; seconds."""
    first = max(int((mark - near_s) / step), 0)
    last = min(int((mark + near_s) / step) + 1, len(values))
    if last - first < 3:
        return None
    near = values[first:last]
    least, most = min(near), max(near)
    limit = least + share * (most - least)
    low = [i for i in range(first, last) if values[i] <= limit]
    at = min(low, key=lambda i: abs(i * step - mark))
    begin = end = at
    while begin > 0 and values[begin - 1] <= limit:
        begin -= 1
    while end + 1 < len(values) and values[end + 1] <= limit:
        end += 1
    return begin * step, (end + 1) * step, least


def labels(path):
    """(begin, end, letters) of each sound."""
    sounds = []
    for line in path.read_text(encoding="utf-8").splitlines():
        begin, end, letters = line.split("\t")
        sounds.append((float(begin), float(end), letters))
    return sounds


def is_lips(letters):
    return re.sub(r"[^a-zA-Z]", "", letters)[:1] in LIPS


def speak(options, folder, *more):
    subprocess.run([options.bin / "au-speaker", options.text, "--name", "talk", "-o", folder,
                    "--language", options.language, "--gestures", "0", "--labels",
                    folder / "labels.txt", *more], check=True)


def openings(video):
    """Of each picture: how many pixels of the mouth are dark inside or teeth."""
    process = subprocess.Popen(
        ["ffmpeg", "-v", "error", "-i", video, "-vf", f"scale={SIZE}:{SIZE}", "-pix_fmt", "rgb24",
         "-f", "rawvideo", "-"], stdout=subprocess.PIPE)
    left, right, top, bottom = BOX
    counts = []
    while len(picture := process.stdout.read(3 * SIZE * SIZE)) == 3 * SIZE * SIZE:
        count = 0
        for y in range(top, bottom):
            row = picture[3 * (y * SIZE + left):3 * (y * SIZE + right)]
            for red, blue in zip(row[0::3], row[2::3]):
                count += red < 95 or (red > 135 and red - blue < 28)
        counts.append(count)
    process.wait()
    return counts


def best_lag_ms(opening, loud):
    """At which lag of the mouth both agree best: above 0 the mouth is late."""
    count = min(len(opening), len(loud))
    mean_o, mean_l = statistics.fmean(opening[:count]), statistics.fmean(loud[:count])
    best, best_at = -math.inf, 0
    for lag in range(-20, 21):
        total = sum((opening[i + lag] - mean_o) * (loud[i] - mean_l)
                    for i in range(max(0, -lag), min(count, count - lag)))
        if total > best:
            best, best_at = total, lag
    return best_at * 1000 // FPS


def typed(options, folder):
    speak(options, folder)
    video = options.video
    if video is None:
        video = folder / "talk.mp4"
        subprocess.run([options.bin / "face-player", "play", folder / "talk.txt", "--headless",
                        "--fps", str(FPS), "--size", f"{SIZE}x{SIZE}", "--record", video],
                       check=True)
    samples, rate = read_wav(folder / "talk.wav")
    sharp = smoothed(envelope(samples, rate, 2), 1)
    opening = openings(video)
    widest = sorted(opening)[len(opening) * 95 // 100]
    errors, open_ones = [], []
    sounds = [sound for sound in labels(folder / "labels.txt") if is_lips(sound[2])]
    for begin, end, letters in sounds:
        # What is marked is the burst of a stop, and the beginning of a hum.
        mark = (begin + end) / 2 if letters.startswith("m") else begin - 0.025
        dip = low_stretch(sharp, STEP, mark, 0.15)
        if dip is None:
            continue
        shut = low_stretch(opening, 1 / FPS, (dip[0] + dip[1]) / 2, 0.1)
        if shut[2] > 0.12 * widest:
            open_ones.append(f"{letters} at {begin:.2f} s")
        # Lips that stay shut in a pause are right from its beginning to its end.
        shut_middle = min(max((dip[0] + dip[1]) / 2, shut[0]), shut[1]) if shut[1] - shut[0] > 0.2 \
            else (shut[0] + shut[1]) / 2
        errors.append(1000 * (shut_middle - (dip[0] + dip[1]) / 2))
    sizes = sorted(abs(error) for error in errors)
    print(f"{len(errors)} closures, {len(errors) - len(open_ones)} shut in the pictures; "
          f"middle of the shut lips from the middle of the dip: median {statistics.median(sizes):.0f}"
          f" ms, 90 % within {sizes[len(sizes) * 9 // 10]:.0f} ms, lips late by "
          f"{statistics.median(errors):.0f} ms in the median")
    for one in open_ones:
        print(f"  open: {one}")
    per_picture = round(1 / FPS / STEP)
    loud = smoothed(envelope(samples, rate, 0), 4)[::per_picture]
    lag = best_lag_ms(opening, loud)
    print(f"opening and the voice's envelope agree best with the mouth {abs(lag)} ms "
          f"{'later' if lag > 0 else 'earlier'}")
    return not open_ones and statistics.median(sizes) < 25 and abs(lag) <= 60


def presses(stream):
    """AU 24 of a stream file, FPS times a second."""
    values, before, at = [], 0.0, 0.0
    for line in stream.read_text(encoding="utf-8").splitlines():
        match = re.fullmatch(r"([^;#]*);(\d+)", line)
        if match is None:
            continue
        after = 0.0
        for term in match[1].split(","):
            if term.split(":")[0].lstrip("LR") == "24":
                after = max(after, float((term + ":100").split(":")[1]))
        end = at + int(match[2]) / 1000
        while len(values) / FPS < end:
            share = (len(values) / FPS - at) / (end - at)
            values.append(before + (after - before) * share)
        before, at = after, end
    return values


class Flite:
    """flite's voice slt, from its libraries."""

    class Wave(ctypes.Structure):
        _fields_ = [("type", ctypes.c_char_p), ("rate", ctypes.c_int), ("count", ctypes.c_int),
                    ("channels", ctypes.c_int), ("samples", ctypes.POINTER(ctypes.c_short))]

    def __init__(self):
        for name in ("flite", "flite_cmulex", "flite_usenglish"):
            ctypes.CDLL(f"lib{name}.so.1", ctypes.RTLD_GLOBAL)
        self.flite = ctypes.CDLL("libflite.so.1", ctypes.RTLD_GLOBAL)
        slt = ctypes.CDLL("libflite_cmu_us_slt.so.1", ctypes.RTLD_GLOBAL)
        self.flite.flite_init()
        slt.register_cmu_us_slt.restype = ctypes.c_void_p
        self.voice = slt.register_cmu_us_slt(None)
        pointer, text = ctypes.c_void_p, ctypes.c_char_p
        for function, result, arguments in (
                ("flite_synth_text", pointer, (text, pointer)),
                ("utt_relation", pointer, (pointer, text)), ("relation_head", pointer, (pointer,)),
                ("item_next", pointer, (pointer,)), ("item_feat_string", text, (pointer, text)),
                ("item_feat_float", ctypes.c_float, (pointer, text)),
                ("utt_wave", ctypes.POINTER(self.Wave), (pointer,))):
            getattr(self.flite, function).restype = result
            getattr(self.flite, function).argtypes = arguments

    def speak(self, text):
        """Samples, rate, and (begin, end, letters) of each sound."""
        flite = self.flite
        utterance = flite.flite_synth_text(text.encode("ascii", "ignore"), self.voice)
        spoken = flite.utt_wave(utterance).contents
        sounds, begin = [], 0.0
        item = flite.relation_head(flite.utt_relation(utterance, b"Segment"))
        while item:
            end = flite.item_feat_float(item, b"end")
            sounds.append((begin, end, flite.item_feat_string(item, b"name").decode()))
            begin = end
            item = flite.item_next(item)
        return spoken.samples[:spoken.count], spoken.rate, sounds


def spoken_text(path):
    """What of a lecture is spoken, one paragraph a line."""
    lines = [line for line in path.read_text(encoding="utf-8").splitlines()
             if not line.startswith("#")]
    text = re.sub(r"\[[^\]]*\]", "", "\n".join(lines))
    return [" ".join(part.split()) for part in re.split(r"\n\s*\n", text) if part.strip()]


def reading(options, folder):
    flite = Flite()
    samples, truth = array.array("h"), []
    for paragraph in spoken_text(options.text):
        said, rate, sounds = flite.speak(paragraph)
        begin = len(samples) / rate
        truth += [(begin + sound[0], begin + sound[1]) for sound in sounds if sound[2] in LIPS]
        samples.extend(said)
    with wave.open(str(folder / "read.wav"), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(rate)
        file.writeframes(samples.tobytes())
    speak(options, folder, "--voice", folder / "read.wav")
    sharp = smoothed(envelope(samples, rate, 2), 1)
    apart = [100 - press for press in presses(folder / "talk.txt")]
    errors = []
    for begin, end in truth:
        dip = low_stretch(sharp, STEP, (begin + end) / 2, 0.15, (end - begin) / 2 + 0.02)
        # A pause before it is not part of it.
        middle = (max(dip[0], begin) + min(dip[1], end)) / 2
        shut = low_stretch(apart, 1 / FPS, middle, 0.1)
        errors.append(1000 * abs((shut[0] + shut[1]) / 2 - middle))
    errors.sort()
    median, most = statistics.median(errors), errors[len(errors) * 9 // 10]
    print(f"{len(truth)} closures in {len(samples) / rate:.0f} s of flite's: the lips press within "
          f"{median:.0f} ms of the dip in the median, 90 % within {most:.0f} ms")
    return median <= 30 and most <= 80


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0],
                                     epilog=__doc__.split("\n", 2)[2],
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    root = pathlib.Path(__file__).resolve().parent.parent
    parser.add_argument("--bin", type=pathlib.Path, default=root / "build" / "release" / "bin")
    parser.add_argument("--language", default="en-gb")
    parser.add_argument("--video", type=pathlib.Path)
    parser.add_argument("--reading", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("text", nargs="?", type=pathlib.Path)
    options = parser.parse_args()
    if options.text is None:
        words = "reading_words.txt" if options.reading else "lecture_words.txt"
        options.text = root / "scripts" / words
    with tempfile.TemporaryDirectory() as folder:
        measure = reading if options.reading else typed
        good = measure(options, pathlib.Path(folder))
    return 1 if options.check and not good else 0


if __name__ == "__main__":
    sys.exit(main())
