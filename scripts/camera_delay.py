#!/usr/bin/env python3
"""Measures how long a face takes from a camera's picture to the wire, and what that costs.

    scripts/camera_delay.py [--bin FOLDER] [--fps N] [--seconds S] [--voice] [--before COMMAND] [--check]

Writes pictures of 640x480 (y4m) into a FIFO that au-transmitter reads as a camera, N (25) a second for
S (20) seconds. They show a neutral face and one that smiles, in turn for 12 pictures each; the delay is
that from the moment at which the first picture of a turn was due to the packet that tells the change,
as a client of this machine gets it. With --voice the client hears a voice too, which comes from a pipe
in real time, in packets of 20 ms. --before: what stands before au-transmitter on the command line, say
'taskset -c 1 chrt -r 1' on a busy machine. Prints the delays, the time of one core that au-transmitter
and its ffmpeg took, and the most memory each had. --check exits 1 when the median is above 60 ms, or
100 ms with --voice. Needs face-player, which draws the faces, ffmpeg and the models.
"""

import argparse
import os
import pathlib
import re
import shlex
import socket
import statistics
import subprocess
import sys
import tempfile
import threading
import time

from programs import Transmitter

WIDTH, HEIGHT = 640, 480
TURN = 12      # pictures for which a face stays
SMILE = "12,25"
HALF = 50      # percent of AU 12, between both faces
RATE = 16000   # samples of voice a second
MOST_MS = {False: 60, True: 100}


def picture(programs, folder, aus):
    """The planes of a drawn face, 4:2:0."""
    png = folder / "face.png"
    subprocess.run([programs / "face-player", "pose", aus, "--png", png, "--size",
                    f"{HEIGHT}x{HEIGHT}"], check=True, stdout=subprocess.DEVNULL)
    return subprocess.run(["ffmpeg", "-v", "error", "-i", png, "-vf",
                           f"pad={WIDTH}:{HEIGHT}:-1:-1", "-pix_fmt", "yuv420p", "-f", "rawvideo",
                           "-"], check=True, capture_output=True).stdout


def film(fifo, faces, options):
    """When each change was due: [(time, smiles)]."""
    due = []
    with open(fifo, "wb", buffering=0) as pipe:
        pipe.write(f"YUV4MPEG2 W{WIDTH} H{HEIGHT} F{options.fps}:1 Ip A1:1 C420jpeg\n".encode())
        begin = time.monotonic()
        for number in range(options.fps * options.seconds):
            at = begin + number / options.fps
            time.sleep(max(0.0, at - time.monotonic()))
            smiles = number // TURN % 2 == 1
            if number % TURN == 0 and number > 0:
                due.append((at, smiles))
            pipe.write(b"FRAME\n" + faces[smiles])
    return due


