"""A client and a server of AUcast, written from protocol/PROTOCOL.md alone.

Nothing here comes from the C++ code or is shared with it: what this peer cannot do although it does
what the document says is a fault of the document. Sections of it are named in brackets. What arrives
is held to the form a sender must write, which is narrower than what a receiver must accept.
"""

import base64
import dataclasses
import re
import socket
import time

PACKET_BYTES_MAX = 4096
HELLO_BYTES_MAX = 512
TOKEN_BYTES_MAX = 256
VOICE_BYTES_MAX = 2048
CAPTION_BYTES_MAX = 1024
PATIENCE = 10.0  # seconds until a test gives up waiting

TERM = re.compile(r"([LR]?)(0|[1-9][0-9]?)(?::(0|[1-9][0-9]?|100))?")
TIMING = re.compile(r"(0|[1-9][0-9]*)(?:@(0|[1-9][0-9]*))?")
FIELDS = re.compile(r"((?: +[!-<>-z|~]+=[!-z|~]*)*) *")  # of a hello [4]
NAME = re.compile(r"[A-Za-z0-9._-]{1,64}")


class Violation(Exception):
    """The other side did what the document does not allow."""


@dataclasses.dataclass
class Keyframe:
    text: str
    changes: bool
    terms: list  # of (side, number, percent)
    time_ms: int = None
    place: int = None

    def plain(self):
        """Only numbers: what a classic server sends."""
        return (not self.changes and self.time_ms is None
                and all(side == "" and percent == 100 for side, _, percent in self.terms)
                and ":" not in self.text)

    def applied_to(self, state):
        """The state of the face after this keyframe: {(number, side): percent}, without zeros."""
        result = dict(state) if self.changes else {}
        for side, number, percent in self.terms:
            for one in side or "LR":
                result[number, one] = percent
        return {key: value for key, value in result.items() if value and key[0]}


@dataclasses.dataclass
class Hello:
    fields: dict


@dataclasses.dataclass
class Error:
    code: int
    text: str


@dataclasses.dataclass
class Streams:
    names: list
    details: dict = dataclasses.field(default_factory=dict)  # of each name what is said of it


@dataclasses.dataclass
class Voice:
    """One Opus packet [2, Voice]; place is None where it goes on from the one before."""
    opus: bytes
    place: int = None

    def duration(self):
        """In ms, by the first byte (RFC 6716, 3.1); only what this protocol carries."""
        toc = self.opus[0]
        config = toc >> 3
        frame = ([10, 20, 40, 60][config % 4] if config < 12 else
                 [10, 20][config % 2] if config < 16 else [2.5, 5, 10, 20][config % 4])
        count = {0: 1, 1: 2, 2: 2}.get(toc & 3) or self.opus[1] & 63
        return frame * count


@dataclasses.dataclass
class Caption:
    text: str
    place: int


END = "end"


def parse_terms(text, changes):
    """Canonical terms [2]: ascending, left before right, equal sides joined, 100 left out."""
    terms = []
    for word in text.split(",") if text else []:
        match = TERM.fullmatch(word)
        if not match:
            raise Violation(f"no term: {word!r}")
        side, number, percent = match[1], int(match[2]), match[3]
        if percent == "100":
            raise Violation(f"100 percent is left out: {word!r}")
        if percent == "0" and not changes:
            raise Violation(f"absent AUs are left out: {word!r}")
        terms.append((side, number, 100 if percent is None else int(percent)))
    keys = [(number, side) for side, number, _ in terms]
    if keys != sorted(set(keys)):
        raise Violation(f"not ascending: {text!r}")
    for (side, number, percent), (next_side, next_number, next_percent) in zip(terms, terms[1:]):
        if number == next_number and (side, next_side) != ("L", "R"):
            raise Violation(f"a side beside both sides: {text!r}")
        if number == next_number and percent == next_percent:
            raise Violation(f"equal sides are joined: {text!r}")
    if not changes and (not terms or (0 in [number for _, number, _ in terms] and len(terms) > 1)):
        raise Violation(f"{{0}}, and only when nothing is left: {text!r}")
    return terms


def from_base64(data):
    """Bytes of base64 without "=", spelled as they must be [2]."""
    decoded = base64.b64decode(data + "=" * (-len(data) % 4))
    if base64.b64encode(decoded).decode().rstrip("=") != data:
        raise Violation(f"bits left over in {data!r}")
    return decoded


