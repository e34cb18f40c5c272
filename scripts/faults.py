#!/usr/bin/env python3
"""Runs both programs over emulated links and through faults, at full length.

    scripts/faults.py [--bin FOLDER] [--seconds N] [--only NAME[,NAME...]]

Two network namespaces are joined by linkemu, a program of this project that delays, loses and
throttles packets (the kernel needs no netem; root and /dev/net/tun are needed). Where that is not
allowed it says so, and only `proxy` is run, which needs no rights. What is run:

  satellite   25 keyframes a second with intensities, head and gaze over 600 ms +- 100 ms of round
              trip, 1 % loss, 64 kbit/s: the recorded stream plays without a stall, the live one is
              followed to its end
  lecture     the same link for the lecture of data/streams, heard on a device that nobody listens to:
              no stall, and the face is 15 ms late to 45 ms early in 90 % of all moments
  bursts      the same with 3 % loss in bursts of 5: everything arrives, stalls are told
  classic     the same link with --protocol classic: everything arrives, as slow as stop-and-wait is
  down        the link is down for 20 s (--seconds): nothing of a recorded stream is lost, a live one
              goes on where it is
  vanished    the other host is gone without a word: the server closes a live client, to which it goes
              on sending, and a paused one, to which it does not, within 75 s; so long after the last
              keyframe the player has given up too
  proxy       the tests of tests/integration/faults_test.cpp, with faults of 10 s (half --seconds)

A link that is to lose packets must have lost some on the way to the player, and in bursts several in a
row: a run by whose seed nothing was lost shows nothing and is made again with the next seed, at most
five times.

Prints a line for each and exits 1 when something did not hold.
"""

import argparse
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time

SERVER, CLIENT = f"aucast{os.getpid()}s", f"aucast{os.getpid()}c"
DEVICES = (f"auls{os.getpid() % 100000}", f"aulc{os.getpid() % 100000}")
SEEDS = (21, 58, 51, 59, 30)  # of those by which the chance takes some of the first 50 packets
SERVER_ADDRESS, CLIENT_ADDRESS = "10.78.0.1", "10.78.0.2"
SATELLITE = ("--delay", "300", "--jitter", "50", "--loss", "1", "--rate", "64")


def ip(*arguments):
    subprocess.run(("ip", *arguments), check=True, stderr=subprocess.PIPE)

# A live client and one that pauses at once, both reading, for ever.
VANISHING = f"""
import selectors, socket

from programs import Transmitter
watch = selectors.DefaultSelector()
for pause in (b"", b"-1"):
    client = socket.create_connection(("{SERVER_ADDRESS}", 4650))
    client.sendall(b"{{hello v=2 window=0}}" + pause)
    client.recv(1000)
    watch.register(client, selectors.EVENT_READ)
print("ready", flush=True)
while True:
    for key, _ in watch.select():
        key.fileobj.recv(1000)
"""


class Link:
    """Two hosts, SERVER and CLIENT, and the bad link between them."""

    def __init__(self, binaries, quality):
        self.emulator = None
        self.lost = self.in_a_row = 0  # on the way to the client, known at the end
        ip("netns", "add", SERVER)
        ip("netns", "add", CLIENT)
        self.emulator = subprocess.Popen((binaries / "linkemu", *DEVICES, *quality),
                                         stdout=subprocess.PIPE, text=True)
        if self.emulator.stdout.readline() != "ready\n":
            raise OSError("linkemu did not get ready")
        for host, device, own, other in ((SERVER, DEVICES[0], SERVER_ADDRESS, CLIENT_ADDRESS),
                                         (CLIENT, DEVICES[1], CLIENT_ADDRESS, SERVER_ADDRESS)):
            ip("link", "set", device, "netns", host)
            ip("-n", host, "addr", "add", own, "peer", other, "dev", device)
            ip("-n", host, "link", "set", device, "up")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.emulator:
            self.emulator.terminate()
            said = self.emulator.stdout.read()
            self.emulator.wait()
            print("".join(f"    link, {line}\n" for line in said.splitlines()), end="")
            lost = re.search(r"direction 1: .* (\d+) lost, (\d+) in a row", said)
            self.lost, self.in_a_row = (int(count) for count in lost.groups()) if lost else (0, 0)
        clean_up()

    def set_down(self, down):
        self.emulator.send_signal(signal.SIGUSR1 if down else signal.SIGUSR2)


