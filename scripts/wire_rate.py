#!/usr/bin/env python3
"""Measures what a stream and its voice take on the wire, headers of TCP and IP included.

    scripts/wire_rate.py [--bin FOLDER] [--seconds S] [--mean KBITS] [--worst KBITS]
                         FILE [OPTION...]

Serves FILE with au-transmitter and the given options of it (--live --rate 25 --batch 180, ...) on
the loopback interface, and plays it with face-player, which hears the voice on a device that nobody
listens to. Every IP packet of the connection is read as it passes (a packet socket, which needs
root or CAP_NET_RAW) and counted with all of its bytes: data, acknowledgements, beginning and end.
Prints for each direction the mean over the time of the stream and the worst second, which may begin
anywhere. --mean and --worst: exit 1 when the way to the player takes more. --seconds: stops after
so long (as long as the stream lasts).
"""

import argparse
import os
import pathlib
import signal
import socket
import struct
import subprocess
import sys
import threading
import time

from programs import Transmitter

ETH_P_IP = 0x0800
PACKET_OUTGOING = 4  # on loopback every packet is seen twice: going out and coming in


class Wire:
    """The IP packets from and to a TCP port."""

    def __init__(self):
        self.packets = []  # (seconds, to_player, bytes, data bytes)
        self.port = None
        self.socket = socket.socket(socket.AF_PACKET, socket.SOCK_DGRAM, socket.htons(ETH_P_IP))
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
        self.socket.bind(("lo", ETH_P_IP))
        self.socket.settimeout(0.2)
        self.stopped = False
        self.thread = threading.Thread(target=self.read)

    def read(self):
        while not self.stopped:
            try:
                packet, address = self.socket.recvfrom(65536)
            except socket.timeout:
                continue
            if address[2] == PACKET_OUTGOING or packet[9] != socket.IPPROTO_TCP:
                continue
            header = (packet[0] & 15) * 4
            source, target = struct.unpack_from("!HH", packet, header)
            if self.port not in (source, target):
                continue
            length = struct.unpack_from("!H", packet, 2)[0]
            data = length - header - (packet[header + 12] >> 4) * 4
            self.packets.append((time.monotonic(), source == self.port, length, data))

    def stop(self):
        self.stopped = True
        self.thread.join()


def worst_second(packets):
    """Its bytes, and when it begins."""
    most = inside = 0
    oldest = 0
    begin = 0.0
    for at, length in packets:
        inside += length
        while at - packets[oldest][0] >= 1:
            inside -= packets[oldest][1]
            oldest += 1
        if inside > most:
            most, begin = inside, packets[oldest][0] - packets[0][0]
    return most, begin


def report(name, packets, seconds):
    """Returns mean and worst second in kbit/s."""
    total = sum(length for _, length, _ in packets)
    empty = sum(length for _, length, data in packets if data == 0)
    mean = total * 8 / 1000 / seconds
    worst, begin = worst_second([(at, length) for at, length, _ in packets])
    worst = worst * 8 / 1000
    data = sum(data for _, _, data in packets) * 8 / 1000 / seconds
    print(f"{name}  {mean:6.1f} kbit/s mean, {worst:6.1f} in the worst second, from {begin:.1f} s "
          f"({data:.1f} without headers, {empty * 8 / 1000 / seconds:.1f} in bare acknowledgements)")
    return mean, worst


def play(options, wire):
    """Returns for how long the stream was played, in seconds."""
    server = Transmitter(options.bin, options.file, *options.options, stderr=None)
    try:
        wire.port = server.port
        wire.thread.start()
        begin = time.monotonic()
        player = subprocess.Popen(
            [options.bin / "face-player", "--headless", f"127.0.0.1:{wire.port}",
             "--sound-device", "default"], env={**os.environ, "ALSOFT_DRIVERS": "null"})
        try:
            player.wait(options.seconds)
        except subprocess.TimeoutExpired:
            player.send_signal(signal.SIGTERM)
            player.wait(10)
        return time.monotonic() - begin
    finally:
        server.stop()
        if wire.thread.is_alive():
            wire.stop()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    root = pathlib.Path(__file__).resolve().parent.parent
    parser.add_argument("--bin", type=pathlib.Path, default=root / "build" / "release" / "bin")
    parser.add_argument("--seconds", type=float)
    parser.add_argument("--mean", type=float, metavar="KBITS")
    parser.add_argument("--worst", type=float, metavar="KBITS")
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("options", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    try:
        wire = Wire()
    except PermissionError:
        sys.exit("packets can be read by root only (CAP_NET_RAW)")
    seconds = play(options, wire)
    mean, worst = report("to the player  ", [p[:1] + p[2:] for p in wire.packets if p[1]], seconds)
    report("from the player", [p[:1] + p[2:] for p in wire.packets if not p[1]], seconds)
    too_much = (options.mean is not None and mean > options.mean) or \
        (options.worst is not None and worst > options.worst)
    return 1 if too_much else 0


if __name__ == "__main__":
    sys.exit(main())
