#!/usr/bin/env python3
"""Runs the programs for long and reports whether anything grows or drifts.

    scripts/soak.py [--bin FOLDER] [--minutes N] [--hours N] [--clients N] [--part fast|real]

Two parts. fast: a stream of an hour (--hours) from au-transmitter to `face-player --fast`, which
must play all of it. real: for ten minutes (--minutes) one player on a recorded stream and one on a
live stream, while up to 100 (--clients) other clients of every kind come and go at both servers.
Prints what was measured and exits 1 unless memory and descriptors of all programs stay flat, both
players end well, and the recorded stream took its own time to within a picture (1/30 s).

Flat: the median of the last quarter of the samples is not above that of the second quarter by more
than 2 % and 512 KiB; for descriptors, not at all once the other clients have left.
"""

import argparse
import json
import os
import pathlib
import random
import socket
import statistics
import subprocess
import sys
import tempfile
import threading
import time

PICTURE_SECONDS = 1 / 30
HELLOS = (b"", b"{hello v=2 window=8}", b"{hello v=2 window=0 delta=1}", b"{hello v=2 window=0}",
          b"{streams}", b"nonsense", b"{hello v=2 stream=nowhere}")


class Program:
    """One of ours as a child process, with its memory and descriptors over time."""

    def __init__(self, name, arguments):
        self.name = name
        self.process = subprocess.Popen(arguments, stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL, text=True)
        self.memory = []
        self.descriptors = []

    def address(self):
        return self.process.stdout.readline().removeprefix("listening on ").strip()

    def descriptor_count(self):
        return len(os.listdir(f"/proc/{self.process.pid}/fd"))

    def has_socket(self):
        folder = f"/proc/{self.process.pid}/fd"
        try:
            return any(os.readlink(f"{folder}/{number}").startswith("socket:")
                       for number in os.listdir(folder))
        except OSError:
            return False

    def sample(self):
        """What it has written to of its own memory, in KiB, and open descriptors now; nothing when it
        has ended. Pages of the program's file count as private only while nobody else runs it."""
        try:
            with open(f"/proc/{self.process.pid}/smaps_rollup", encoding="ascii") as file:
                private = [int(line.split()[1]) for line in file if line.startswith("Private_Dirty:")]
            descriptors = self.descriptor_count()
        except (OSError, ValueError):
            return
        if private:
            self.memory.append(sum(private))
            self.descriptors.append(descriptors)

    def stop(self):
        self.process.terminate()
        return self.process.wait(timeout=20)


