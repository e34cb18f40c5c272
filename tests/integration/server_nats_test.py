"""au-transmitter over real servers of NATS, on ports and in a folder of their own.

    server_nats_test.py --bin FOLDER --scripts FOLDER [TEST...]

Several at a time, for they mostly wait. Without nats-server it says so and ends with code 77.
"""

import argparse
import base64
import concurrent.futures
import json
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import wave

import nats_users
from server_voice_test import FRAME_MS, Listener, speech_like, write_wav

SKIPPED = 77
AT_A_TIME = 6
BIN = pathlib.Path()
nats_cluster = None


def transmitter():
    return BIN / "au-transmitter"


class RawNats:
    """A client of NATS that shares no code with us: its protocol is lines of text."""

    def __init__(self, server):
        self.socket = socket.create_connection(("127.0.0.1", server.port), 10)
        self.reader = self.socket.makefile("rb")
        self.subscriptions = 0
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
        self.subscriptions += 1
        self.socket.sendall(f"SUB {subject} {self.subscriptions}\r\n".encode())
        self.ping()

    def next(self):
        """The next message: its subject, where an answer goes, its bytes."""
        while line := self.reader.readline():
            if line.startswith(b"MSG "):
                words = line.decode().split()
                reply = words[3] if len(words) == 5 else ""
                return words[1], reply, self.reader.read(int(words[-1]) + 2)[:-2]
        raise AssertionError("the connection to NATS is closed")

    def message(self):
        return self.next()[2]

    def close(self):
        self.reader.close()
        self.socket.close()


def parted(message):
    """A message of an origin [ENGINE.md, Messages of the origin]: its word, its keys, its packets."""
    line, packets = message.decode("ascii").split("\n", 1)
    word, *pairs = line.split()
    return word, dict(pair.split("=", 1) for pair in pairs), re.findall(r"\{[^}]*\}", packets)


class OtherEdge(RawNats):
    """An edge that was written from ENGINE.md alone: joins, and goes on with what follows."""

    def __init__(self, server):
        super().__init__(server)
        self.subscribe("au.talk.p")
        self.subscribe("_INBOX.other")
        self.kept = [self.message()]  # whoever publishes answers
        self.origin, self.seq, self.place, self.packets = self.ask("join", "state")

    def ask(self, question, word):
        """The answer; batches that come meanwhile are kept."""
        self.publish("au.talk.join", question.encode(), "_INBOX.other")
        while True:
            subject, _, message = self.next()
            told, keys, packets = parted(message)
            if subject == "au.talk.p":
                self.kept.append(message)
            elif told == word:
                return keys["origin"], int(keys["seq"]), int(keys["place"]), packets

    def batch(self):
        """The next one after what was joined."""
        while True:
            message = self.kept.pop(0) if self.kept else self.message()
            word, keys, packets = parted(message)
            if word == "batch" and keys["origin"] == self.origin and int(keys["seq"]) > self.seq:
                assert int(keys["seq"]) == self.seq + 1, "a hole"
                self.seq += 1
                return int(keys["place"]), packets