def parse_sound(text, word, place, data):
    """A voice packet or a caption [2]."""
    if len(text) > (VOICE_BYTES_MAX if word == "a" else CAPTION_BYTES_MAX):
        raise Violation(f"too long: {text!r}")
    place = None if place is None else int(place)
    decoded = from_base64(data or "")
    if word == "t" and place is not None:
        return Caption(decoded.decode("utf-8"), place)
    if word == "t" or not decoded:
        raise Violation(f"no voice and no caption: {text!r}")
    voice = Voice(decoded, place)
    if voice.duration() not in (10, 20, 40, 60):
        raise Violation(f"no voice packet: {text!r}")
    return voice


def parse_streams(text, inside):
    """A list of streams, with details or without [5.3]."""
    pieces = inside[7:].split()
    if inside[7:8] not in ("", " ") or len(text) > PACKET_BYTES_MAX:
        raise Violation(f"no list of streams: {text!r}")
    if not pieces or "=" not in pieces[0]:
        if not all(NAME.fullmatch(name) for name in pieces):
            raise Violation(f"no names of streams: {text!r}")
        return Streams(pieces)
    streams = Streams([])
    for piece in pieces:
        key, equals, value = piece.partition("=")
        if not key or not equals:
            raise Violation(f"no field {piece!r} in {text!r}")
        if key == "stream":
            if not NAME.fullmatch(value):
                raise Violation(f"no name {value!r} in {text!r}")
            streams.names.append(value)
            said = streams.details.setdefault(value, {})
        elif streams.names and key in ("live", "duration"):
            if not NUMBER.fullmatch(value) or int(value) > (1 if key == "live" else 10 ** 12):
                raise Violation(f"no number {value!r} in {text!r}")
            said[key] = int(value)
        elif streams.names and key == "title":
            said[key] = from_base64(value).decode("utf-8")
    return streams


def parse(text):
    """One packet of a server, with its braces."""
    inside = text[1:-1]
    if inside == "-2":
        return END
    if inside.startswith("hello"):
        fields = FIELDS.fullmatch(inside[5:])
        if not fields or len(text) > 512:
            raise Violation(f"no hello: {text!r}")
        return Hello(dict(field.split("=", 1) for field in fields[1].split()))
    if inside.startswith("error"):
        match = re.fullmatch(r"error +([1-9][0-9]{2})(?: ([ -z|~]*))?", inside)
        if not match or len(text) > 512:
            raise Violation(f"no error: {text!r}")
        return Error(int(match[1]), match[2] or "")
    if inside.startswith("streams"):
        return parse_streams(text, inside)
    if sound := re.fullmatch(r"([at])(?:@(0|[1-9][0-9]{0,12}))?(?: ([A-Za-z0-9+/]+))?", inside):
        return parse_sound(text, *sound.groups())
    terms, has_timing, timing = inside.partition(";")
    changes = terms.startswith("~")
    keyframe = Keyframe(text, changes, parse_terms(terms[1:] if changes else terms, changes))
    if has_timing:
        match = TIMING.fullmatch(timing)
        if not match or int(match[1]) > 3600000 or int(match[2] or 0) > 1000000000000:
            raise Violation(f"no timing: {text!r}")
        keyframe.time_ms = int(match[1])
        keyframe.place = None if match[2] is None else int(match[2])
    return keyframe


def full(state, timing=""):
    """The canonical full packet of a state."""
    words = []
    for number in sorted({number for number, _ in state}):
        left, right = state.get((number, "L"), 0), state.get((number, "R"), 0)
        sides = [("", left)] if left == right else [("L", left), ("R", right)]
        words += [side + str(number) + ("" if percent == 100 else f":{percent}")
                  for side, percent in sides if percent]
    return "{" + (",".join(words) or "0") + timing + "}"


def changed(before, after, timing=""):
    """The packet that names what is not as before."""
    words = []
    for number in sorted({number for number, _ in before | after}):
        sides = {side: after.get((number, side), 0) for side in "LR"
                 if before.get((number, side), 0) != after.get((number, side), 0)}
        if len(sides) == 2 and sides["L"] == sides["R"]:
            sides = {"": sides["L"]}
        words += [side + str(number) + ("" if percent == 100 else f":{percent}")
                  for side, percent in sides.items()]
    return "{~" + ",".join(words) + timing + "}"


NUMBER = re.compile(r"[0-9]{1,13}")
ASKED = {"v": (0, 999999), "window": (0, 999999), "delta": (0, 1), "from": (0, 1000000000000),
         "text": (0, 1), "loop": (0, 1)}


