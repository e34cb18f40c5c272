#!/usr/bin/env python3
"""Makes data/camera/action_units.txt, the weights of the camera's Action Units.

    train.py PROGRAMS MODELS WORK [--people N] [--pictures N] [--without HEAD] [--out FILE]

PROGRAMS: the folder of the built face-player, facegen and face-measures. MODELS: data/models, which
scripts/install_models.sh fills. WORK: keeps what was rendered, so that a run goes on where the last one
ended. With --without HEAD the weights have never seen that head. At the end each head is read by
weights of the other ones: r and mean error of every AU, on people that were not trained for.
"""

import argparse
import os
import sys

import numpy

import fit
import pictures

HEADS = ["default", "marek"]


def people_of(options, head):
    data = os.path.join(options.programs, "data")
    people = []
    for number in range(options.people):
        rows = pictures.examples_of(options.programs, data, options.models, options.work, head,
                                    number, options.pictures)
        neutral = fit.neutral_of([row for row, face in rows if not face])
        people.append([(row, face, neutral) for row, face in rows])
    return people


def typical(people):
    return fit.neutral_of([examples[0][2] for examples in people])


def agreement(weights, thresholds, seeming, people):
    """{output: (r, mean error in percent)}"""
    features, targets = fit.table_of(fit.levelled_people(people, seeming))
    # Who smiles more broadly than the shipped heads can is as they are at their most.
    targets = numpy.clip(targets, -1, 1)
    raw = features @ weights[:, 1:].T + weights[:, :1].T
    found = {}
    for k, number in enumerate(fit.OUTPUTS):
        said = raw[:, k]
        if number not in fit.TURNING and number not in fit.SIGNED:
            said = fit.rise(said, thresholds[k])
        r = numpy.corrcoef(said, targets[:, k])[0, 1] if said.std() > 0 else 0.0
        found[number] = (r, 100 * numpy.abs(said - targets[:, k]).mean())
    return found


def weights_of(people):
    seeming = fit.seeming_of(people)
    level = fit.levelled_people(people, seeming)
    weights = fit.fit(level)
    return weights, fit.thresholds_of(weights, level), seeming


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("programs")
    parser.add_argument("models")
    parser.add_argument("work")
    parser.add_argument("--people", type=int, default=7)
    parser.add_argument("--pictures", type=int, default=200)
    parser.add_argument("--without", choices=HEADS)
    parser.add_argument("--out")
    options = parser.parse_args()
    os.makedirs(options.work, exist_ok=True)
    people = {head: people_of(options, head) for head in HEADS}
    chosen = sum((people[head] for head in HEADS if head != options.without), [])
    if options.out:
        fit.write(options.out, *weights_of(chosen), typical(chosen))
    table = {}
    for head in HEADS:
        others = sum((people[other] for other in HEADS if other != head), [])
        table[head] = agreement(*weights_of(others), people[head])
    print("| AU | " + " | ".join(f"r, {head}" for head in HEADS) + " | mean error, % |")
    print("|---|" + "---|" * (len(HEADS) + 1))
    for number in fit.OUTPUTS:
        error = numpy.mean([table[head][number][1] for head in HEADS])
        print(f"| {number} | " + " | ".join(f"{table[head][number][0]:.2f}" for head in HEADS)
              + f" | {error:.1f} |")
    mean = numpy.mean([[value[0] for value in table[head].values()] for head in HEADS])
    print(f"mean r {mean:.2f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