class Origin(RawNats):
    """An origin that was written from ENGINE.md alone. Every keyframe takes 40 ms."""

    def __init__(self, server):
        super().__init__(server)
        self.subscribe("au.talk.join")
        self.seq = self.place = 0
        self.full = ""

    def batch(self, packets, full, sent=True):
        """`full`: the face after its one keyframe."""
        self.seq += 1
        line = f"batch origin=other-program seq={self.seq} place={self.place}"
        self.begin, self.full = self.place, full
        self.place += 40
        if sent:
            self.publish("au.talk.p", f"{line}\n{packets}".encode())

    def question(self):
        _, reply, question = self.next()
        return reply, question.decode()

    def answer(self, reply, word, more, place, packets):
        line = f"{word} origin=other-program seq={self.seq} place={place}{more}"
        self.publish(reply, f"{line}\n{packets}".encode())


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

    def await_more(self, *crowds, more=25, patience=60):
        """Until each of their viewers has got so many keyframes more."""
        enough = [crowd.least() + more for crowd in crowds]
        deadline = time.monotonic() + patience
        while any(crowd.least() < least for crowd, least in zip(crowds, enough)):
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
        self.await_more(viewers, more=50)
        self.assertEqual(viewers.lost(), [0] * 10)
        self.assertEqual(viewers.repeated(), 0)

    def test_packets_are_passed_on_as_they_are(self):
        server = self.nats()
        edge = RawNats(server)
        self.addCleanup(edge.close)
        edge.subscribe("au.talk.p")
        self.origin(server)
        head, packets = edge.message().split(b"\n", 1)
        line = re.fullmatch(rb"batch origin=[0-9a-f]{12} seq=[0-9]+ place=([0-9]+)", head)
        self.assertTrue(line, head)
        first = 1 + int(line[1]) // nats_cluster.KEYFRAME_MS
        lines = self.stream.read_bytes().splitlines()[first:first + packets.count(b"{")]
        self.assertEqual(packets, b"".join(b"{" + text + b"}" for text in lines))

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
        self.await_more(*crowds)
        for server in servers:
            server.kill()
            self.await_more(*crowds, more=50)
            server.start()
            self.await_more(*crowds, more=50)
        for crowd in crowds:
            self.assertEqual(crowd.ended, 0)
            self.assertEqual(crowd.repeated(), 0)

    def test_clients_of_other_edges_lose_nothing(self):
        servers = self.cluster()
        self.origin(*servers)
        edges = [self.edge(*(servers[i:] + servers[:i])) for i in range(3)]
        crowds = [self.view(edge, 20) for edge in edges]
        self.await_more(*crowds)
        servers[2].kill()
        self.await_more(*crowds, more=50)
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
        self.await_more(viewers, more=50)
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
        self.await_more(viewers, more=50)
        self.assertEqual(viewers.lost(), [0] * 5)

    def write_talk(self, seconds):
        """A face of so many seconds with a voice and captions."""
        talk = self.folder / "spoken" / "talk.txt"
        talk.parent.mkdir()
        lines = "".join(f"1:{i % 100 + 1};40\n" for i in range(seconds * 25))
        talk.write_text(f"# title: A talk\nBeg_Stream\n{lines}End_Stream\n")
        write_wav(talk.with_suffix(".wav"), speech_like(seconds))
        talk.with_suffix(".vtt").write_text(
            "WEBVTT\n\n00:00.200 --> 00:01.500\nGood day\n\n00:02.000 --> 00:02.500\nTo all\n")
        return talk

    def test_voice_and_captions_go_along_for_who_comes_late_too(self):
        server = self.nats()
        talk = self.write_talk(3)
        origin = self.start("--loop", "--publish", self.address(server), talk)
        origin.await_said("its voice is there")
        edges = [self.edge(server) for _ in range(2)]
        hello = "{hello v=2 window=0 voice=opus text=1}"
        for port in [origin.port] + [edge.port for edge in edges]:
            with self.subTest(port=port):
                one = Listener(port, hello)
                while len(one.voice) < 60 or len(one.captions) < 4:
                    one.step()
                one.socket.close()
                self.assertEqual(base64.b64decode(one.hello["title"] + "==").decode(), "A talk")
                turn = one.captions[-4:]
                self.assertEqual({text for _, text in turn}, {"Good day", "To all", ""})
                places = [place for place, _ in one.voice]
                steps = {after - before for before, after in zip(places, places[1:])}
                self.assertEqual(steps, {FRAME_MS}, "no packet is missing, at the turn either")
                # A face and what is heard with it: both began at a known place of the file.
                begin = int(re.match(r"1:(\d+);", one.faces[0][1])[1]) * 40 - 40
                caption = next(place for place, text in one.captions if text == "To all")
                self.assertEqual((begin + caption) % 3000, 2000)

    def test_a_player_at_an_edge_hears_the_voice(self):
        if not (BIN / "face-player").exists():
            self.skipTest("face-player is not built")
        server = self.nats()
        edge = self.edge(server)
        sound = self.folder / "heard.wav"
        stats = self.folder / "stats.json"
        player = subprocess.Popen([BIN / "face-player", f"aucast://127.0.0.1:{edge.port}/talk",
                                   "--headless", "--sound", sound, "--stats", stats],
                                  stderr=subprocess.PIPE, text=True)
        self.addCleanup(player.kill)
        origin = self.start("--publish", self.address(server), self.write_talk(4))
        said = player.communicate(timeout=60)[1]
        self.assertEqual(player.returncode, 0, said + origin.said() + edge.said())
        told = json.loads(stats.read_text())
        self.assertGreater(told["voice_packets"], 40, told)
        with wave.open(str(sound)) as heard:
            samples = memoryview(heard.readframes(heard.getnframes())).cast("h")
        self.assertGreater(max(samples), 2000, "speech, no silence")

    def test_another_program_may_follow(self):
        server = self.nats()
        self.origin(server)
        edge = OtherEdge(server)
        self.addCleanup(edge.close)
        self.assertIn(" live=1", edge.packets[0])
        self.assertEqual(len(edge.packets), 2, "a hello and one full keyframe")
        place = edge.place + nats_cluster.KEYFRAME_MS
        for _ in range(50):
            begins, packets = edge.batch()
            if packets:
                self.assertEqual(begins, place)
            for packet in packets:
                place += nats_cluster.KEYFRAME_MS
                self.assertTrue(packet.endswith(f"@{place}}}"), packet)
        missed = edge.seq - 5
        _, seq, begins, packets = edge.ask(f"join origin={edge.origin} after={missed}", "since")
        self.assertGreaterEqual(seq, edge.seq)
        self.assertEqual(len(packets), seq - missed)
        self.assertTrue(packets[0].endswith(f"@{begins + nats_cluster.KEYFRAME_MS}}}"), packets[0])

    def test_another_program_may_publish(self):
        server = self.nats()
        other = Origin(server)
        self.addCleanup(other.close)
        edge = self.edge(server, options=("--upstream-wait", "0.2"))
        other.batch("{12;40}", "{12;40}")
        reply, question = other.question()
        self.assertEqual(question, "join")
        hello = "{hello v=2 stream=talk live=1 delta=1 voice=opus text=1 keyframe=40 origin=other-program}"
        other.answer(reply, "state", "", other.begin, hello + "{t@0 SGk}" + other.full)
        edge.await_said("talk: live, from")
        client = socket.create_connection(("127.0.0.1", edge.port), 20)
        self.addCleanup(client.close)
        client.sendall(b"{hello v=2 window=0 stream=talk delta=1 voice=opus text=1}")
        got = b""

        def await_bytes(end):
            nonlocal got
            while not got.endswith(end):
                part = client.recv(4096)
                self.assertTrue(part, got + edge.said().encode())
                got += part

        await_bytes(b"{12;40}")
        self.assertIn(b" live=1 ", got)
        self.assertIn(b"{t@0 SGk}", got)
        other.batch("{a@40 CP/+}{~1;40}", "{1,12;40}")
        await_bytes(b"{a@40 CP/+}{~1;40}")
        lost = "{~2;40}"
        other.batch(lost, "{1,2,12;40}", sent=False)
        other.batch("{~4;40}", "{1,2,4,12;40}")
        reply, question = other.question()
        self.assertEqual(question, "join origin=other-program after=2")
        other.answer(reply, "since", " after=2", 80, lost + "{~4;40}")
        await_bytes(b"{~2;40}{~4;40}")
        other.batch("{-2}", "{0}")
        await_bytes(b"{-2}")

    def test_a_user_and_a_password_open_nats(self):
        server = self.nats('authorization { user: lecturer, password: "two words, and {" }')
        known = ("--nats-login", nats_users.write_secret(self.folder / "login",
                                                         "lecturer:two words, and {\n"))
        self.origin(server, options=known)
        self.await_more(self.view(self.edge(server, options=known)))
        wrong = nats_users.write_secret(self.folder / "wrong", "lecturer:two words\n")
        self.refused(server, "--nats-login", wrong)

    def refused(self, server, *options):
        stranger = self.edge(server, options=options)
        stranger.await_said("NATS refuses us: Authorization Violation; it is asked again in 4 s")

    def test_nkeys_open_nats_with_the_rights_that_the_document_names(self):
        origin, edge, stranger = (nats_users.NKey(self.folder, "user") for _ in range(3))
        server = self.nats(f"""authorization {{ users: [
          {{ nkey: {origin.public}, permissions: {{
            publish: ["au.talk.p", "_INBOX.>"], subscribe: ["au.talk.join"] }} }}
          {{ nkey: {edge.public}, permissions: {{
            publish: ["au.talk.join"], subscribe: ["au.talk.p", "_INBOX.>"] }} }} ] }}""")

        def options(key, seed=None):
            return "--nats-nkey", key.public, "--nats-seed", (seed or key).seed_file()

        sends = self.origin(server, options=options(origin))
        takes = self.edge(server, options=options(edge))
        viewers = self.view(takes)
        self.await_more(viewers)
        self.assertEqual(viewers.lost(), [0])
        for one in (sends, takes):
            self.assertNotIn("NATS says", one.said(), "nothing was asked for that is not permitted")
        self.refused(server, *options(stranger))
        self.refused(server, *options(edge, stranger))
        # Who may watch may not publish.
        forger = self.origin(server, options=(*options(edge), "--log-format", "json"))
        log = forger.await_said("Permissions Violation")
        told = [json.loads(line) for line in log.splitlines()]
        self.assertTrue(any(line["program"] == "au-transmitter" and line["level"] == "warning" and
                            line["message"].startswith("NATS says: ") for line in told), log)
        self.await_more(viewers)
        self.assertEqual(viewers.lost(), [0])

    def test_a_creds_file_opens_nats(self):
        operator = nats_users.Operator(self.folder)
        server = self.nats(operator.config)
        self.origin(server, options=("--nats-creds", operator.creds()))
        self.await_more(self.view(self.edge(server, options=("--nats-creds", operator.creds()))))
        other = nats_users.NKey(self.folder, "account")
        self.refused(server, "--nats-creds", operator.creds(other))

    def test_nats_over_tls(self):
        authority = nats_users.Authority(self.folder)
        certificate, key = authority.issue("IP:127.0.0.1")
        ours, our_key = authority.issue("DNS:campus")
        config = f'cert_file: "{certificate}", key_file: "{key}"'
        server = self.nats(f'tls {{ {config}, ca_file: "{authority.file}", verify: true }}')
        safe = self.address(server).replace("nats:", "natss:")
        trusting = ("--nats-tls-ca", authority.file)
        known = (*trusting, "--nats-tls-cert", ours, "--nats-tls-key", our_key)
        self.start(*known, "--publish", safe, self.stream)
        self.await_more(self.view(self.start(*known, safe)))
        self.start(safe).await_said("NATS refuses us: SSL handshake error: 20:unable to get local")
        self.start(*trusting, safe).await_said("NATS refuses us: ")
        self.edge(server).await_said("NATS refuses us: ")

    def test_a_server_with_the_certificate_of_another_is_not_believed(self):
        authority = nats_users.Authority(self.folder)
        certificate, key = authority.issue("DNS:hub.example.org")
        server = self.nats(f'tls {{ cert_file: "{certificate}", key_file: "{key}" }}')
        safe = self.address(server).replace("nats:", "natss:")
        edge = self.start("--nats-tls-ca", authority.file, safe)
        edge.await_said("NATS refuses us: SSL handshake error: 64:IP address mismatch")

    def test_a_token_opens_nats(self):
        server = self.nats('authorization { token: "sesame" }')
        token = self.folder / "token"
        token.write_text("sesame\n")
        token.chmod(0o600)
        self.origin(server, options=("--nats-token-file", token))
        edge = self.edge(server, options=("--nats-token-file", token))
        self.await_more(self.view(edge))
        stranger = self.edge(server)
        stranger.await_said("NATS refuses us: Authorization Violation", 2)

    def test_usage_errors_say_what_is_wrong(self):
        secret = nats_users.write_secret(self.folder / "secret", "me:0123456789abcdef\n")
        for arguments, text in (
                (["--publish", "nats://127.0.0.1", self.stream], "it names no stream"),
                (["--publish", "http://a/b", self.stream], "it begins with neither"),
                (["nats://u:p@h/talk"], "is no address of a stream"),
                (["--nats-nkey", "UABC", "nats://127.0.0.1/talk"], "go together"),
                (["--nats-login", secret, "--nats-token-file", secret, "nats://127.0.0.1/talk"],
                 "one of them"),
                (["--nats-login", secret, "nats://example.org/talk"],
                 "could read the password: use natss://")):
            run = subprocess.run([transmitter(), "--port", "0", *arguments], capture_output=True,
                                 text=True, timeout=30)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(text, run.stderr)


def run_one(test):
    result = unittest.TestResult()
    begin = time.monotonic()
    test.run(result)
    wrong = result.errors + result.failures
    state = "FAILED" if wrong else "skipped" if result.skipped else "ok"
    print(f"{time.monotonic() - begin:5.1f} s {state} {test.id()}", flush=True)
    for _, traceback in wrong:
        print(traceback, flush=True)
    return not wrong


def main():
    global BIN, nats_cluster
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    parser.add_argument("--scripts", type=pathlib.Path, required=True)
    parser.add_argument("tests", nargs="*", help="names of some (all)")
    arguments = parser.parse_args()
    BIN = arguments.bin
    sys.path.insert(0, str(arguments.scripts))
    import nats_cluster as module
    nats_cluster = module
    why = nats_cluster.missing()
    if why:
        print(f"NOT RUN: {why}")
        return SKIPPED
    names = arguments.tests or unittest.defaultTestLoader.getTestCaseNames(Nats)
    with concurrent.futures.ThreadPoolExecutor(AT_A_TIME) as pool:
        done = list(pool.map(run_one, map(Nats, names)))
    print(f"{done.count(True)} of {len(done)} passed")
    return 0 if all(done) else 1


if __name__ == "__main__":
    sys.exit(main())
