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

from programs import Transmitter

HELLO = b"{hello v=2 window=0}"


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
    servers = [Transmitter(options.bin, "-", stdin=subprocess.PIPE)]
    clients = [Client(servers[0].address)]
    lines = servers[0].process.stdin
    try:
        for _ in range(options.hops):
            servers.append(Transmitter(options.bin, f"aucast://{servers[-1].address}/live"))
            clients.append(Client(servers[-1].address))
        lines.write("Beg_Stream\n")
        step = 1 / options.rate
        begin = time.perf_counter()
        for number in range(options.keyframes):
            time.sleep(max(0.0, begin + number * step - time.perf_counter()))
            ms = round(step * 1000)
            lines.write(f"1:{20 + number % 80};{ms}@{(number + 1) * ms}\n")
            lines.flush()
        time.sleep(1)
    finally:
        for server in servers:
            server.process.kill()
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
