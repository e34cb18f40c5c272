"""The voice of au-transmitter over loopback, heard by a peer that shares no code with it.

    server_voice_test.py --bin FOLDER
"""

import argparse
import base64
import json
import math
import os
import pathlib
import re
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import wave

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import programs  # of scripts/

PATIENCE = 60.0  # seconds until a test gives up waiting
RATE = 16000
FRAME_MS = 60
BIN = pathlib.Path()


def speech_like(seconds):
    """Samples of 16 bits: syllables of a quarter of a second."""
    samples = []
    for i in range(int(seconds * RATE)):
        t = i / RATE
        tone = sum(math.sin(2 * math.pi * 140 * k * t) / k for k in range(1, 8))
        samples.append(int(4000 * tone * math.sin(math.pi * (t % 0.25) / 0.25)))
    return struct.pack(f"<{len(samples)}h", *samples)


def write_wav(path, sound):
    with wave.open(str(path), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(RATE)
        file.writeframes(sound)


class Served(programs.Transmitter):
    """au-transmitter until the end of the with statement; its log is a pipe."""

    def __init__(self, *arguments, **options):
        super().__init__(BIN, *arguments, stderr=subprocess.PIPE, **options)

    def __exit__(self, *_):
        self.end()

    def end(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
        self.process.communicate(timeout=PATIENCE)
        return self.process.returncode


class Listener:
    """A client that keeps what it hears, by place, and answers each keyframe at once."""

    def __init__(self, port, hello):
        self.socket = socket.create_connection(("127.0.0.1", port), PATIENCE)
        self.text = ""
        self.voice = []     # (place, opus)
        self.captions = []  # (place, text)
        self.faces = []     # (end, packet)
        self.face_ms = 0    # end of the last keyframe
        self.end = 0        # where the voice goes on
        self.late = 0       # voice packets that came after the keyframe during which they are heard
        self.ended = False
        self.socket.sendall(hello.encode())

    def packet(self):
        while "}" not in self.text:
            data = self.socket.recv(65536)
            if not data:
                raise AssertionError("the connection ended")
            self.text += data.decode("ascii")
        packet, self.text = self.text.split("}", 1)
        return packet.lstrip()[1:]

    def step(self):
        packet = self.packet()
        if packet.startswith("a"):
            match = re.fullmatch(r"a(?:@(\d+))? ([A-Za-z0-9+/]+)", packet)
            place = int(match[1]) if match[1] else self.end
            opus = base64.b64decode(match[2] + "=" * (-len(match[2]) % 4))
            self.late += place < self.face_ms
            self.voice.append((place, opus))
            self.end = place + FRAME_MS
        elif packet.startswith("t"):
            match = re.fullmatch(r"t@(\d+)(?: ([A-Za-z0-9+/]+))?", packet)
            data = match[2] or ""
            text = base64.b64decode(data + "=" * (-len(data) % 4)).decode()
            self.captions.append((int(match[1]), text))
        elif packet == "-2":
            self.ended = True
        elif packet.startswith("hello"):
            self.hello = dict(field.split("=", 1) for field in packet.split()[1:])
        else:
            self.face_ms += int(packet.split(";")[1].split("@")[0])
            self.faces.append((self.face_ms, packet))
            self.socket.sendall(b"1")

    def play_to_the_end(self):
        while not self.ended:
            self.step()
        self.socket.close()
        return self


class VoiceTest(unittest.TestCase):
    def setUp(self):
        self.folder_object = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.folder_object.name)
        self.addCleanup(self.folder_object.cleanup)

    def write_talk(self, keyframes, sound_seconds):
        talk = self.folder / "talk.txt"
        lines = "".join(f"{12 + i % 2}:50;{ms}\n" for i, ms in enumerate(keyframes))
        talk.write_text(f"# title: A talk\nBeg_Stream\n{lines}End_Stream\n")
        write_wav(self.folder / "talk.wav", speech_like(sound_seconds))
        return talk

    def check_contiguous(self, listener):
        places = [place for place, _ in listener.voice]
        self.assertEqual(places, [FRAME_MS * i for i in range(len(places))])

    def test_the_sound_file_beside_a_stream_is_heard_with_it(self):
        talk = self.write_talk([40] * 75, 3)
        (self.folder / "talk.vtt").write_text("WEBVTT\n\n00:00.500 --> 00:01.000\nGood day\n")
        stats = self.folder / "stats.json"
        with Served("--stats", stats, talk) as served:
            one = Listener(served.port, "{hello v=2 window=8 voice=opus text=1}").play_to_the_end()
            other = Listener(served.port, "{hello v=2 window=1 voice=opus}").play_to_the_end()
            self.assertEqual(served.end(), 0)
        self.assertEqual(one.hello["voice"], "opus")
        self.assertEqual(base64.b64decode(one.hello["title"] + "==").decode(), "A talk")
        self.check_contiguous(one)
        self.assertEqual(len(one.voice), 50, "every packet of 3 s")
        self.assertEqual(one.late, 0, "each goes out before the keyframe during which it is heard")
        self.assertEqual(one.captions, [(500, "Good day"), (1000, "")])
        self.assertEqual(other.voice, one.voice, "encoded once, the same for all")
        self.assertEqual(other.captions, [])
        told = json.loads(stats.read_text())
        self.assertEqual(told["voice_packets"], 100)
        self.assertGreater(told["clients"][0]["sound_bytes"], 1000)

    def test_who_does_not_ask_hears_nothing(self):
        talk = self.write_talk([40] * 10, 1)
        with Served(talk) as served:
            silent = Listener(served.port, "{hello v=2}").play_to_the_end()
        self.assertEqual(silent.voice, [])
        self.assertNotIn("voice", silent.hello)
        with Served("--no-voice", talk) as served:
            unheard = Listener(served.port, "{hello v=2 voice=opus}").play_to_the_end()
        self.assertEqual(unheard.voice, [])
        self.assertNotIn("voice", unheard.hello)

    def test_long_keyframes_are_cut_and_the_face_held_for_the_voice(self):
        talk = self.write_talk([5000], 8)
        with Served(talk) as served:
            heard = Listener(served.port, "{hello v=2 window=4 voice=opus}").play_to_the_end()
            seen = Listener(served.port, "{hello v=2}").play_to_the_end()
        self.check_contiguous(heard)
        self.assertGreaterEqual(len(heard.voice), 8000 // FRAME_MS)
        self.assertEqual(heard.late, 0)
        self.assertEqual(seen.face_ms, 5000, "who hears nothing gets the stream as it is")

    def test_a_reload_encodes_only_what_has_changed(self):
        talk = self.write_talk([40] * 25, 1)
        with Served("--log-format", "json", talk) as served:
            first = Listener(served.port, "{hello v=2 voice=opus}").play_to_the_end()
            encoded, same, reread = threading.Event(), threading.Event(), threading.Event()
            lines = []

            def read_log():
                for line in served.process.stderr:
                    lines.append(line)
                    if "its voice is there" in line:
                        encoded.set()
                    if "the sources hold what they held" in line:
                        same.set()
                    if "serving 1 stream now" in line:
                        reread.set()

            reader = threading.Thread(target=read_log)
            reader.start()
            self.assertTrue(encoded.wait(PATIENCE))
            served.process.send_signal(signal.SIGHUP)
            self.assertTrue(same.wait(PATIENCE), lines)
            self.assertEqual(sum("its voice is there" in line for line in lines), 1, lines)
            write_wav(self.folder / "new.wav", speech_like(2))
            os.replace(self.folder / "new.wav", self.folder / "talk.wav")
            served.process.send_signal(signal.SIGHUP)
            self.assertTrue(reread.wait(PATIENCE), lines)
            second = Listener(served.port, "{hello v=2 voice=opus}").play_to_the_end()
            self.assertGreater(len(second.voice), len(first.voice))
            served.process.send_signal(signal.SIGTERM)
            reader.join(PATIENCE)

    def test_a_live_voice_is_sent_and_kept_beside_the_face(self):
        fifo = self.folder / "voice.pcm"
        os.mkfifo(fifo)
        kept = self.folder / "kept.txt"
        sound = speech_like(4)
        with Served("--voice", fifo, "--record", kept, "-", stdin=subprocess.PIPE) as served:
            listener = Listener(served.port, "{hello v=2 window=64 voice=opus}")

            def perform():
                with open(fifo, "wb") as pipe:
                    begin = time.monotonic()
                    served.process.stdin.write("Beg_Stream\n")
                    for i in range(100):
                        served.process.stdin.write(f"{12 + i % 2}:50;40\n")
                        served.process.stdin.flush()
                        pipe.write(sound[i * 1280:(i + 1) * 1280])
                        pipe.flush()
                        time.sleep(max(begin + (i + 1) * 0.04 - time.monotonic(), 0))
                    served.process.stdin.write("End_Stream\n")
                    served.process.stdin.close()

            performer = threading.Thread(target=perform)
            performer.start()
            listener.play_to_the_end()
            performer.join(PATIENCE)
            served.process.stdin = None
            self.assertEqual(served.end(), 0)
        self.assertGreater(len(listener.voice), 40, "most of 4 s in packets of 60 ms")
        pages = (self.folder / "kept.opus").read_bytes()
        self.assertTrue(pages.startswith(b"OggS"))
        for _, opus in listener.voice[5:-5]:
            self.assertIn(opus[:40], pages, "the packets as they were sent")

    def write_turn(self):
        """A turn of 1.8 s in which no keyframe is like another, with a voice and a caption."""
        talk = self.folder / "talk.txt"
        lines = "".join(f"1:{i + 1};40\n" for i in range(45))
        talk.write_text(f"Beg_Stream\n{lines}End_Stream\n")
        write_wav(self.folder / "talk.wav", speech_like(1.8))
        (self.folder / "talk.vtt").write_text("WEBVTT\n\n00:00.500 --> 00:01.000\nGood day\n")
        return talk

    def test_a_recording_in_a_loop_is_the_same_behind_two_relays(self):
        with Served("--loop", self.write_turn()) as origin, \
                Served(f"aucast://127.0.0.1:{origin.port}/talk") as near, \
                Served(f"aucast://127.0.0.1:{near.port}/talk") as far:
            listeners = [Listener(port, "{hello v=2 window=8 voice=opus text=1 delta=1}")
                         for port in (origin.port, far.port)]
            for listener in listeners:
                while len(listener.faces) < 130 or len(listener.captions) < 5:
                    listener.step()
        direct, relayed = listeners
        self.assertEqual(relayed.hello, direct.hello)
        self.assertEqual(relayed.faces[:130], direct.faces[:130])
        self.assertEqual(relayed.captions[:5], direct.captions[:5])
        self.assertEqual([place for place, _ in direct.captions[:5]], [500, 1000, 2300, 2800, 4100])
        voices = min(len(direct.voice), len(relayed.voice))
        self.assertGreater(voices, 80)
        self.assertEqual(relayed.voice[:voices], direct.voice[:voices])
        self.check_contiguous(relayed)
        self.assertEqual(relayed.late, 0)

    def test_a_live_loop_is_one_thing_behind_a_relay(self):
        with Served("--live", "--loop", self.write_turn()) as origin, \
                Served(f"aucast://127.0.0.1:{origin.port}/talk") as relay:
            listeners = [Listener(port, "{hello v=2 window=0 voice=opus text=1}")
                         for port in (origin.port, relay.port)]
            for listener in listeners:
                while len(listener.faces) < 130:
                    listener.step()

        def by_what(events, turn):
            """The place of each, by what it is and in which turn of the origin's it came."""
            return {(what, place // turn): place for place, what in events}

        # Where the client's clock began, by the first keyframe that it got.
        begins = [int(re.match(r"1:(\d+);", one.faces[0][1])[1]) * 40 - 40 for one in listeners]
        # What is at 0 may have begun before.
        lined_up = [[[(place + begin, what) for place, what in events if place > 0]
                     for events in (one.faces, one.voice, one.captions)]
                    for one, begin in zip(listeners, begins)]
        for direct, relayed in zip(*lined_up):
            there = by_what(direct, 1800)
            shared = [(there[key], place) for key, place in by_what(relayed, 1800).items()
                      if key in there]
            self.assertGreater(len(shared), 2)
            self.assertEqual({a - b for a, b in shared}, {0})

    def test_what_cannot_be_a_voice_is_refused(self):
        talk = self.write_talk([40], 1)
        (self.folder / "broken.wav").write_text("no sound")

        def run(*arguments):
            done = subprocess.run([BIN / "au-transmitter", "--config", "/dev/null", "--port", "0",
                                   *map(str, arguments)], capture_output=True, text=True,
                                  timeout=PATIENCE, stdin=subprocess.DEVNULL, check=False)
            return done.returncode, done.stderr

        code, said = run("--voice", "-", talk)
        self.assertEqual(code, 2, said)
        code, said = run("--voice", "-", "-")
        self.assertEqual(code, 2, said)
        code, said = run("--voice", self.folder / "talk.wav", "-")
        self.assertEqual(code, 2, said)
        code, said = run("--voice", self.folder / "broken.wav", talk)
        self.assertEqual(code, 3, said)
        code, said = run("--voice", self.folder / "none.wav", talk)
        self.assertEqual(code, 4, said)
        code, said = run("--max-bitrate", 12, talk)
        self.assertEqual(code, 2, said)
        self.assertIn("--no-voice", said)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    options, rest = parser.parse_known_args()
    BIN = options.bin.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
