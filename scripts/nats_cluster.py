"""Servers of NATS, au-transmitters and viewers on loopback, each on a port of its own, for
scripts/cluster_demo and tests/integration/server_nats_test.py. Everything is ended by the process
that was started, never by a name.
"""

import pathlib
import re
import selectors
import shutil
import socket
import subprocess
import threading
import time

import programs

KEYFRAME_MS = 40


def missing():
    """Why nothing of this can run here; None if it can."""
    return None if shutil.which("nats-server") else "nats-server is not installed"


_given = set()  # ports


def free_ports(count):
    """So many, none of them given before. Somebody else may take one before it is used, which start()
    tells."""
    ports = []
    while len(ports) < count:
        with socket.create_server(("127.0.0.1", 0)) as one:
            port = one.getsockname()[1]
            if port not in _given:  # who is given it next comes after it is closed
                _given.add(port)
                ports.append(port)
    return ports


def write_stream(path, keyframes):
    """Keyframes of 40 ms, each with its place, by which a viewer sees what it was not sent."""
    lines = [f"1:{i % 100 + 1},12:{i * 7 % 100 + 1};{KEYFRAME_MS}@{(i + 1) * KEYFRAME_MS}"
             for i in range(keyframes)]
    pathlib.Path(path).write_text("\n".join(["Beg_Stream", *lines, "End_Stream", ""]))


def in_lines(words, each=10):
    """A number or word of each client, for who reads along."""
    rows = ["  ".join(map(str, words[i:i + each])) for i in range(0, len(words), each)]
    return "\n".join("    " + row for row in rows)


class NatsServer:
    """One nats-server with its log in `folder`."""

    def __init__(self, folder, port, cluster_port=None, routes=(), config=""):
        self.port = port
        self.url = f"nats://127.0.0.1:{port}"
        self.log = pathlib.Path(folder) / f"nats-{port}.log"
        self.config = pathlib.Path(folder) / f"nats-{port}.conf"
        lines = [f"listen: 127.0.0.1:{port}", config]
        if cluster_port:
            urls = ", ".join(f"nats-route://127.0.0.1:{route}" for route in routes)
            lines += [f"server_name: hub{port}",
                      f"cluster {{ name: demo, listen: 127.0.0.1:{cluster_port}, routes: [{urls}] }}"]
        self.config.write_text("\n".join(lines) + "\n")
        self.process = None
        self.start()

    def start(self):
        with open(self.log, "a") as log:
            self.process = subprocess.Popen(["nats-server", "-c", self.config], stdout=log, stderr=log)
        deadline = time.monotonic() + 20
        while True:
            try:
                with socket.create_connection(("127.0.0.1", self.port), 1) as probe:
                    if probe.recv(4) == b"INFO":
                        return
            except OSError:
                pass
            if self.process.poll() is not None or time.monotonic() > deadline:
                raise RuntimeError("nats-server did not start: " + self.log.read_text())
            time.sleep(0.05)

    def kill(self):
        """Without a word to anybody."""
        self.process.kill()
        self.process.wait()

    def stop(self):
        if self.process.poll() is None:
            self.process.terminate()
        self.process.wait()


def cluster(folder, count=3):
    """So many servers that know each other."""
    ports = free_ports(2 * count)
    clients, routes = ports[:count], ports[count:]
    servers = [NatsServer(folder, port, route, [other for other in routes if other != route])
               for port, route in zip(clients, routes)]
    deadline = time.monotonic() + 20
    for server in servers:
        while server.log.read_text().count("Route connection created") < count - 1:
            if time.monotonic() > deadline:
                raise RuntimeError("the servers do not find each other: " + server.log.read_text())
            time.sleep(0.05)
    return servers


class Transmitter(programs.Transmitter):
    """au-transmitter with a log that can be read."""

    def __init__(self, binary, folder, name, *arguments):
        self.log = pathlib.Path(folder) / f"{name}.log"
        with open(self.log, "a") as log:
            super().__init__(pathlib.Path(binary).parent, *arguments, stderr=log)

    def said(self):
        return self.log.read_text()

    def await_said(self, text, times=1, patience=30):
        """The log, once it has the text so often."""
        deadline = time.monotonic() + patience
        while True:
            log = self.said()
            if log.count(text) >= times:
                return log
            if time.monotonic() > deadline or self.process.poll() is not None:
                raise AssertionError(f"it never said {text!r}: {log}")
            time.sleep(0.02)


class Viewers:
    """Clients of one transmitter, on a thread: which keyframes each got, and when."""

    PLACE = re.compile(rb"@(\d+)\}")

    def __init__(self, port, count, name="talk"):
        self.port = port
        self.places = [[] for _ in range(count)]
        self.worst_gap = [0.0] * count  # seconds between two keyframes
        self.ended = 0
        self._last = [None] * count
        self._rest = [b""] * count
        self._selector = selectors.DefaultSelector()
        self._sockets = []
        for i in range(count):
            one = socket.create_connection(("127.0.0.1", port), 10)
            one.sendall(b"{hello v=2 window=0 stream=%s}" % name.encode())
            one.setblocking(False)
            self._selector.register(one, selectors.EVENT_READ, i)
            self._sockets.append(one)
        self._stopping = False
        self._thread = threading.Thread(target=self._watch)
        self._thread.start()

    def _watch(self):
        while not self._stopping and self._selector.get_map():
            for key, _ in self._selector.select(0.1):
                self._read(key.fileobj, key.data)

    def _read(self, one, i):
        try:
            data = one.recv(65536)
        except BlockingIOError:
            return
        except OSError:
            data = b""
        if not data or b"{-2}" in data:
            self._selector.unregister(one)
            self.ended += 1
            return
        now = time.monotonic()
        data = self._rest[i] + data
        whole = data.rfind(b"}") + 1
        self._rest[i] = data[whole:]
        found = [int(place) for place in self.PLACE.findall(data[:whole])]
        if found and self._last[i] is not None:
            self.worst_gap[i] = max(self.worst_gap[i], now - self._last[i])
        if found:
            self._last[i] = now
        self.places[i] += found

    def forget_gaps(self):
        self.worst_gap = [0.0] * len(self.worst_gap)

    def least(self):
        """The keyframes of who got the fewest."""
        return min(len(places) for places in self.places)

    def lost(self, since=0):
        """Of each viewer, the keyframes between its first and its last (after that many ms) that it
        was not sent."""
        counts = []
        for places in self.places:
            after = sorted({place for place in places if place > since})
            span = (after[-1] - after[0]) // KEYFRAME_MS + 1 if after else 0
            counts.append(span - len(after))
        return counts

    def repeated(self):
        return sum(len(places) - len(set(places)) for places in self.places)

    def stop(self):
        self._stopping = True
        self._thread.join()
        for one in self._sockets:
            one.close()
