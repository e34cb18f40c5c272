"""Sentences that client/gui translates by pattern, and the code that says them.

What comes up in English from other folders is recognised by the rows of client/gui/texts/english_errors.h. Reworded
there, a sentence would stay English in every other language and nobody would notice: so each part of a row between two
places to fill in must stand in a string of the code, or be what the system says. So must what the window says in other
words, in client/gui/texts/said_text.cpp.
"""

import os
import re

TABLE = "client/gui/texts/english_errors.h"
TABLES = "client/gui/texts/english"
IN_WINDOW = "client/gui/texts/said_text.cpp"
SPEAKERS = ("common/", "protocol/", "server/", "client/")
# A comment may have a quote in it, and a raw string any.
TOKEN = re.compile(r'//[^\n]*|R"\((?P<raw>.*?)\)"|"(?P<text>(?:[^"\\\n]|\\.)*)"', re.S)
ROW = re.compile(r'\{\s*"((?:net|made|bad)\.\w+)",((?:\s*"(?:[^"\\\n]|\\.)*")+)\s*\}')
# What is said, and the key of the window's words.
OTHER_WORDS = re.compile(r'\{((?:\s*"(?:[^"\\\n]|\\.)*")+),\s*"(\w+\.\w+)"\}')
# Between two strings that the compiler joins.
BETWEEN = re.compile(r"\s*")


def unescaped(text):
    return text.replace('\\n', '\n').replace('\\"', '"').replace("\\\\", "\\")


def strings(source):
    """The strings of a C++ source, those side by side joined."""
    joined, end = [], None
    for token in TOKEN.finditer(source):
        text = token["raw"] if token["raw"] is not None else token["text"]
        if text is None:
            continue
        text = unescaped(text)
        if end is not None and BETWEEN.fullmatch(source, end, token.start()):
            joined[-1] += text
        else:
            joined.append(text)
        end = token.end()
    return joined


def system_texts():
    return [os.strerror(number) for number in range(1, 134)] + [
        "Name or service not known", "Temporary failure in name resolution", "No address associated with hostname"]


def rows(table):
    for row in ROW.finditer(table):
        yield table.count("\n", 0, row.start()) + 1, row[1], "".join(strings(row[2]))
    for row in OTHER_WORDS.finditer(table):
        yield table.count("\n", 0, row.start()) + 1, row[2], "".join(strings(row[1]))


# What the window calls settings, and counted(); both are put together when something is said.
PUT_TOGETHER = re.compile(r"\{\w+\}|Pictures/s|'Neutral, s'|\b1 row\b")
# What joins parts: "; " before a remedy, ": " behind a place.
JOINTS = " ;:()\n"
# Of a sentence that the code puts together itself, each piece has so many letters at least.
PIECE = 3


class Said:
    """All that is said: whole, or put together of the end of a string, whole ones, and the beginning of one."""

    def __init__(self, texts):
        self.texts = set(texts)
        self.all = "\0".join(self.texts)
        self.begins = {text[:n] for text in self.texts for n in range(PIECE, len(text) + 1)}
        self.ends = {text[-n:] for text in self.texts for n in range(PIECE, len(text) + 1)}

    def has(self, part):
        if part in self.all:
            return True
        reached = {n for n in range(PIECE, len(part)) if part[:n] in self.ends}
        for n in range(len(part)):
            if n in reached:
                if part[n:] in self.begins:
                    return True
                reached |= {m for m in range(n + PIECE, len(part)) if part[n:m] in self.texts}
        return False


def unsaid(table, sources):
    """(line, key, part) of what neither a string of `sources` nor the system says."""
    said = Said([text for source in sources for text in strings(source)] + system_texts())
    for line, key, text in rows(table):
        for part in PUT_TOGETHER.split(text):
            part = part.strip(JOINTS)
            if not said.has(part):
                yield line, key, part


def findings(root, paths):
    """(path, line, text) of what is translated but never said."""
    sources = [(root / path).read_text(encoding="utf-8") for path in paths
               if path.startswith(SPEAKERS) and not path.startswith(TABLES) and path != IN_WINDOW]
    for table in (TABLE, IN_WINDOW):
        if table not in paths:
            continue
        for line, key, part in unsaid((root / table).read_text(encoding="utf-8"), sources):
            yield table, line, f"{key}: nothing says '{part}'"
