#!/usr/bin/env python3
"""Reads the project's sources and reports what breaks the house style.

    scripts/tidy.py [ROOT]        one line per finding, exit 1 when there is one

What it knows: which folder may include what, what pure folders may not touch, own header first,
lengths of lines, functions and files, leftovers.
"""

import pathlib
import re
import sys

LINE_MAX = 100
FUNCTION_MAX = 70
FILE_MAX = 600

SOURCE_FOLDERS = ("common", "protocol", "server", "client", "scripts/facegen", "tests")

# What a folder may include of the project itself, longest prefix first.
LAYERS = {
    "common": {"common"},
    "protocol": {"common", "protocol"},
    "common/tls": {"common"},
    "common/sources": {"common", "protocol"},
    "common/voice": {"common", "protocol"},
    "server": {"common", "protocol", "server"},
    "client/playback": {"common", "client/playback"},
    "client/face": {"common", "client/face"},
    "client/pipeline": {"common", "client/playback", "client/face", "client/pipeline"},
    "client/net": {"common", "protocol", "client/playback", "client/net"},
    "client/view": {"common", "client/view"},
    "client/render": {"common", "client/view", "client/render"},
    "client/gui": {"common", "client/playback", "client/face", "client/view", "client/gui"},
    "client/app": {"common", "protocol", "client"},
    "scripts/facegen": {"common", "client/face", "client/view", "scripts/facegen"},
}

# Folders whose code knows no socket, no clock, no OpenGL and no log.
PURE = ("protocol", "common/tls", "common/sources", "common/voice", "client/playback", "client/face", "client/pipeline")
IMPURE = re.compile(
    r"::now\(\)|sleep_for|sleep_until|std::c(out|err)\b|printf\(|spdlog|<asio|<epoxy|GLFW/|<EGL|<thread>"
)
LEFTOVERS = re.compile(r"\b(TODO|FIXME|XXX)\b|^\s*#\s*if 0\b")
COMMENTED_OUT = re.compile(r"^\s*//\s*[\w:.<>*&\s-]+(\(.*\)|=.*);\s*$")
INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]')
# The first line of a function body at file or class level: ends in `) {` and the like.
FUNCTION_OPEN = re.compile(r"^(\s*)[^\s#/}].*\)\s*(const|noexcept|override|final|\s)*(->.*)?\{\s*$")
KEYWORDS = re.compile(r"^\s*(\}?\s*(if|for|while|switch|else|catch|do|return)\b|namespace|struct|class|enum)")


def folder_of(path: str) -> str:
    """The layer that a file belongs to, or ''."""
    fitting = [layer for layer in LAYERS if path.startswith(layer + "/")]
    return max(fitting, key=len, default="")


def check_includes(path, lines):
    layer = folder_of(path)
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if not match or match.group(1) != '"' or not layer:
            continue
        if not any(match.group(2).startswith(allowed + "/") for allowed in LAYERS[layer]):
            yield number, f"{layer} may not include {match.group(2)}"


def check_own_header_first(root, path, lines):
    header = re.sub(r"\.cpp$", ".h", path)
    if header == path or not (root / header).exists() or path.startswith("tests/"):
        return
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if match:
            if match.group(2) != header:
                yield number, f"its own header {header} comes first"
            return


def check_lines(path, lines):
    pure = any(path.startswith(folder + "/") for folder in PURE)
    for number, line in enumerate(lines, 1):
        if len(line) > LINE_MAX and "http" not in line and 'R"(' not in line:
            yield number, f"{len(line)} columns, at most {LINE_MAX}"
        if LEFTOVERS.search(line):
            yield number, "a leftover: " + line.strip()
        if COMMENTED_OUT.match(line):
            yield number, "looks like commented-out code"
        if path.endswith(".h") and re.match(r"\s*using namespace", line):
            yield number, "using namespace in a header"
        code = line.split("//")[0]
        if pure and not INCLUDE.match(line) and IMPURE.search(code.replace("snprintf(", "")):
            yield number, "a pure folder reads no clock, logs nothing and prints nothing"
        if pure and INCLUDE.match(line) and IMPURE.search(line):
            yield number, "a pure folder includes no socket, thread, OpenGL or log"


def check_functions(lines):
    """Bodies by indentation: clang-format closes a body in the column where it was opened."""
    opened = None
    for number, line in enumerate(lines, 1):
        if opened is None:
            match = FUNCTION_OPEN.match(line)
            if match and not KEYWORDS.match(line):
                opened = (number, match.group(1))
        elif line.rstrip() in (opened[1] + "}", opened[1] + "};"):
            length = number - opened[0] - 1
            if length > FUNCTION_MAX:
                yield opened[0], f"a function of {length} lines, at most {FUNCTION_MAX}"
            opened = None


def findings(root: pathlib.Path):
    for folder in SOURCE_FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            path = file.relative_to(root).as_posix()
            lines = file.read_text(encoding="utf-8").splitlines()
            if len(lines) > FILE_MAX:
                yield path, FILE_MAX, f"{len(lines)} lines, at most {FILE_MAX}"
            if file.suffix == ".h" and lines and lines[0] != "#pragma once":
                yield path, 1, "a header begins with #pragma once"
            checks = (
                check_includes(path, lines),
                check_own_header_first(root, path, lines),
                check_lines(path, lines),
                check_functions(lines),
            )
            for check in checks:
                for number, text in check:
                    yield path, number, text


def main() -> int:
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    if root.is_file():
        root = root.parent.parent
    count = 0
    for path, number, text in findings(root):
        print(f"{path}:{number}: {text}")
        count += 1
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
