#!/usr/bin/env python3
"""Measures what relays add to the delay of a live stream, on this host.

    scripts/relay_delay.py [--bin FOLDER] [--hops N] [--keyframes N] [--rate HZ]

Starts au-transmitter with a live source, a chain of relays behind it, and a client of each. Prints for
each relay how much later than the origin's client its client got the same keyframe.
"""

import argparse
import pathlib
import socket
import statistics
import subprocess
import threading
import time

HELLO = b"{hello v=2 window=0}"


def start(arguments, **more):
    """A transmitter on a free port; returns it and its ADDR:PORT."""
    process = subprocess.Popen(arguments + ["--port", "0", "--log-level", "error"],
                               stdout=subprocess.PIPE, text=True, **more)
    line = process.stdout.readline()
    if not line.startswith("listening on "):
        raise SystemExit(f"{arguments[0]} did not start")
    return process, line.split()[-1]


class Client(threading.Thread):
    """Notes when each keyframe comes, by its place."""

    def __init__(self, address):
        super().__init__(daemon=True)
        host, port = address.rsplit(":", 1)
        self.came = {}
        self.socket = socket.create_connection((host, int(port)))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.socket.sendall(HELLO)
        self.rest = b""
        while b"}" not in self.rest:
            self.rest += self.socket.recv(4096)
        if not self.rest.startswith(b"{hello"):
            raise SystemExit(f"{address} answered {self.rest!r}")
        self.start()

    def run(self):
        while chunk := self.socket.recv(4096):
            now = time.perf_counter()
            *packets, self.rest = (self.rest + chunk).split(b"}")
            for packet in packets:
                self.came.setdefault(packet.rpartition(b"@")[2], now)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", default="build/release/bin", type=pathlib.Path)
    parser.add_argument("--hops", default=2, type=int)
    parser.add_argument("--keyframes", default=250, type=int)
    parser.add_argument("--rate", default=25.0, type=float)
    options = parser.parse_args()
    program = str(options.bin / "au-transmitter")
    origin, address = start([program, "-"], stdin=subprocess.PIPE)
    processes, clients = [origin], [Client(address)]
    try:
        for _ in range(options.hops):
            relay, address = start([program, f"aucast://{address}/live"])
            processes.append(relay)
            clients.append(Client(address))
        origin.stdin.write("Beg_Stream\n")
        step = 1 / options.rate
        begin = time.perf_counter()
        for number in range(options.keyframes):
            time.sleep(max(0.0, begin + number * step - time.perf_counter()))
            ms = round(step * 1000)
            origin.stdin.write(f"1:{20 + number % 80};{ms}@{(number + 1) * ms}\n")
            origin.stdin.flush()
        time.sleep(1)
    finally:
        for process in processes:
            process.kill()
    for hop, client in enumerate(clients[1:], 1):
        both = sorted(set(client.came) & set(clients[0].came))
        delays = sorted((client.came[place] - clients[0].came[place]) * 1000 for place in both)
        if not delays:
            raise SystemExit(f"relay {hop}: nothing came")
        print(f"relay {hop}: {len(delays)} keyframes, added delay median "
              f"{statistics.median(delays):.2f} ms, 99 % {delays[int(len(delays) * 0.99)]:.2f} ms, "
              f"most {delays[-1]:.2f} ms")


if __name__ == "__main__":
    main()
