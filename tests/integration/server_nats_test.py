"""au-transmitter over real servers of NATS, on ports and in a folder of their own.

    server_nats_test.py --bin FOLDER --scripts FOLDER

Without nats-server it says so and ends with code 77.
"""

import argparse
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import time
import unittest

SKIPPED = 77
BIN = pathlib.Path()
nats_cluster = None


def transmitter():
    return BIN / "au-transmitter"


class RawNats:
    """A client of NATS that shares no code with us: its protocol is lines of text."""

    def __init__(self, server):
        self.socket = socket.create_connection(("127.0.0.1", server.port), 10)
        self.reader = self.socket.makefile("rb")
        self.reader.readline()
        self.socket.sendall(b'CONNECT {"verbose":false,"pedantic":false}\r\n')
        self.ping()

    def ping(self):
        """What was sent before is done when this returns."""
        self.socket.sendall(b"PING\r\n")
        while self.reader.readline() != b"PONG\r\n":
            pass

    def publish(self, subject, data, reply=""):
        head = f"PUB {subject} {reply + ' ' if reply else ''}{len(data)}\r\n"
        self.socket.sendall(head.encode() + data + b"\r\n")

    def subscribe(self, subject):
        self.socket.sendall(f"SUB {subject} 1\r\n".encode())
        self.ping()

    def message(self):
        while True:
            line = self.reader.readline()
            if line.startswith(b"MSG "):
                return self.reader.read(int(line.split()[-1]) + 2)[:-2]

    def close(self):
        self.reader.close()
        self.socket.close()


