#!/usr/bin/env python3
"""Holds both programs against a peer written from protocol/PROTOCOL.md alone (independent_peer.py).

    tests/integration/independent_peer_test.py --bin FOLDER [NAME...]
"""

import argparse
import contextlib
import json
import os
import pathlib
import pty
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from independent_peer import (Client, END, Error, Hello, Keyframe, Server, Streams, Violation,
                              changed, full, publish, read_stream_file, refusal)

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import programs  # of scripts/

BIN = pathlib.Path()
DATA = pathlib.Path(__file__).parents[2] / "data"
LETTERS = {10: "A", 25: "B", 50: "C", 80: "D", 100: "E"}


def bounded(terms, timing):
    """Whether the numbers are within their limits [2]; the terms have the form."""
    percents = [int(term.partition(":")[2] or 0) for term in terms]
    duration, _, place = timing.partition("@")
    return max(percents) <= 100 and int(duration or 0) <= 3600000 and int(place or 0) <= 1000000000000


def faces(count):
    """States that differ in sides, intensities and what is there at all."""
    states = []
    for n in range(count):
        state = {(number, side): percent for number, side, percent in (
            (1, "L", n * 7 % 101), (1, "R", n * 7 % 101), (6, "L", 100), (6, "R", 100),
            (12, "L", n * 3 % 101), (12, "R", n * 11 % 101), (26, "L", (10, 25, 50, 80, 100)[n % 5]),
            (26, "R", (10, 25, 50, 80, 100)[n % 5]), (51, "L", n % 4 // 3 * 40),
            (51, "R", n % 4 // 3 * 40)) if percent and n % 9}
        states.append(state)
    return states


def stream_file(folder, name, states, durations):
    """A stream file in a person's way of writing: sides apart, letters where there is one."""
    lines = ["Beg_Stream"]
    for state, duration in zip(states, durations):
        words = []
        for (number, side), percent in sorted(state.items()):
            letter = LETTERS.get(percent)
            words.append(f"{side}{number}{letter}" if letter else f"{side}{number}:{percent}")
        lines.append((" + ".join(words) or "0") + (f" ; {duration}" if duration else ""))
    path = folder / f"{name}.txt"
    path.write_text("\r\n".join([*lines, "End_Stream"]) + "\r\n", encoding="ascii")
    return path


def classic_form(state, minimum=20):
    """What a classic client gets of it: numbers whose larger side is at least the minimum."""
    numbers = sorted({number for (number, _), percent in state.items() if percent >= minimum})
    return "{" + (",".join(map(str, numbers)) or "0") + "}"


def states_of(keyframes, start=None):
    states, state = [], dict(start or {})
    for keyframe in keyframes:
        state = keyframe.applied_to(state)
        states.append(state)
    return states


class Transmitter(programs.Transmitter):
    """The program under test as a server."""

    def __init__(self, *arguments):
        super().__init__(BIN, *arguments, stderr=subprocess.PIPE)
        self.log = ""

    def __exit__(self, *_):
        self.process.terminate()
        _, self.log = self.process.communicate(timeout=10)
        if self.process.returncode != 0:
            raise Violation(f"au-transmitter ended with {self.process.returncode}: {self.log}")


class Player:
    """The program under test as a client, without a window."""

    def __init__(self, folder, port, *arguments):
        self.stats = folder / "stats.json"
        self.stats.unlink(missing_ok=True)
        self.process = subprocess.Popen(
            (BIN / "face-player", "--headless", f"127.0.0.1:{port}", "--fast", "--stats", self.stats,
             *arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()

    def end(self):
        """Exit code, statistics, and what was said."""
        _, said = self.process.communicate(timeout=30)
        return self.process.returncode, json.loads(self.stats.read_text(encoding="utf-8")), said


class PeerTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)

    def stream(self, count=20, name="lively", duration=40):
        states = faces(count)
        return stream_file(self.folder, name, states, [duration] * count), states

    def told_apart(self, count, duration):
        """A stream of up to 100 states no two of which are the same: one says where it is."""
        states = [{(1, "L"): n + 1, (1, "R"): n + 1, (12, "L"): 100 - n} for n in range(count)]
        return stream_file(self.folder, "told_apart", states, [duration] * count), states


class OurClient(PeerTest):
    """au-transmitter against the Python client."""

    def test_classic(self):
        path, states = self.stream()
        with Transmitter(path) as server, Client(server.port) as client:
            keyframes = client.rest()
        self.assertTrue(all(keyframe.plain() for keyframe in keyframes))
        self.assertEqual([keyframe.text for keyframe in keyframes],
                         [classic_form(state) for state in states])

    def test_classic_is_stop_and_wait(self):
        path, _ = self.stream(4)
        with Transmitter(path) as server, Client(server.port) as client:
            client.packet()
            self.assertTrue(client.is_quiet())
            client.send("-")
            self.assertTrue(client.is_quiet())
            client.send("1")  # it is a pause now
            self.assertTrue(client.is_quiet())
            client.send("-3")
            client.packet()
            client.send(" \r\n1")
            client.packet()
            self.assertTrue(client.is_quiet())
            client.send("1")
            self.assertEqual(len(client.rest()), 1)

    def test_classic_paused_at_the_end(self):
        path, _ = self.stream(1)
        with Transmitter(path) as server, Client(server.port) as client:
            client.packet()
            client.send("-1")
            self.assertTrue(client.is_quiet())
            client.send("-3")
            self.assertEqual(client.rest(), [])

    def test_early_answers(self):
        path, states = self.stream(6)
        with Transmitter(path) as server, Client(server.port) as client:
            client.send("1111111")
            client.shut()  # a half-close is not the end: the banked answers are used up
            self.assertEqual(len(client.rest(answer="")), len(states))

    def test_too_few_early_answers(self):
        path, _ = self.stream(6)
        with Transmitter(path) as server, Client(server.port) as client:
            client.send("111")
            client.shut()
            self.assertEqual(len(client.packets(4)), 4)
            self.assertIsNone(client.packet())

    def test_stop(self):
        path, _ = self.stream(6)
        for before, hello in (("", None), ("1", None), ("", "{hello window=1}"), ("1-1", "{hello}")):
            with Transmitter(path) as server, Client(server.port, hello) as client:
                if hello:
                    self.assertIsInstance(client.packet(), Hello)
                if before or hello:
                    client.send(before)
                    client.packets(1 + before.count("1") - before.count("-1"))
                client.send("-4")
                self.assertEqual(client.packet(), END)
                client.expect_end()

    def test_level_two(self):
        path, states = self.stream()
        with Transmitter(path) as server, Client(server.port, "{hello v=2 window=3}") as client:
            fields = client.packet().fields
            self.assertEqual((fields["v"], fields["window"], fields["stream"], fields["duration"]),
                             ("2", "3", "lively", "800"))
            self.assertEqual(fields.get("delta", "0"), "0")
            keyframes = client.packets(3)
            self.assertTrue(client.is_quiet())
            client.send("1")
            keyframes += client.packets(1)
            self.assertTrue(client.is_quiet())
            client.send("11")
            keyframes += client.packets(2)
            client.send("-1" + "111")  # paused: answers count, nothing comes
            self.assertTrue(client.is_quiet())
            client.send("-3")
            keyframes += client.rest()
        self.assertFalse(any(keyframe.changes for keyframe in keyframes))
        timings = [f";{keyframe.time_ms}" + ("" if keyframe.place is None else f"@{keyframe.place}")
                   for keyframe in keyframes]
        self.assertEqual([keyframe.text for keyframe in keyframes],
                         [full(state, timing) for state, timing in zip(states, timings)])
        self.assertEqual({keyframe.time_ms for keyframe in keyframes}, {40})

    def test_untimed_goes_out_untimed(self):
        path, _ = self.stream(4, duration=0)
        with Transmitter(path, "--keyframe", "300") as server, \
                Client(server.port, "{hello}") as client:
            self.assertEqual(client.packet().fields["keyframe"], "300")
            self.assertEqual({keyframe.time_ms for keyframe in client.rest()}, {None})

    def test_hello_in_single_bytes(self):
        path, states = self.stream(5)
        hello = " \n{hello v=2  window=2 colour=green stream=lively }"
        with Transmitter(path) as server, Client(server.port, hello, one_by_one=True) as client:
            self.assertEqual(client.packet().fields["window"], "2")
            self.assertEqual(states_of(client.rest()), states)

    def test_hello_with_codes_behind_it(self):
        path, states = self.stream(5)
        with Transmitter(path) as server, Client(server.port, "{hello window=9}11-1-3111") as client:
            self.assertIsInstance(client.packet(), Hello)
            self.assertEqual(states_of(client.rest(answer="")), states)

    def test_hello_too_late(self):
        path, states = self.stream(5)
        with Transmitter(path) as server, Client(server.port) as client:
            first = client.packet()
            client.send("{hello v=2 window=7}")
            self.assertTrue(client.is_quiet())
            client.send("1")
            self.assertEqual([first.text] + [keyframe.text for keyframe in client.rest()],
                             [classic_form(state) for state in states])

    def test_window_defaults_and_bounds(self):
        path, _ = self.stream(5)
        with Transmitter(path) as server:
            for asked, granted in (("", 1), (" window=1000", 256), (" window=0", 1)):
                with Client(server.port, "{hello" + asked + "}") as client:
                    self.assertEqual(int(client.packet().fields.get("window", 1)), granted, asked)

    def test_changes_only(self):
        path, states = self.stream(300, duration=100)
        with Transmitter(path) as server, \
                Client(server.port, "{hello window=8 delta=1}") as client:
            self.assertEqual(client.packet().fields["delta"], "1")
            keyframes = client.rest()
        self.assertEqual(states_of(keyframes), states)
        self.assertFalse(keyframes[0].changes)
        self.assertGreater(sum(keyframe.changes for keyframe in keyframes), 150)
        since = 0
        for keyframe in keyframes:
            since = since + keyframe.time_ms if keyframe.changes else 0
            self.assertLessEqual(since, 10000)

    def test_from(self):
        path, states = self.stream(50, duration=100)
        with Transmitter(path) as server:
            for asked, first in ((0, 0), (99, 0), (100, 1), (1234, 12), (1300, 13), (99999, 50)):
                with Client(server.port, f"{{hello window=4 delta=1 from={asked}}}") as client:
                    begins = int(client.packet().fields.get("from", 0))
                    self.assertEqual(begins, 100 * first)
                    keyframes = client.rest()
                self.assertEqual(states_of(keyframes), states[first:])
                self.assertTrue(not keyframes or keyframes[0].time_ms == 100)
                self.assertTrue(not keyframes or not keyframes[0].changes)

    def test_from_in_a_loop(self):
        path, states = self.stream(10, duration=100)
        with Transmitter("--loop", path) as server, \
                Client(server.port, "{hello window=4 from=2350}") as client:
            self.assertEqual(client.packet().fields["from"], "300")
            self.assertEqual(states_of(client.packets(4)), states[3:7])

    def test_streams(self):
        first, _ = self.stream(3)
        second = stream_file(self.folder, "second.v2", faces(2), [500, 500])
        with Transmitter(first, second) as server:
            with Client(server.port, "{streams}") as client:
                packet = client.packet()
                self.assertIsInstance(packet, Streams)
                self.assertEqual(packet.names, ["lively", "second.v2"])
                client.expect_end()
            with Client(server.port, "{hello stream=second.v2}") as client:
                self.assertEqual(client.packet().fields["stream"], "second.v2")
                self.assertEqual(len(client.rest()), 2)

    def test_streams_with_details(self):
        first, _ = self.stream(3, duration=40)
        second = stream_file(self.folder, "second.v2", faces(2), [500, 500])
        second.write_text("# title: Zwei Köpfe\n" + second.read_text(encoding="utf-8"),
                          encoding="utf-8")
        for options, known in (((), [{"live": 0, "duration": 120},
                                     {"live": 0, "duration": 1000, "title": "Zwei Köpfe"}]),
                               (("--loop",), [{"live": 0}, {"live": 0, "title": "Zwei Köpfe"}]),
                               (("--live", "--loop"), [{"live": 1},
                                                       {"live": 1, "title": "Zwei Köpfe"}])):
            with Transmitter(*options, first, second) as server:
                with Client(server.port, "{streams colour=green details=1}") as client:
                    packet = client.packet()
                    self.assertEqual(packet.names, ["lively", "second.v2"])
                    self.assertEqual(list(packet.details.values()), known)
                    client.expect_end()
                with Client(server.port, "{streams}") as client:
                    while client.more():
                        pass
                    self.assertEqual(client.pending, b"{streams lively second.v2}")

    def test_a_relay_passes_on_what_it_knows_of_a_stream(self):
        path, _ = self.stream(3, duration=40)
        path.write_text("# title: A face\n" + path.read_text(encoding="ascii"), encoding="ascii")
        with Transmitter(path) as parent:
            with Transmitter(f"aucast://127.0.0.1:{parent.port}") as relay:
                with Client(relay.port, "{hello}") as client:  # waits for the stream
                    self.assertEqual(client.packet().fields["stream"], "lively")
                    client.rest()
                with Client(relay.port, "{streams details=1}") as client:
                    self.assertEqual(client.packet().details,
                                     {"lively": {"live": 0, "duration": 120, "title": "A face"}})

    def test_more_streams_than_a_packet_lists(self):
        names = [f"a_rather_long_name_of_a_stream_{n:03}" for n in range(200)]
        for name in names:
            stream_file(self.folder, name, faces(1), [40])
        with Transmitter(self.folder) as server:
            with Client(server.port, "{streams}") as client:
                listed = client.packet().names
                self.assertEqual(listed, names[:(4096 - len("{streams}")) // (1 + len(names[0]))])
                client.expect_end()
            with Client(server.port, f"{{hello stream={names[-1]}}}") as client:
                self.assertEqual(client.packet().fields["stream"], names[-1])
        self.assertIn(f"cut after '{listed[-1]}'", server.log)

    def expect_error(self, server, code, hello, before=0.0):
        with Client(server.port, hello[:4]) as client:
            time.sleep(before)
            client.send(hello[4:])
            packet = client.packet()
            self.assertIsInstance(packet, Error, hello)
            self.assertEqual(packet.code, code, hello)
            self.assertTrue(packet.text)
            client.expect_end()

    def test_errors(self):
        path, _ = self.stream(3)
        with Transmitter(path) as server:
            self.expect_error(server, 404, "{hello stream=other}")
            self.expect_error(server, 505, "{hello v=3 window=many stream=../x}")
            for hello in ("{hello window=-1}", "{hello window}", "{hallo}", "{hello stream=../x}",
                          "{hello x={}", "{hello delta=2}", "{hello " + "x=y " * 130 + "}",
                          "{hello from=1000000000001}", "{1,6}"):
                self.expect_error(server, 400, hello)
            self.expect_error(server, 505, "{hello window=many v=3}")
            with Client(server.port, "{hello v=2") as client:  # never completed
                packet = client.packet(8)
                self.assertEqual(packet.code, 400)
            with Client(server.port, "{hello v=2") as client:  # ends in the middle
                client.shut()
                self.assertIsNone(client.packet())

    def test_every_reason_to_refuse_and_its_order(self):
        """Hellos of good and bad fields in any order, against what the page says of them."""
        path, _ = self.stream(1)
        pieces = ("v=2", "v=3", "v=x", "v=0002", "v=1000000", "window=0000000000004", "window=x",
                  "window=00000000000004", "stream=lively", "stream=other", "stream=", "delta=1",
                  "delta=2", "token=sesame", "token=", "token=" + "x" * 256, "token=" + "x" * 257,
                  "from=1000000000000", "from=1000000000001", "colour=green", "colour=", "bare", "=1")
        chosen = random.Random(4650)
        for token in ("", "sesame"):
            options = []
            if token:
                (self.folder / "token").write_text(token, encoding="ascii")
                (self.folder / "token").chmod(0o600)
                options = ["--token-file", self.folder / "token"]
            with Transmitter("--max-clients", "1", *options, path) as server:
                grant = " token=sesame" if token else ""
                for full_up in (False, True):
                    with contextlib.ExitStack() as stack:
                        if full_up:
                            first = stack.enter_context(Client(server.port, "{hello" + grant + "}"))
                            self.assertIsInstance(first.packet(), Hello)
                        for _ in range(60):
                            word = chosen.choice(("hello", "hello", "hello", "streams"))
                            fields = "".join(" " + piece for piece in
                                             chosen.choices(pieces, k=chosen.randint(0, 3)))
                            code = refusal(word, fields, token, ("lively",), full_up)
                            if code:
                                self.expect_error(server, code, "{" + word + fields + "}")
                                continue
                            with Client(server.port, "{" + word + fields + "}") as client:
                                packet = client.packet()
                                self.assertIsInstance(
                                    packet, Hello if word == "hello" else Streams, fields)
                                if word == "hello":
                                    client.rest()

    def test_a_late_hello_may_take_its_time(self):
        path, states = self.stream(3)
        with Transmitter(path) as server, Client(server.port) as client:
            client.packet()
            client.send("{hel")
            self.assertTrue(client.is_quiet(5.5))
            client.send("lo v=2}1")
            self.assertEqual(client.packet().text, classic_form(states[1]))
            client.send("1")
            self.assertEqual(len(client.rest()), 1)

    def test_a_blank_may_stand_before_a_letter(self):
        """What a receiver must accept, though no sender writes it."""
        path = self.folder / "blanks.txt"
        path.write_text("Beg_Stream\n{ L 12 C , 4 : 050 ; 40 @ 0 }\n12C+6B\nEnd_Stream", encoding="ascii")
        self.assertEqual(read_stream_file(path.read_bytes()),
                         [(["L12C", "4:050"], "40@0"), (["12C", "6B"], "")])
        with Transmitter(path) as server, Client(server.port, "{hello}") as client:
            client.packet()
            self.assertEqual([keyframe.text for keyframe in client.rest()],
                             ["{4:50,L12:50;40@0}", "{6:25,12:50}"])

    def test_stream_files_by_the_page(self):
        """Good and bad files: the page and the program agree on which is which."""
        files = [path.read_bytes() for path in sorted((DATA / "streams").glob("**/*.txt"))]
        around = b"Beg_Stream\n%s\nEnd_Stream\n"
        files += [around % line for line in (
            b"1", b"{1}", b"{1", b"1}", b"{1} 2", b"1 2", b"~1", b"1;40", b"1;40@0", b"1;@0", b"L12C+R4",
            b"L 12 C", b"12:C", b"1,,2", b"1\x00", b"1\t#\xc3\xa9", b"1\xc3", b"1;40@5\n1;40@4", b"", b"#",
            b"1\r", b"1\r\n2", b"Beg_Stream", b"End_Stream", b"1" + b" " * 65535, b"1" + b" " * 65536,
            b"{}", b"{ 1 } # one", b"12 : 40 ; 7 @ 7", b"1 0", b"-2")]
        files += [b"\xef\xbb\xbf" + around % b"1", b"# x\n\n" + around % b"1" + b"# y", b"", b"Beg_Stream\n1",
                  around % b"1" + b"1", b"1\n" + around % b"1", b"End_Stream", (around % b"1")[:-1]]
        for data in files:
            path = self.folder / "file.txt"
            path.write_bytes(data)
            said = subprocess.run((BIN / "au-transmitter", "--check", path), capture_output=True,
                                  check=False, text=True, errors="replace")
            try:
                good = all(bounded(terms, timing) for terms, timing in read_stream_file(data))
            except (Violation, UnicodeDecodeError):
                good = False
            self.assertEqual(said.returncode, 0 if good else 3, (data[:200], said.stdout, said.stderr))

    def test_token(self):
        path, states = self.stream(3)
        token = self.folder / "token"
        token.write_text("sesame\n", encoding="ascii")
        token.chmod(0o600)
        with Transmitter("--token-file", token, path) as server:
            for hello in ("{hello}", "{hello token=sesam}", "{hello token=sesames stream=other}",
                          "{streams}", "{streams token=x}"):
                self.expect_error(server, 401, hello)
            self.expect_error(server, 505, "{hello v=3 stream=other}")
            for word in ("{hello token=", "{streams token="):
                self.expect_error(server, 400, word + "x" * 257 + "}")
            with Client(server.port, "-4") as client:
                self.assertEqual(client.packet(), END)
                client.expect_end()
            with Client(server.port, "GET /") as client:
                self.assertIsNone(client.packet())
            with Client(server.port) as client:  # classic
                self.assertEqual(client.packet(8).code, 401)
            with Client(server.port, "{streams token=sesame}") as client:
                self.assertEqual(client.packet().names, ["lively"])
            with Client(server.port, "{hello token=sesame}") as client:
                self.assertIsInstance(client.packet(), Hello)
                self.assertEqual(states_of(client.rest()), states)

    def test_full(self):
        path, _ = self.stream(3)
        with Transmitter("--max-clients", "1", path) as server, \
                Client(server.port, "{hello}") as first:
            self.assertIsInstance(first.packet(), Hello)
            self.expect_error(server, 503, "{hello}")
            self.expect_error(server, 400, "{hello window=x}")
            self.expect_error(server, 505, "{hello v=3}")
            self.expect_error(server, 404, "{hello stream=other}")
            with Client(server.port, "{streams}") as asking:
                self.assertEqual(asking.packet().names, ["lively"])
                asking.expect_end()
            with Client(server.port) as classic:
                self.assertIsNone(classic.packet())
            self.assertEqual(len(first.rest()), 3)

    def test_garbage(self):
        """Each is closed, and a client beside them sees nothing."""
        path, states = self.stream(8)
        with Transmitter(path) as server, Client(server.port, "{hello window=1}") as beside:
            beside.packet()
            for garbage in ("12", "-2", "1{hello}", "GET / HTTP/1.1\r\n\r\n", "1" * 5000,
                            "1" + " " * 1025, "1-1" + "-1" * 5000):
                with Client(server.port) as client:
                    client.send(garbage)
                    packets = 0
                    while (packet := client.packet()) is not None and packet != END:
                        packets += 1
                    self.assertLessEqual(packets, 8, garbage)
            self.assertEqual(states_of(beside.rest()), states)

    def test_live(self):
        path, states = self.told_apart(20, duration=50)
        with Transmitter("--live", "--loop", path) as server, \
                Client(server.port, "{hello window=64 delta=1}") as client:
            fields = client.packet().fields
            self.assertEqual(fields["live"], "1")
            self.assertLessEqual(int(fields["window"]), 40)  # 2 s of keyframes of 50 ms
            first = client.packet()
            self.assertFalse(first.changes)
            keyframes = [first]
            while len(keyframes) < 30:
                client.send("1")
                keyframes.append(client.packet())
            got = states_of(keyframes)
            at = states.index(got[0])
            self.assertEqual(got, [states[(at + n) % 20] for n in range(30)])

    def test_a_live_window_is_worth_two_seconds_at_most(self):
        for durations, window in (([999] * 4, 2), ([1000] * 4, 2), ([667] * 3, 2), ([666] * 3, 3),
                                  ([100, 1900], 2), ([10, 10, 10, 370], 20), ([3000], 2)):
            states = [{(1, "L"): n + 1, (1, "R"): n + 1} for n in range(len(durations))]
            path = stream_file(self.folder, "uneven", states, durations)
            with Transmitter("--live", "--loop", path) as server:
                for asked in (1, 2, 256):
                    with Client(server.port, f"{{hello window={asked}}}") as client:
                        granted = int(client.packet().fields["window"])
                        self.assertEqual(granted, min(asked, window), durations)

    def test_live_late_joiner_and_pause(self):
        path, states = self.told_apart(100, duration=100)
        with Transmitter("--live", path) as server:
            time.sleep(1.05)
            with Client(server.port, "{hello window=64 delta=1}") as client:
                client.packet()
                at = states.index(client.packet().applied_to({}))
                self.assertGreater(at, 7)
                client.send("1-1")
                self.assertTrue(client.is_quiet(0.65))
                client.send("-3")
                later = client.packet()
                self.assertFalse(later.changes)
                self.assertGreaterEqual(states.index(later.applied_to({})), at + 5)

    def test_live_without_answers(self):
        path, states = self.stream(60, duration=50)
        with Transmitter("--live", path) as server, \
                Client(server.port, "{hello window=0 delta=1}") as client:
            self.assertEqual(client.packet().fields["window"], "0")
            keyframes = client.rest(answer="")
        self.assertEqual(states_of(keyframes), states[-len(keyframes):])
        self.assertGreater(len(keyframes), 10)

    def test_live_classic(self):
        path, states = self.stream(60, duration=50)
        with Transmitter("--live", path) as server, Client(server.port) as client:
            first = client.packet()
            time.sleep(0.5)
            client.send("1")
            second = client.packet()
            self.assertTrue(first.plain() and second.plain())
            forms = [classic_form(state) for state in states]
            self.assertIn(first.text, forms)
            self.assertIn(second.text, forms)
            client.send("1")
            self.assertLess(len(client.rest()), 58)

    def test_the_server_stops(self):
        path, _ = self.stream(5)
        server = Transmitter(path)
        with Client(server.port, "{hello}") as client:
            client.packets(2)
            server.process.terminate()
            self.assertEqual(client.packet(), END)
            client.expect_end()
            server.__exit__()


class Publishing(PeerTest):
    """au-transmitter that brings a stream to the Python server, and that is brought one [15]."""

    def setUp(self):
        super().setUp()
        self.token = self.folder / "token"
        self.token.write_text("open-sesame-please", encoding="ascii")
        self.token.chmod(0o600)

    def test_a_stream_is_brought(self):
        path, states = self.stream()
        with Server() as campus, Transmitter("--push", f"aucast://127.0.0.1:{campus.port}/talk",
                                             "--push-token-file", self.token, path):
            with campus.accept() as connection:
                word, fields = connection.hello()
                self.assertEqual((word, fields["publish"], fields["token"]),
                                 ("hello", "talk", "open-sesame-please"))
                self.assertRegex(fields["relay"], r"^[\w.-]{1,16}$")
                client = Client.that_takes(
                    connection, "{hello v=2 window=4 stream=talk relay=campus takes=1}")
                fields = client.packet().fields
                self.assertEqual((fields["stream"], fields["window"], fields["duration"]),
                                 ("talk", "4", "800"))
                self.assertNotIn("campus", fields["origin"].split(","))
                keyframes = client.rest()
        self.assertEqual(len(keyframes), len(states))

    def test_a_publisher_that_is_refused_comes_again(self):
        path, _ = self.stream()
        with Server() as campus, Transmitter("--push", f"aucast://127.0.0.1:{campus.port}/talk",
                                             path):
            for answer in ("{error 409 another publisher sends it}", "{hello v=2 stream=x}",
                           "{1,6}", "HTTP/1.1 400\r\n"):
                with campus.accept() as connection:
                    self.assertEqual(connection.hello()[1]["publish"], "talk")
                    connection.send(answer)
                    while connection.more():
                        pass

    def test_a_stream_is_taken(self):
        states = faces(20)
        packets = [full(state, ";40") for state in states]
        with Transmitter("--accept-push", self.token) as server:
            with publish(server.port, "v=2 token=open-sesame-please publish=talk") as connection:
                word, fields = connection.hello()
                self.assertEqual((word, fields["stream"], fields["takes"]), ("hello", "talk", "1"))
                self.assertEqual(fields.get("from", "0"), "0")
                connection.send("{hello v=2 window=5 stream=talk duration=800}")
                codes = connection.serve(packets, 5)
            self.assertEqual(codes, ["1"] * 20)
            with Client(server.port, "{hello stream=talk}") as client:
                self.assertEqual(client.packet().fields["duration"], "800")
                self.assertEqual([keyframe.text for keyframe in client.rest()], packets)

    def test_a_second_publisher_and_a_wrong_token(self):
        with Transmitter("--accept-push", self.token) as server:
            with publish(server.port, "token=open-sesame-please publish=talk") as first:
                self.assertEqual(first.hello()[1]["takes"], "1")
                for fields, code in (("token=open-sesame-please publish=talk", 409),
                                     ("token=wrong publish=other", 401), ("publish=other", 401),
                                     ("publish=../x", 400)):
                    with Client(server.port, "{hello " + fields + "}") as second:
                        self.assertEqual(second.packet().code, code, fields)
                        second.expect_end()
                self.assertFalse(first.more(0.2), "the first one stays")
                self.assertFalse(first.ended)


class OurServer(PeerTest):
    """face-player against the Python server."""

    def expect_played(self, player, count):
        code, stats, said = player.end()
        self.assertEqual((code, stats["end_reason"]), (0, "end_of_stream"), said)
        self.assertEqual(stats["keyframes_played"], count)
        self.assertEqual(stats["packets_received"], count)
        return stats

    def expect_failed(self, player, reason):
        code, stats, said = player.end()
        self.assertEqual((code, stats["end_reason"]), (5, reason), said)
        return stats, said

    def test_classic_server_that_skips_the_hello(self):
        packets = [classic_form(state) for state in faces(30)]
        with Server() as server, Player(self.folder, server.port) as player:
            connection = server.accept()
            self.assertEqual(connection.hello()[0], "hello")
            codes = connection.serve(packets)
            self.assertEqual(codes.count("1") + codes.count("-1"), 30)
            self.expect_played(player, 30)

    def test_classic_server_that_closes_on_the_hello(self):
        packets = [classic_form(state) for state in faces(5)]
        for first_words in ("", packets[0], packets[0][:2]):
            with Server() as server, Player(self.folder, server.port) as player:
                with server.accept() as connection:
                    connection.hello()
                    connection.send(first_words)
                connection = server.accept()
                self.assertFalse(connection.more(0.2))  # no hello this time
                self.assertEqual(connection.serve(packets).count("1"), 5)
                self.expect_played(player, 5)

    def test_classic_player(self):
        with Server() as server, \
                Player(self.folder, server.port, "--protocol", "classic") as player:
            connection = server.accept()
            self.assertFalse(connection.more(0.2))
            connection.serve(["{1,6,12,14}", " { 01 ,\r\n6 }\n", "{1C,L12:30;40}"], one_by_one=True)
            self.expect_played(player, 3)

    def test_classic_pauses(self):
        """A small buffer fills: a pause in place of an answer, and a resume."""
        packets = [classic_form(state) for state in faces(40)]
        with Server() as server, \
                Player(self.folder, server.port, "--buffer", "4", "--playout", "2") as player:
            connection = server.accept()
            connection.hello()
            codes = connection.serve(packets)
            self.assertEqual(codes.count("1") + codes.count("-1"), 40)
            self.assertLessEqual(codes.count("-3"), codes.count("-1"))
            self.expect_played(player, 40)

    def grant(self, connection, extra="", window=None):
        """Reads the hello and grants what it asks for: (asked, window)."""
        word, asked = connection.hello()
        self.assertEqual((word, asked.get("v", "2")), ("hello", "2"))
        window = min(int(asked.get("window", 1)), 256) if window is None else window
        connection.send(f"{{hello v=2 window={window}{extra}}}", one_by_one=True)
        return asked, window

    def test_level_two(self):
        packets = [full(state, ";40") for state in faces(60)]
        with Server() as server, Player(self.folder, server.port) as player:
            connection = server.accept()
            _, window = self.grant(connection, " stream=x colour=green")
            codes = connection.serve(packets, window)
            self.assertEqual(codes.count("1"), 60)
            self.assertEqual(self.expect_played(player, 60)["media_seconds"], 2.4)

    def test_level_two_in_single_bytes(self):
        packets = [full(state, ";40@" + str(40 * n)) for n, state in enumerate(faces(10))]
        with Server() as server, Player(self.folder, server.port) as player:
            connection = server.accept()
            _, window = self.grant(connection)
            connection.serve(packets, window, one_by_one=True)
            self.expect_played(player, 10)

    def test_keyframe_time_of_the_hello(self):
        with Server() as server, Player(self.folder, server.port) as player:
            connection = server.accept()
            _, window = self.grant(connection, " keyframe=500")
            connection.serve(["{1}", "{2;100}", "{0}"], window)
            self.assertEqual(self.expect_played(player, 3)["media_seconds"], 1.1)

    def test_level_two_pauses(self):
        """After -1 the packets on their way still come and are answered."""
        packets = [full(state, ";40") for state in faces(100)]
        with Server() as server, \
                Player(self.folder, server.port, "--buffer", "10", "--playout", "4") as player:
            connection = server.accept()
            asked, window = self.grant(connection)
            self.assertLessEqual(int(asked["window"]), 10)
            codes = connection.serve(packets, window)
            self.assertEqual(codes.count("1"), 100)
            self.expect_played(player, 100)

    def test_changes_only(self):
        states = faces(60)
        packets = [full(states[0], ";40")]
        packets += [changed(before, after, ";40") for before, after in zip(states, states[1:])]
        packets += ["{~;40}", "{~}"]
        with Server() as server, Player(self.folder, server.port) as player:
            connection = server.accept()
            asked, window = self.grant(connection, " delta=1")
            self.assertEqual(asked.get("delta"), "1")
            connection.serve(packets, window)
            self.expect_played(player, 62)

    def test_live(self):
        with Server() as server, Player(self.folder, server.port) as player:
            connection = server.accept()
            self.grant(connection, " live=1")
            for state in faces(20):
                connection.send(full(state, ";40"))
                self.assertEqual(connection.code(), "1")
            connection.send("{-2}")
            connection.close_properly()
            code, stats, said = player.end()
            self.assertEqual((code, stats["end_reason"]), (0, "end_of_stream"), said)
            self.assertEqual(stats["packets_received"], 20)

    def test_the_end_first(self):
        for level in (1, 2):
            with Server() as server, Player(self.folder, server.port) as player:
                connection = server.accept()
                if level == 2:
                    self.grant(connection)
                else:
                    connection.hello()
                connection.send("{-2}")
                connection.close_properly()
                self.expect_played(player, 0)

    def test_a_server_that_does_not_wait(self):
        """More than the window, {-2} behind it: it is read when there is room, and counts."""
        packets = "".join(full(state, ";40") for state in faces(600))
        for hello in ("{hello v=2 window=4}", ""):
            with Server() as server, \
                    Player(self.folder, server.port, "--buffer", "8", "--playout", "4") as player:
                connection = server.accept()
                connection.hello()
                connection.send(hello + packets + "{-2}")
                connection.close_properly()
                self.expect_played(player, 600)

    def test_silence(self):
        """Blanks and half a packet are silence; after the first packet there is no limit."""
        for words in ("", " \r\n", "{1"):
            with Server() as server, \
                    Player(self.folder, server.port, "--connect-timeout", "1") as player, \
                    server.accept() as connection:
                connection.send(words)
                self.expect_failed(player, "unreachable")
        with Server() as server, \
                Player(self.folder, server.port, "--connect-timeout", "1") as player:
            connection = server.accept()
            self.grant(connection)
            self.assertFalse(connection.more(2))
            connection.serve(["{1;40}"])
            self.expect_played(player, 1)

    def test_refused(self):
        for code in (400, 401, 404, 503, 505):
            with Server() as server, Player(self.folder, server.port) as player:
                connection = server.accept()
                connection.hello()
                connection.send(f"{{error {code} no, |not| ~here~ \"%s\"}}")
                connection.close_properly()
                _, said = self.expect_failed(player, "refused")
                self.assertIn("|not|", said)

    def test_protocol_errors(self):
        for words, classic in (("{1}x", False), ("{}", False), ("{1 2}", False), ("{100}", False),
                               ("{12:101}", False), ("{~1}", True), ("{-3}", True), ("{1,?", True),
                               ("{1}{hello}", False), ("{1}{streams x}", False),
                               ("{1" + " " * 4100, True), (" " * 1025 + "{1}", True)):
            with Server() as server, \
                    Player(self.folder, server.port, "--protocol", "classic") as player, \
                    server.accept() as connection:
                connection.send(words)
                self.expect_failed(player, "protocol_error")
        for hello in ("{hello window=257}", "{hello window=200}", "{hello window=1 keyframe=0}",
                      "{hello v=3}", "{streams x}", "{hello}{~1}", "{hello}{1}{~2}",
                      "{hello delta=1}{~1}", "{hello}{hello}", "{hello from=1}", "{hello live=1 window=0}"):
            with Server() as server, \
                    Player(self.folder, server.port, "--buffer", "64") as player, \
                    server.accept() as connection:
                connection.hello()
                connection.send(hello)
                self.expect_failed(player, "protocol_error")

    def test_lost(self):
        with Server() as server, Player(self.folder, server.port) as player:
            with server.accept() as connection:
                self.grant(connection)
                connection.send("{1;40}{2;40}")
                self.assertEqual((connection.code(), connection.code()), ("1", "1"))
            stats, _ = self.expect_failed(player, "connection_lost")
            self.assertEqual(stats["packets_received"], 2)

    def test_comes_back_to_where_it_was(self):
        packets = [full(state, ";100") for state in faces(20)]
        with Server() as server, Player(self.folder, server.port, "--reconnect") as player:
            with server.accept() as connection:
                asked, _ = self.grant(connection)
                self.assertEqual(asked.get("from", "0"), "0")
                for packet in packets[:7]:
                    connection.send(packet)
                    self.assertEqual(connection.code(), "1")
            connection = server.accept()
            asked, window = self.grant(connection, " from=700")
            self.assertEqual(asked["from"], "700")
            connection.serve(packets[7:], window)
            self.expect_played(player, 20)

    def test_leaves_with_minus_four(self):
        with Server() as server, Player(self.folder, server.port) as player, \
                server.accept() as connection:
            self.grant(connection, " live=1")
            connection.send("{1;40}")
            self.assertEqual(connection.code(), "1")
            player.process.send_signal(signal.SIGINT)
            self.assertEqual(connection.code(), "-4")
            connection.send("{2}{3}{-2}")
            connection.close_properly()
            code, stats, said = player.end()
            self.assertEqual((code, stats["end_reason"]), (0, "stopped"), said)

    def listed(self, answer, terminal=False):
        """What --list prints of a server's answer."""
        ours, theirs = pty.openpty() if terminal else (None, subprocess.PIPE)
        with Server() as server:
            asking = subprocess.Popen((BIN / "face-player", "--list", f"127.0.0.1:{server.port}"),
                                      stdout=theirs, text=True)
            connection = server.accept()
            self.assertEqual(connection.hello(), ("streams", {"details": "1"}))
            connection.send(answer, one_by_one=True)
            connection.close_properly()
            listed = ""
            if terminal:
                os.close(theirs)
                # Of a terminal that nobody writes to any more nothing can be read.
                with contextlib.suppress(OSError), open(ours, encoding="utf-8", newline="") as out:
                    for line in out:
                        listed += line
            else:
                listed, _ = asking.communicate(timeout=10)
            self.assertEqual(asking.wait(timeout=10), 0)
            return listed.replace("\r", "")

    DETAILS = "{streams stream=talk live=0 duration=83000 title=QSB0YWxr stream=smile.v2 live=1 }"

    def test_list(self):
        for answer in ("{streams talk smile.v2}", self.DETAILS):
            self.assertEqual(self.listed(answer), "talk\nsmile.v2\n")

    def test_list_on_a_terminal(self):
        self.assertEqual(self.listed("{streams talk smile.v2}", terminal=True), "talk\nsmile.v2\n")
        self.assertEqual(self.listed(self.DETAILS, terminal=True),
                         "talk      1:23  A talk\nsmile.v2  live\n")


def main():
    global BIN
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    options, rest = parser.parse_known_args()
    BIN = options.bin
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()