def clean_up():
    for host in (SERVER, CLIENT):
        subprocess.run(("ip", "netns", "del", host), stderr=subprocess.DEVNULL, check=False)


def lively(path, count):
    """Mouth, brows, head (51-54) and gaze (61, 62), with intensities, 25 times a second."""
    with open(path, "w", encoding="ascii") as file:
        file.write("Beg_Stream\n")
        for n in range(count):
            percent = [10 + n * step % 90 for step in (1, 7, 5, 13, 3, 2, 11)]
            file.write("1:{0},L12:{1},R12:{2},25:{3},{7}:{4},54:{5},{8}:{6};40\n".format(
                *percent, 51 + n // 50 % 2, 61 + n // 30 % 2))
        file.write("End_Stream\n")


class Faults:
    def __init__(self, options, folder):
        self.options = options
        self.folder = folder
        self.failures = []

    def judge(self, name, holds, words):
        print(f"  {'ok    ' if holds else 'FAILED'} {name}: {words}", flush=True)
        if not holds:
            self.failures.append(name)

    def play(self, quality, count, in_a_row=1, **more):
        """Transmissions over a link until one has lost so many packets in a row."""
        for seed in SEEDS:
            code, stats, link = self.play_once((*quality, "--seed", str(seed)), count, **more)
            if link.in_a_row >= in_a_row:
                return code, stats
            print(f"    at most {link.in_a_row} lost in a row with seed {seed}: once more", flush=True)
        raise LookupError("no packet was lost")

    def serve(self, *arguments, **more):
        return Transmitter(self.options.bin, "--bind", SERVER_ADDRESS, "--port", "4650", *arguments,
                           before=("ip", "netns", "exec", SERVER), **more)

    def play_once(self, quality, count, server_options=(), player_options=(), trouble=None,
                  stream=None):
        """One transmission over a link: the player's exit code and statistics, and the link."""
        stats = self.folder / "stats.json"
        stats.unlink(missing_ok=True)
        if stream is None:
            stream = self.folder / "lively.txt"
            lively(stream, count)
        with Link(self.options.bin, quality) as link:
            server = self.serve(*server_options, stream)
            timers = [threading.Timer(at, link.set_down, (down,)) for at, down in trouble or ()]
            for timer in timers:
                timer.start()
            try:
                code = subprocess.run(
                    ("ip", "netns", "exec", CLIENT, self.options.bin / "face-player", "--headless",
                     SERVER_ADDRESS, "--stats", stats, *player_options),
                    env={**os.environ, "ALSOFT_DRIVERS": "null"}, stderr=subprocess.DEVNULL, timeout=600, check=False).returncode
            finally:
                for timer in timers:
                    timer.cancel()
                server.stop()
        return code, json.loads(stats.read_text(encoding="utf-8")), link

    @staticmethod
    def told(code, stats):
        return (f"exit code {code}, {stats['keyframes_played']} keyframes in "
                f"{stats['playback_seconds']:.1f} s, {stats['stalls']} stalls, "
                f"{stats['keyframes_dropped']} dropped, {stats['end_reason']}")

    def satellite(self):
        code, stats = self.play(SATELLITE, 750)
        self.judge("recorded", code == 0 and stats["keyframes_played"] == 750
                   and stats["stalls"] == 0, self.told(code, stats))
        code, stats = self.play(SATELLITE, 750, server_options=("--live",))
        self.judge("live", code == 0 and stats["end_reason"] == "end_of_stream"
                   and stats["keyframes_played"] > 0, self.told(code, stats))

    def lecture(self):
        stream = pathlib.Path(__file__).resolve().parent.parent / "data" / "streams" / "lecture.txt"
        for name, options in (("recorded", ()), ("live", ("--live",))):
            code, stats = self.play(SATELLITE, 0, stream=stream,
                                    server_options=("--batch", "180", *options),
                                    player_options=("--sound-device", "default"))
            low, high = stats["face_to_sound_p5_ms"], stats["face_to_sound_p95_ms"]
            self.judge(name, code == 0 and stats["stalls"] == 0 and -15 <= low and high <= 45
                       and stats["voice_packets"] > 0,
                       f"{self.told(code, stats)}, {stats['voice_packets']} voice packets, "
                       f"{stats['voice_late']} of them late; face to sound {low} to {high} ms")

    def bursts(self):
        quality = ("--delay", "300", "--jitter", "50", "--loss", "3", "--burst", "5", "--rate", "64")
        code, stats = self.play(quality, 750, in_a_row=2)
        self.judge("recorded", code == 0 and stats["keyframes_played"] == 750,
                   self.told(code, stats))

    def classic(self):
        code, stats = self.play(SATELLITE, 40, player_options=("--protocol", "classic"))
        self.judge("recorded", code == 0 and stats["keyframes_played"] == 40,
                   self.told(code, stats))

    def down(self):
        seconds = self.options.seconds
        trouble = ((8, True), (8 + seconds, False))
        code, stats = self.play(SATELLITE, 500, trouble=trouble)
        self.judge("recorded", code == 0 and stats["keyframes_played"] == 500,
                   self.told(code, stats))
        count = 25 * (20 + 3 * int(seconds))
        code, stats = self.play(SATELLITE, count, server_options=("--live",), trouble=trouble)
        self.judge("live", code == 0 and stats["end_reason"] == "end_of_stream"
                   and stats["keyframes_played"] < count, self.told(code, stats))

    def vanished(self):
        stream, log = self.folder / "lively.txt", self.folder / "log.txt"
        lively(stream, 25 * 120)
        with Link(self.options.bin, ()) as link, log.open("w", encoding="utf-8") as errors:
            server = self.serve("--live", stream, stderr=errors)
            clients = subprocess.Popen(
                ("ip", "netns", "exec", CLIENT, sys.executable, "-c", VANISHING),
                stdout=subprocess.PIPE, text=True)
            clients.stdout.readline()
            link.set_down(True)
            begin = time.monotonic()
            gone = 0
            while gone < 2 and time.monotonic() - begin < 75:
                time.sleep(0.2)
                gone = log.read_text(encoding="utf-8").count(": closed: peer gone")
            seconds = time.monotonic() - begin
            for process in (clients, server.process):
                process.kill()
                process.wait()
        self.judge("clients", gone == 2, f"{gone} of 2 found after {seconds:.0f} s")
        begin = time.monotonic()
        code, stats, _ = self.play_once((), 25 * 120, trouble=((8, True),))
        seconds = time.monotonic() - begin
        self.judge("server", code == 5 and seconds < stats["playback_seconds"] + 75,
                   f"{self.told(code, stats)}; over after {seconds:.0f} s")

    def proxy(self):
        variables = dict(os.environ, AUCAST_FAULT_SECONDS=str(max(1, int(self.options.seconds / 2))))
        code = subprocess.run((self.options.bin / "test_faults", "--gtest_brief=1"), env=variables,
                              check=False).returncode
        self.judge("test_faults", code == 0, f"exit code {code}")


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0],
                                     epilog=__doc__.split("\n", 2)[2],
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=root / "build/release/bin")
    parser.add_argument("--seconds", type=float, default=20)
    parser.add_argument("--only", default="satellite,lecture,bursts,classic,down,vanished,proxy")
    options = parser.parse_args()
    wanted = options.only.split(",")
    unknown = set(wanted) - set(parser.get_default("only").split(","))
    if unknown:
        parser.error(f"there is no {', '.join(sorted(unknown))}")
    with tempfile.TemporaryDirectory() as folder:
        faults = Faults(options, pathlib.Path(folder))
        for name in wanted:
            print(name, flush=True)
            try:
                getattr(faults, name)()
            except LookupError as error:
                print(f"  FAILED {name}: {error}")
                faults.failures.append(name)
            except (OSError, subprocess.CalledProcessError) as error:
                clean_up()
                print(f"  not run: no network namespaces with TUN devices here ({error})")
                if "proxy" not in wanted:
                    faults.failures.append(name)
    print(f"failed: {', '.join(faults.failures)}" if faults.failures else "passed")
    return 1 if faults.failures else 0


if __name__ == "__main__":
    sys.exit(main())