def quarters(samples):
    """Medians of the second and of the last quarter."""
    size = max(len(samples) // 4, 1)
    return statistics.median(samples[size:2 * size] or samples), statistics.median(samples[-size:])


def judge_memory(program, findings):
    if len(program.memory) < 8:
        findings.append(f"{program.name}: only {len(program.memory)} samples, nothing can be said")
        return
    early, late = quarters(program.memory)
    print(f"  {program.name:24} {len(program.memory):5} samples, private memory {early:8.0f} -> "
          f"{late:8.0f} KiB, descriptors {quarters(program.descriptors)}")
    if late > early * 1.02 + 512:
        findings.append(f"{program.name}: memory grew from {early:.0f} to {late:.0f} KiB")


def write_stream(path, seconds, keyframe_ms):
    generator = random.Random(1)
    with open(path, "w", encoding="ascii") as file:
        file.write("Beg_Stream\n")
        for _ in range(int(seconds * 1000 / keyframe_ms)):
            first, second = sorted(generator.sample((1, 2, 4, 5, 6, 7, 9, 10, 12, 15, 17, 20, 26), 2))
            file.write(f"{first}:{generator.randint(10, 99)},{second}:{generator.randint(10, 99)}"
                       f";{keyframe_ms}\n")
        file.write("End_Stream\n")


class Comer(threading.Thread):
    """Clients of every kind, one after the other, each for a few seconds at most."""

    def __init__(self, addresses, seed, stop):
        super().__init__(daemon=True)
        self.addresses = addresses
        self.random = random.Random(seed)
        self.stop = stop
        self.visits = 0

    def run(self):
        while not self.stop.is_set():
            try:
                self.visit()
                self.visits += 1
            except OSError:
                pass
            self.stop.wait(self.random.uniform(0, 0.5))

    def visit(self):
        host, port = self.random.choice(self.addresses).rsplit(":", 1)
        hello = self.random.choice(HELLOS)
        with socket.create_connection((host, int(port)), timeout=5) as client:
            client.sendall(hello)
            client.settimeout(0.5)
            until = time.monotonic() + self.random.uniform(0, 4)
            while time.monotonic() < until and not self.stop.is_set():
                try:
                    got = client.recv(4096)
                except TimeoutError:
                    continue
                if not got:
                    break
                if b"window=0" not in hello:
                    client.sendall(b"1" * got.count(b"}"))
            if self.random.random() < 0.3:
                client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")


def read_json(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def fast(options, folder, findings):
    print(f"{options.hours:g} h of a stream with --fast")
    stream, stats = folder / "long.txt", folder / "fast.json"
    keyframe_ms = 250
    write_stream(stream, options.hours * 3600, keyframe_ms)
    server = Program("au-transmitter", [options.bin / "au-transmitter", "--port", "0", stream])
    player = Program("face-player --fast", [options.bin / "face-player", "--headless", "--fast",
                                            server.address(), "--stats", stats])
    begin = time.monotonic()
    while player.process.poll() is None:
        # Before it is there it reads its files, and grows as it should.
        if player.has_socket():
            server.sample()
            player.sample()
        time.sleep(0.005)
    played = read_json(stats)
    print(f"  exit code {player.process.returncode}, {played['keyframes_played']} keyframes, media "
          f"{played['media_seconds']} s, in {time.monotonic() - begin:.1f} s, "
          f"{played['end_reason']}")
    wanted = int(options.hours * 3600 * 1000 / keyframe_ms)
    if player.process.returncode != 0 or played["keyframes_played"] != wanted:
        findings.append(f"--fast: {played['keyframes_played']} of {wanted} keyframes were played")
    judge_memory(server, findings)
    judge_memory(player, findings)
    if server.stop() != 0:
        findings.append("au-transmitter did not end with 0")


def real(options, folder, findings):
    seconds = options.minutes * 60
    print(f"{options.minutes:g} minutes in real time, {options.clients} clients coming and going")
    recorded, live = folder / "recorded.txt", folder / "live.txt"
    write_stream(recorded, seconds, 40)
    write_stream(live, seconds, 40)
    servers = [Program("au-transmitter", [options.bin / "au-transmitter", "--port", "0", recorded]),
               Program("au-transmitter --live", [options.bin / "au-transmitter", "--port", "0",
                                                 "--live", live])]
    addresses = [server.address() for server in servers]
    quiet = [server.descriptor_count() for server in servers]
    files = [folder / "recorded.json", folder / "live.json"]
    players = [Program(name, [options.bin / "face-player", "--headless", address, "--stats", file])
               for name, address, file in zip(("player, recorded", "player, live"), addresses, files)]
    stop = threading.Event()
    comers = [Comer(addresses, seed, stop) for seed in range(options.clients)]
    for comer in comers:
        comer.start()
    while any(player.process.poll() is None for player in players):
        for program in servers + players:
            program.sample()
        time.sleep(1)
    stop.set()
    for comer in comers:
        comer.join()
    print(f"  {sum(comer.visits for comer in comers)} visits")
    for player, file in zip(players, files):
        stats = read_json(file)
        drift = stats["playback_seconds"] - stats["media_seconds"]
        print(f"  {player.name}: exit code {player.process.returncode}, {stats['end_reason']}, "
              f"{stats['keyframes_played']} keyframes, {stats['stalls']} stalls, media "
              f"{stats['media_seconds']:.3f} s, playback {stats['playback_seconds']:.3f} s, drift "
              f"{drift * 1000:+.1f} ms")
        if player.process.returncode != 0:
            findings.append(f"{player.name} ended with {player.process.returncode}")
        if "recorded" in player.name and abs(drift) > PICTURE_SECONDS:
            findings.append(f"{player.name}: {drift * 1000:.1f} ms of drift")
    for program in servers + players:
        judge_memory(program, findings)
    time.sleep(4)  # the last words of those who left
    for server, before in zip(servers, quiet):
        print(f"  {server.name}: {before} descriptors before the first client, "
              f"{server.descriptor_count()} after the last")
        if server.descriptor_count() > before:
            findings.append(f"{server.name}: descriptors are left over")
        if server.stop() != 0:
            findings.append(f"{server.name} did not end with 0")


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0],
                                     epilog=__doc__.split("\n", 2)[2],
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=root / "build/release/bin")
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--hours", type=float, default=1)
    parser.add_argument("--clients", type=int, default=100)
    parser.add_argument("--part", choices=("fast", "real"))
    options = parser.parse_args()
    findings = []
    with tempfile.TemporaryDirectory() as folder:
        if options.part != "real":
            fast(options, pathlib.Path(folder), findings)
        if options.part != "fast":
            real(options, pathlib.Path(folder), findings)
    for finding in findings:
        print(f"NOT FLAT: {finding}")
    print("failed" if findings else "passed")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
