#!/usr/bin/env python3
"""Writes a stream of random Action Units: the thesis' own test (section 5.4.6).

usage: make_random_stream.py [--packets N] [--seed N]   the stream goes to stdout
       make_random_stream.py --check FILE               exit 1 if FILE is not what would be written
"""
import argparse
import random
import sys

from stream_file import write_or_check

# The AUs that the thesis implements (table 3.1).
AUS = (1, 2, 4, 5, 6, 7, 9, 10, 12, 13, 14, 15, 16, 17, 20, 23, 26)
AUS_A_PACKET_MAX = 8


def random_packet(generator):
    """One to AUS_A_PACKET_MAX different AUs, ascending. Only random() itself is used: the other
    methods of the generator may change between versions of Python."""
    wanted = 1 + int(generator.random() * AUS_A_PACKET_MAX)
    left = list(AUS)
    chosen = [left.pop(int(generator.random() * len(left))) for _ in range(wanted)]
    return ",".join(str(number) for number in sorted(chosen))


def stream(packets, seed):
    generator = random.Random(seed)
    lines = [
        f"# {packets} random sets of Action Units, written by scripts/make_random_stream.py,",
        f"# seed {seed}. Untimed.",
        "Beg_Stream",
    ]
    lines += [random_packet(generator) for _ in range(packets)]
    lines.append("End_Stream")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--packets", type=int, default=100)
    parser.add_argument("--seed", type=int, default=2010)
    parser.add_argument("--check", metavar="FILE")
    options = parser.parse_args()
    return write_or_check(stream(options.packets, options.seed), options.check)


if __name__ == "__main__":
    sys.exit(main())