def refusal(word, fields, token="", names=(), full_up=False):
    """The code of the error that a server gives a hello or {streams} with this text between its word
    and the brace [4, 5, 6]; None when it is granted."""
    if len(word) + len(fields) + 2 > HELLO_BYTES_MAX or not FIELDS.fullmatch(fields):
        return 400
    pairs = [field.split("=", 1) for field in fields.split()]

    def readable(key, value):
        if key == "token":
            return len(value) <= TOKEN_BYTES_MAX
        if word == "streams":
            return key != "details" or (NUMBER.fullmatch(value) and int(value) <= 1)
        if key not in (*ASKED, "stream", "voice"):
            return True
        if key in ("stream", "voice"):
            return NAME.fullmatch(value)
        return NUMBER.fullmatch(value) and ASKED[key][0] <= int(value) <= ASKED[key][1]

    known = dict(pairs)
    if word == "hello":
        if not all(readable(key, value) for key, value in pairs if key == "v"):
            return 400
        if int(known.get("v", "2")) != 2:
            return 505
    if not all(readable(key, value) for key, value in pairs):
        return 400
    if token and known.get("token", "") != token:
        return 401
    if word == "hello" and "stream" in known and known["stream"] not in names:
        return 404
    return 503 if word == "hello" and full_up else None


def read_stream_file(data):
    """The terms and timing of each packet of a stream file [11]: [(terms, timing)]."""
    line_end = rb"(?:\r?\n|\Z)"
    tail = rb"[ \t]*(?:#[\t\x20-\x7e\x80-\xff]*)?" + line_end
    lines = re.findall(rb"[^\n]*\n|[^\n]+\Z", data.removeprefix(b"\xef\xbb\xbf"))
    packets, place, last = [], "before", 0
    for line in lines:
        if len(line.rstrip(b"\r\n")) > 65536:
            raise Violation("a line too long")
        if re.fullmatch(tail, line):
            continue
        if tag := re.fullmatch(rb"[ \t]*(Beg_Stream|End_Stream)" + tail, line):
            if (place, tag[1]) not in (("before", b"Beg_Stream"), ("inside", b"End_Stream")):
                raise Violation(f"a tag where none is due: {line!r}")
            place = "inside" if place == "before" else "after"
            continue
        text = re.fullmatch(rb"[ \t]*(\{[^{}#]*\}|[^{}#]*?)" + tail, line)
        if not text or place != "inside":
            raise Violation(f"no packet: {line!r}")
        words = re.sub(r"[ \t]", "", spaced(text[1].decode("ascii")))
        terms, has_timing, timing = words.strip("{}").partition(";")
        term = r"[LR]?[0-9]{1,2}(?::[0-9]{1,3}|[A-Exyz])?"
        if not re.fullmatch(f"{term}(?:[,+]{term})*", terms):
            raise Violation(f"no terms: {line!r}")
        match = re.fullmatch(r"([0-9]{1,7})(?:@([0-9]{1,13}))?", timing)
        if has_timing and (not match or int(match[2] or last) < last):
            raise Violation(f"no timing: {line!r}")
        last = int(match[2] or last) if match else last
        packets.append((re.split("[,+]", terms), timing))
    if place != "after" or not packets:
        raise Violation("no whole stream")
    return packets


def spaced(text):
    """A blank may not divide a number."""
    if re.search(r"[0-9][ \t]+[0-9]", text):
        raise Violation(f"a blank within a number: {text!r}")
    return text


class Bytes:
    """A TCP connection to read from with patience."""

    def __init__(self, stream):
        self.socket = stream
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.pending = b""
        self.ended = False  # the other side has shut its sending, or is gone

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()

    def send(self, text, one_by_one=False):
        """All at once, or every byte in a packet of its own."""
        for part in [text[n:n + 1] for n in range(len(text))] if one_by_one else [text]:
            self.socket.sendall(part.encode("ascii"))
            if one_by_one:
                time.sleep(0.002)

    def shut(self):
        self.socket.shutdown(socket.SHUT_WR)

    def more(self, seconds=PATIENCE):
        """Waits for bytes; False when none came in time or no more will."""
        if self.ended:
            return False
        self.socket.settimeout(max(seconds, 0.001))
        try:
            got = self.socket.recv(65536)
        except socket.timeout:
            return False
        except ConnectionError:
            got = b""
        self.ended = not got
        self.pending += got
        return bool(got)