class Nats(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.stream = self.folder / "talk.txt"
        nats_cluster.write_stream(self.stream, 5000)
        self.names = 0

    def nats(self, config=""):
        server = nats_cluster.NatsServer(self.folder, nats_cluster.free_ports(1)[0], config=config)
        self.addCleanup(server.stop)
        return server

    def cluster(self):
        servers = nats_cluster.cluster(self.folder)
        for server in servers:
            self.addCleanup(server.stop)
        return servers

    def start(self, *arguments):
        self.names += 1
        one = nats_cluster.Transmitter(transmitter(), self.folder, f"run{self.names}", *arguments)
        self.addCleanup(one.stop)
        return one

    def view(self, edge, count=1):
        viewers = nats_cluster.Viewers(edge.port, count)
        self.addCleanup(viewers.stop)
        return viewers

    def await_more(self, viewers, more=25, patience=60):
        enough = viewers.least() + more
        deadline = time.monotonic() + patience
        while viewers.least() < enough:
            self.assertLess(time.monotonic(), deadline, "nothing comes any more")
            time.sleep(0.02)

    def address(self, *servers, name="talk"):
        return "nats://" + ",".join(f"127.0.0.1:{server.port}" for server in servers) + "/" + name

    def origin(self, *servers, options=()):
        return self.start(*options, "--publish", self.address(*servers), self.stream)

    def edge(self, *servers, options=()):
        return self.start(*options, self.address(*servers))

    def test_an_edge_serves_what_is_published(self):
        server = self.nats()
        self.origin(server)
        edge = self.edge(server)
        viewers = self.view(edge, 10)
        self.await_more(viewers, 50)
        self.assertEqual(viewers.lost(), [0] * 10)
        self.assertEqual(viewers.repeated(), 0)

    def test_packets_are_passed_on_as_they_are(self):
        server = self.nats()
        watcher = RawNats(server)
        self.addCleanup(watcher.close)
        watcher.subscribe("au.talk.p")
        self.origin(server)
        head, packets = watcher.message().split(b"\n", 1)
        line = re.fullmatch(rb"batch origin=[0-9a-f]{12} seq=[0-9]+ place=([0-9]+)", head)
        self.assertTrue(line, head)
        lines = self.stream.read_bytes().splitlines()
        self.assertEqual(packets, b"{" + lines[1 + int(line[1]) // nats_cluster.KEYFRAME_MS] + b"}")

    def test_who_comes_before_the_origin_waits(self):
        server = self.nats()
        edge = self.edge(server)
        viewers = self.view(edge)
        self.origin(server)
        self.await_more(viewers)

    def test_who_comes_before_the_engine_waits_too(self):
        port = nats_cluster.free_ports(1)[0]
        address = f"nats://127.0.0.1:{port}/talk"
        edge = self.start(address)
        self.start("--publish", address, self.stream)
        edge.await_said("no server of NATS answers yet")
        server = nats_cluster.NatsServer(self.folder, port)
        self.addCleanup(server.stop)
        self.await_more(self.view(edge))

    def test_any_server_may_die(self):
        servers = self.cluster()
        self.origin(*servers)
        edges = [self.edge(*(servers[i:] + servers[:i])) for i in range(3)]
        crowds = [self.view(edge, 20) for edge in edges]
        for crowd in crowds:
            self.await_more(crowd)
        for server in servers:
            server.kill()
            for crowd in crowds:
                self.await_more(crowd, 50)
            server.start()
            for crowd in crowds:
                self.await_more(crowd, 50)
        for crowd in crowds:
            self.assertEqual(crowd.ended, 0)
            self.assertEqual(crowd.repeated(), 0)

    def test_clients_of_other_edges_lose_nothing(self):
        servers = self.cluster()
        self.origin(*servers)
        edges = [self.edge(*(servers[i:] + servers[:i])) for i in range(3)]
        crowds = [self.view(edge, 20) for edge in edges]
        for crowd in crowds:
            self.await_more(crowd)
        servers[2].kill()
        for crowd in crowds:
            self.await_more(crowd, 50)
        for crowd in crowds[:2]:
            self.assertEqual(crowd.lost(), [0] * 20)

    def test_the_first_of_two_origins_is_kept(self):
        server = self.nats()
        first = self.origin(server)
        edge = self.edge(server)
        viewers = self.view(edge)
        self.await_more(viewers)
        second = self.origin(server)
        edge.await_said("sends it too and is left out")
        self.await_more(viewers)
        self.assertEqual(viewers.lost(), [0])
        first.stop()
        self.await_more(viewers)
        self.assertEqual(viewers.ended, 0)
        self.assertIsNone(second.process.poll())

    def test_garbage_costs_a_line_in_the_log(self):
        server = self.nats()
        self.origin(server)
        edge = self.edge(server)
        viewers = self.view(edge)
        self.await_more(viewers)
        mallory = RawNats(server)
        self.addCleanup(mallory.close)
        for junk in (b"", b"\n", b"\x00\xff" * 1000, b"x" * 900_000, b"batch origin=a seq=1 place=0\n{",
                     b"batch origin=evil seq=1 place=0\n{-2}", b"state origin=evil seq=9 place=0\n{hello}"):
            for subject in ("au.talk.p", "au.talk.join"):
                mallory.publish(subject, junk)
                mallory.publish(subject, junk, "somewhere")
        for i in range(5000):
            mallory.publish("au.talk.p", b"garbage %d" % i)
        mallory.ping()
        self.await_more(viewers, 50)
        self.assertEqual(viewers.ended, 0)
        self.assertEqual(viewers.lost(), [0])
        log = edge.await_said("a message on the subject is no batch")
        self.assertLess(len(log.splitlines()), 15, log)

    def test_who_forges_the_origin_is_left_and_the_true_one_joined(self):
        server = self.nats()
        self.origin(server)
        edge = self.edge(server)
        viewers = self.view(edge)
        self.await_more(viewers)
        spy = RawNats(server)
        self.addCleanup(spy.close)
        spy.subscribe("au.talk.p")
        head = spy.message().split(b"\n")[0]
        seq = int(head.split(b"seq=")[1].split()[0])
        for packets in (b"{garbage}", b"{12:400}", b"{-2}", b"{hello v=2}", b"{12}" * 3000):
            seq += 3
            for number in range(seq, seq + 40):
                forged = head.replace(head.split()[2], b"seq=%d" % number)
                spy.publish("au.talk.p", forged + b"\n" + packets)
            self.await_more(viewers)
        self.assertEqual(viewers.ended, 0)

    def test_a_stream_that_would_come_back_is_not_followed(self):
        server = self.nats()
        loop = self.start("--publish", self.address(server), self.address(server))
        self.origin(server)
        loop.await_said("talk: live, from")
        viewers = self.view(loop)
        self.await_more(viewers)

    def test_a_campus_watches_at_its_leaf_node(self):
        port = nats_cluster.free_ports(1)[0]
        hub = self.nats(f"leafnodes {{ listen: 127.0.0.1:{port} }}")
        leaf = self.nats(f'leafnodes {{ remotes: [ {{ urls: ["nats-leaf://127.0.0.1:{port}"] }} ] }}')
        self.origin(hub)
        viewers = self.view(self.edge(leaf), 5)
        self.await_more(viewers, 50)
        self.assertEqual(viewers.lost(), [0] * 5)

    def test_a_token_opens_nats(self):
        server = self.nats('authorization { token: "sesame" }')
        token = self.folder / "token"
        token.write_text("sesame\n")
        token.chmod(0o600)
        self.origin(server, options=("--nats-token-file", token))
        edge = self.edge(server, options=("--nats-token-file", token))
        self.await_more(self.view(edge))
        stranger = self.edge(server)
        stranger.await_said("no server of NATS answers yet")
        stranger.await_said("NATS refuses us", 2)

    def test_usage_errors_say_what_is_wrong(self):
        for arguments, text in (
                (["--publish", "nats://127.0.0.1", self.stream], "it names no stream"),
                (["--publish", "http://a/b", self.stream], "it begins with neither"),
                (["nats://u:p@h/talk"], "is no address of a stream"),
                (["--nats-nkey", "UABC", "nats://127.0.0.1/talk"], "go together")):
            run = subprocess.run([transmitter(), "--port", "0", *arguments], capture_output=True,
                                 text=True, timeout=30)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(text, run.stderr)


def main():
    global BIN, nats_cluster
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    parser.add_argument("--scripts", type=pathlib.Path, required=True)
    arguments, rest = parser.parse_known_args()
    BIN = arguments.bin
    sys.path.insert(0, str(arguments.scripts))
    import nats_cluster as module
    nats_cluster = module
    why = nats_cluster.missing()
    if why:
        print(f"NOT RUN: {why}")
        return SKIPPED
    unittest.main(argv=[sys.argv[0], *rest])
    return 0


if __name__ == "__main__":
    sys.exit(main())