def speak(pipe, stop):
    """A tone, 20 ms at a time."""
    chunk = b"".join((8000 * (k % 80 // 40) - 4000).to_bytes(2, "little", signed=True)
                     for k in range(RATE // 50))
    begin, number = time.monotonic(), 0
    while not stop.is_set():
        time.sleep(max(0.0, begin + number / 50 - time.monotonic()))
        try:
            os.write(pipe.fileno(), chunk)
        except OSError:
            return
        number += 1


def listen(client, changes, voice):
    """When AU 12 has passed HALF: [(time, smiles)]; packets of voice: [time]."""
    text, smiles = b"", False
    while got := client.recv(65536):
        now = time.monotonic()
        text += got
        *packets, text = text.split(b"}")
        for packet in packets:
            if packet.lstrip().startswith(b"{a"):
                voice.append(now)
            if not re.match(rb"\s*\{\s*[LR0-9]", packet):
                continue
            terms = packet.decode().strip().lstrip("{").split(";")[0].split(",")
            shown = [float(term.partition(":")[2] or 100) for term in terms
                     if term.partition(":")[0] in ("12", "L12", "R12")]
            if (max(shown, default=0) > HALF) != smiles:
                smiles = not smiles
                changes.append((now, smiles))


def matched(due, changes, turn_s):
    """Delays in ms; of a change that came as something else there is none."""
    delays = []
    for at, smiles in due:
        came = [now for now, to in changes if to == smiles and at <= now < at + turn_s]
        delays += [1000 * (came[0] - at)] if came else []
    return sorted(delays)


class Cost:
    """Of au-transmitter and its children: seconds of a core, and the most memory in MiB."""

    def __init__(self, pid):
        self.cores, self.names = {}, {}
        self.memory = {}
        self.pid = pid

    def look(self):
        children = pathlib.Path(f"/proc/{self.pid}/task/{self.pid}/children").read_text().split()
        for pid in [str(self.pid), *children]:
            try:
                stat = pathlib.Path(f"/proc/{pid}/stat").read_text()
                status = pathlib.Path(f"/proc/{pid}/status").read_text()
            except OSError:
                continue
            fields = stat.rpartition(")")[2].split()
            self.names[pid] = stat[stat.index("(") + 1:stat.rindex(")")]
            self.cores[pid] = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
            peak = re.search(r"VmHWM:\s*(\d+)", status)
            self.memory[pid] = int(peak[1]) / 1024 if peak else self.memory.get(pid, 0)


def run(options, folder):
    fifo = folder / "camera.y4m"
    os.mkfifo(fifo)
    faces = [picture(options.bin, folder, aus) for aus in ("0", SMILE)]
    arguments = ["--voice", "-", "--voice-frame", "20"] if options.voice else []
    due, changes, heard, stop = [], [], [], threading.Event()
    writer = threading.Thread(target=lambda: due.extend(film(fifo, faces, options)))
    writer.start()
    with Transmitter(options.bin, *arguments, f"camera:{fifo}", before=shlex.split(options.before),
                     stdin=subprocess.PIPE if options.voice else subprocess.DEVNULL) as server:
        speaker = threading.Thread(target=speak, args=(server.process.stdin, stop))
        if options.voice:
            speaker.start()
        cost = Cost(server.process.pid)
        with socket.create_connection(("127.0.0.1", server.port)) as client:
            client.sendall(b"{hello v=2 window=0" + (b" voice=opus}" if options.voice else b"}"))
            reader = threading.Thread(target=listen, args=(client, changes, heard))
            reader.start()
            begin = time.monotonic()
            cost.look()
            before = sum(cost.cores.values())
            while writer.is_alive():
                cost.look()
                past = time.monotonic() - begin
                writer.join(0.5)
            stop.set()
            client.shutdown(socket.SHUT_RDWR)
            reader.join()
        if options.voice:
            speaker.join()
    return due, changes, heard, cost, (sum(cost.cores.values()) - before) / past


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=pathlib.Path("build/release/bin"))
    parser.add_argument("--fps", type=int, default=25)
    parser.add_argument("--seconds", type=int, default=20)
    parser.add_argument("--voice", action="store_true")
    parser.add_argument("--before", default="", metavar="COMMAND")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        due, changes, heard, cost, cores = run(options, pathlib.Path(folder))
    delays = matched(due, changes, TURN / options.fps)
    if not delays:
        sys.exit("no change was told")
    if options.voice and not heard:
        sys.exit("no voice came")
    median = statistics.median(delays)
    print(f"{options.fps} pictures of {WIDTH}x{HEIGHT} a second for {options.seconds} s"
          f"{f', with {len(heard)} packets of voice' if options.voice else ''}\npicture to packet: {len(delays)} of "
          f"{len(due)} changes, median {median:.1f} ms, 95 % within "
          f"{delays[int(len(delays) * 0.95)]:.1f} ms, longest {delays[-1]:.1f} ms\n"
          f"{100 * cores:.0f} % of a core; at most "
          + ", ".join(f"{cost.memory[pid]:.0f} MiB in {name}" for pid, name in cost.names.items()))
    return 1 if options.check and median > MOST_MS[options.voice] else 0


if __name__ == "__main__":
    sys.exit(main())