class Client(Bytes):
    """The client's end: packets come, codes go."""

    def __init__(self, port, hello=None, one_by_one=False):
        super().__init__(socket.create_connection(("127.0.0.1", port), PATIENCE))
        if hello is not None:
            self.send(hello, one_by_one)

    @classmethod
    def that_takes(cls, connection, hello):
        """Who was dialled by a publisher and takes its stream [15]."""
        client = cls.__new__(cls)
        Bytes.__init__(client, connection.socket)
        client.pending = connection.pending
        client.send(hello)
        return client

    def packet(self, seconds=PATIENCE):
        """The next packet; None when the server has shut its sending. Too late is a violation."""
        until = time.monotonic() + seconds
        while b"}" not in self.pending:
            if not self.more(until - time.monotonic()):
                if not self.ended:
                    raise Violation(f"no packet in {seconds} s, only {self.pending!r}")
                if self.pending:
                    raise Violation(f"half a packet at the end: {self.pending!r}")
                return None
        text, self.pending = self.pending.split(b"}", 1)
        if not text.startswith(b"{") or len(text) + 1 > PACKET_BYTES_MAX:
            raise Violation(f"no packet: {text[:80]!r}")
        return parse(text.decode("ascii") + "}")

    def packets(self, count):
        return [self.packet() for _ in range(count)]

    def is_quiet(self, seconds=0.3):
        """Whether nothing comes for so long and the connection stays."""
        return not self.pending and not self.more(seconds) and not self.ended

    def rest(self, answer="1", seconds=PATIENCE):
        """Answers every packet until {-2} and the end: the keyframes."""
        keyframes = []
        while (packet := self.packet(seconds)) != END:
            if not isinstance(packet, Keyframe):
                raise Violation(f"{packet} where a keyframe is due")
            keyframes.append(packet)
            if answer:
                self.send(answer)
        self.expect_end()
        return keyframes

    def expect_end(self):
        """The server shuts its sending; then the client does, so that nobody waits."""
        if (packet := self.packet()) is not None:
            raise Violation(f"{packet} after the end")
        try:
            self.shut()
        except OSError:
            pass  # it has been reset after garbage


class Connection(Bytes):
    """The server's end of one connection."""

    def hello(self):
        """What a client of level 2 asks first: its word and fields."""
        while b"}" not in self.pending:
            if not self.more():
                raise Violation(f"no hello, only {self.pending!r}")
        text, self.pending = self.pending.split(b"}", 1)
        match = re.match(r"\{(hello|streams)", text.decode("ascii"))
        fields = match and FIELDS.fullmatch(text.decode("ascii")[match.end():])
        if not fields or len(text) + 1 > 512:
            raise Violation(f"no hello: {text!r}")
        return match[1], dict(field.split("=", 1) for field in fields[1].split())

    def code(self, seconds=PATIENCE):
        """The next code, 1 -1 -3 or -4; None when the client has shut its sending, or in time."""
        until = time.monotonic() + seconds
        while not (match := re.match(rb"[ \r\n]*(1|-[134])", self.pending)):
            if not re.fullmatch(rb"[ \r\n]*-?", self.pending):
                raise Violation(f"no code: {self.pending!r}")
            if not self.more(until - time.monotonic()):
                return None
        self.pending = self.pending[match.end():]
        return match[1].decode("ascii")

    def serve(self, packets, window=None, one_by_one=False):
        """Sends them with at most `window` unanswered, then {-2} [6]: classic without one. The codes
        that came."""
        classic, window = window is None, window or 1
        codes, in_flight, paused, waiting = [], 0, False, list(packets)
        while waiting or in_flight or paused:
            if waiting and in_flight < window and not paused:
                self.send(waiting.pop(0), one_by_one)
                in_flight += 1
                continue
            code = self.code()
            if code is None:
                raise Violation(f"no answer, {in_flight} packets in flight")
            codes.append(code)
            if code == "-4":
                break
            if code == "1" or (code == "-1" and classic and not paused):
                in_flight -= 1
            if in_flight < 0:
                raise Violation("an answer too many")
            paused = code == "-1" or (paused and code != "-3")
        self.send("{-2}", one_by_one)
        self.close_properly()
        return codes

    def close_properly(self):
        """Section 8: shut, read to the client's end for 2 s at most, close."""
        self.shut()
        until = time.monotonic() + 2
        while time.monotonic() < until and self.more(until - time.monotonic()):
            pass
        self.socket.close()


def publish(port, fields):
    """Dials a server to bring it a stream [15]."""
    connection = Connection(socket.create_connection(("127.0.0.1", port), PATIENCE))
    connection.send("{hello " + fields + "}")
    return connection


class Server:
    """A listening socket; each connection is served by hand."""

    def __init__(self):
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.port = self.socket.getsockname()[1]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()

    def accept(self, seconds=PATIENCE):
        self.socket.settimeout(seconds)
        return Connection(self.socket.accept()[0])
