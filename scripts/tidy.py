#!/usr/bin/env python3
"""Reads the project's sources and reports what breaks the house style.

    scripts/tidy.py [ROOT]        one line per finding, exit 1 when there is one

It checks which folder includes and links what, what pure folders touch, that view models know no file, that a file's
own header comes first, the lengths of lines, functions and files, leftovers, names that only a unity build would find
twice, texts that are translated but never said, what shaders leave undefined, and that READMEs name every file and the thread of their folder. It
reads what git tracks; outside a git repository, everything below ROOT but build/.
"""

import pathlib
import re
import subprocess
import sys

import library_links
import readmes
import said_texts
import shader_texts
import unity_names

LINE_MAX = 100
FUNCTION_MAX = 70
FILE_MAX = 600

SERVER = {"common", "common/camera", "common/mesh", "common/preview", "common/sources", "common/tls", "common/web", "common/voice",
          "common/link",
          "protocol"}
GUI = {"client/gui"} | {"client/gui/" + room for room in
                       ("texts", "model", "editing", "storage", "widgets", "panels")}
APP = SERVER | GUI | {"common/expressions"} | {"client/" + room for room in
                      ("playback", "face", "pipeline", "net", "sound", "view", "render", "mirror", "glb", "gallery")}

# The rooms of the window; the files directly in it are on top of them.
WINDOW = {"client/app/window/" + room for room in
          ("recording", "playing", "making", "files", "settings", "thumbnails")}

# What the files of a folder may include of the project, besides their own folder. A file belongs to
# the longest folder named here that it lies in; what lies in none of them may not be included.
MAY_INCLUDE = {
    "common": set(),
    "common/link": {"common", "common/tls", "common/web"},
    "common/camera": {"common", "common/mesh"},
    "common/expressions": {"common", "protocol"},
    "common/mesh": {"common"},
    "common/preview": {"common"},
    "common/sources": {"common", "protocol"},
    "common/tls": {"common"},
    "common/voice": {"common", "protocol"},
    "common/web": {"common"},
    "protocol": {"common"},
    "server/settings": SERVER,
    "server/voice": SERVER | {"server/settings"},
    "server/streams": SERVER | {"server/settings", "server/voice"},
    "server/live": SERVER | {"server/streams", "server/voice"},
    "server/upstream": SERVER | {"server/settings", "server/streams", "server/status"},
    "server/engine": SERVER | {"server/settings", "server/status", "server/upstream"},
    "server/preview": SERVER,
    "server/push": SERVER | {"server/settings", "server/status", "server/upstream"},
    "server/http": SERVER | {"server/settings"},
    "server/status": SERVER | {"server/settings", "server/http"},
    "server/web": SERVER | {"server/settings", "server/status", "server/http"},
    "server/serve": SERVER | {"server/settings", "server/voice", "server/streams", "server/live",
                              "server/status", "server/upstream", "server/engine",
                              "server/preview", "server/push", "server/web"},
    "server": SERVER | {"server/settings", "server/voice", "server/streams", "server/live",
                        "server/status", "server/serve", "server/upstream", "server/engine",
                        "server/push",
                        "server/web"},
    "client/playback": {"common"},
    "client/face": {"common"},
    "client/pipeline": {"common", "common/expressions", "client/playback", "client/face"},
    "client/net": {"common", "common/tls", "common/link", "protocol", "client/playback"},
    "client/sound": {"common", "common/voice", "protocol", "client/playback", "client/pipeline"},
    "client/view": {"common"},
    "client/glb": {"common", "common/sources", "client/playback", "client/face", "client/pipeline", "client/view"},
    "client/gallery": {"common", "common/expressions", "protocol", "client/face", "client/pipeline"},
    "client/render": {"common", "client/view"},
    "client/mirror": {"common", "common/preview"},
    "client/gui/texts": {"common"},
    "client/gui/model": {"common", "common/preview", "protocol", "client/playback", "client/face", "client/view",
                         "client/gallery", "client/gui/texts"},
    "client/gui/editing": {"common", "client/playback", "client/face", "client/gui/texts", "client/gui/model"},
    "client/gui/storage": {"common", "client/face", "client/gui/texts", "client/gui/model"},
    "client/gui/widgets": {"common", "client/gui/texts", "client/gui/model"},
    "client/gui/panels": {"common", "protocol", "client/playback", "client/gui/texts", "client/gui/model",
                          "client/gui/widgets"},
    "client/gui": {"common", "client/gui/texts", "client/gui/model", "client/gui/widgets", "client/gui/panels"},
    "client/app": APP,
    "client/app/video": APP | {"client/app"},
    "client/app/gallery": APP | {"client/app", "client/app/video"},
    "client/app/window/recording": APP | {"client/app"},
    "client/app/window/playing": APP | {"client/app", "client/app/window/recording"},
    "client/app/window/making": APP | {"client/app"},
    "client/app/window/files": APP | {"client/app", "client/app/video", "client/app/window/making",
                                      "client/app/window/playing"},
    "client/app/window/settings": APP | {"client/app", "client/app/video"},
    "client/app/window/thumbnails": APP | {"client/app/video"},
    "client/app/window": APP | {"client/app", "client/app/video", "client/app/gallery"} | WINDOW,
    "client/app/commands": APP | {"client/app", "client/app/video"},
    "client/web": APP - GUI - {"client/glb", "client/gallery", "client/mirror"} | {"client/app/video"},
    "client": APP | {"client/app", "client/app/video", "client/app/gallery", "client/app/window",
                     "client/app/window/settings", "client/app/commands"},
    "speaker": {"common", "common/expressions", "common/voice", "protocol"},
    "scripts/facegen": {"common", "client/face", "client/view"},
    "scripts/train_camera": {"common", "common/mesh"},
}

# Folders whose code knows no socket, clock, OpenGL or log.
PURE = {"protocol", "common/mesh", "common/preview", "common/tls", "common/sources", "common/voice", "common/web",
        "client/playback", "client/face", "client/pipeline", "client/sound", "client/glb",
        "client/gallery", "client/gui/texts", "client/gui/model", "client/gui/editing"}
IMPURE = re.compile(
    r"::now\(\)|sleep_for|sleep_until|std::c(out|err)\b|\bf?printf\(|spdlog|<asio|<epoxy|GLFW/|<EGL"
    r"|<thread>|<arpa/|<netinet/|<sys/|<unistd|<fcntl|<poll\.h|<dlfcn|\b(un)?setenv\(|\bgetenv\("
)
# Folders whose code is plain data and what follows from it: it also knows no file.
KNOWS_NO_FILE = {"client/gui/texts", "client/gui/model", "client/gui/editing"}
FILES = re.compile(r'<(filesystem|fstream)>|"common/(files|text_file)\.h"')
# What single files of the pure ones do all the same.
MAY_TOUCH = {
    "client/sound/openal_out.cpp": "<dlfcn|setenv",  # the device itself
}

# What tests may include of the project, besides their own folder, tests/support and the tests of what
# they may include. Those in tests/unit/ROOM may include what they test, and what that may include; this is more.
TESTS_MAY_INCLUDE = {
    # Tools of several tests, of no program's own parts.
    "tests/support": {"common", "common/link", "common/sources", "common/tls", "client/face", "client/gui/editing",
                      "client/view"},
    # Programs run as processes: they are met in files, pictures and bytes alone.
    "tests/integration": {"common", "common/preview", "common/voice", "protocol", "client/view"},
    "tests/golden": APP - SERVER | {"common", "client/app", "client/app/video", "client/app/window",
                                    "client/app/window/settings", "scripts/facegen"},
    # What reads bytes from elsewhere, which is pure.
    "tests/fuzz": PURE | {"common", "common/expressions"},
    "tests/bench": {"common", "common/web", "protocol", "client/face", "client/render", "tests/golden"},
    "tests/unit/protocol": {"server/settings"},  # PROTOCOL.md says its limits, too
    "tests/unit/gui/model": {"client/gui/storage"},  # which reads the files of the languages
    "tests/unit/gui/texts": {"client/gui/model", "client/gui/storage"},
    "tests/unit/gui/panels": {"client/gui", "client/render", "client/view"},  # drawn as in the window
    "tests/unit/gui/widgets": {"client/gui"},
    "tests/unit/app/window/playing": {"client/app/window/settings"},  # its options, as they are read
}
# Whose tests have another name than the folder.
TESTED = {"tests/unit/page": "client/web", "tests/unit/support": "tests/support"}

LEFTOVERS = re.compile(r"\b(TODO|FIXME|XXX)\b|^\s*#\s*if 0\b")
COMMENTED_OUT = re.compile(r"^\s*//\s*[\w:.<>*&\s-]+(\(.*\)|=.*);\s*$")
INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]')
RAW_STRING = re.compile(r'R"(\w*)\(')
# What a line ends in that opens the body of a function; initialisers have `= {`, `, {` or `x{`.
BODY_OPENS = re.compile(r"[^=,({\s] \{$")
# How a statement or a scope begins that is no function.
NO_FUNCTION = re.compile(
    r"\s*(\}|(if|for|while|switch|else|do|return|case|namespace|struct|class|union|enum)\b)"
)


def folder_of(path: str) -> str:
    """The folder of MAY_INCLUDE that a file belongs to, or ''."""
    return max((f for f in MAY_INCLUDE if path.startswith(f + "/")), key=len, default="")


def tested_by(folder):
    """The folder of MAY_INCLUDE whose tests are in `folder`, below tests/unit; '' if it is none."""
    if folder in TESTED:
        return TESTED[folder]
    room = folder.removeprefix("tests/unit/")
    return next((root + room for root in ("", "common/", "client/") if root + room in MAY_INCLUDE), "")


def test_folder_of(path):
    """The folder of tests that a file belongs to: tests/support, tests/unit/ROOM and the like; or ''."""
    folder = path.rpartition("/")[0]
    if folder.startswith("tests/unit/"):
        return folder
    return "/".join(folder.split("/")[:2]) if folder.startswith("tests/") else ""


def test_may_include(folder, other):
    """Whether the tests in a folder may include a file."""
    tested = tested_by(folder)
    allowed = TESTS_MAY_INCLUDE.get(folder, set()) | MAY_INCLUDE.get(tested, set()) | {tested}
    theirs = test_folder_of(other)
    if theirs:
        if folder == "tests/support":
            return theirs == folder
        return theirs in allowed | {folder, "tests/support"} or tested_by(theirs) in allowed - {""}
    return folder_of(other) in allowed - {""}


def cycles(may_include):
    """The folders that may include each other in a circle, one list for each circle: none is right."""
    done = set()

    def circles(folder, way):
        if folder in way:
            yield way[way.index(folder):] + [folder]
        elif folder not in done:
            for other in sorted(may_include.get(folder, ())):
                yield from circles(other, way + [folder])
            done.add(folder)

    for folder in sorted(may_include):
        yield from circles(folder, [])


def check_includes(path, lines):
    folder = folder_of(path) or test_folder_of(path)
    if not folder:
        return
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if match and match.group(1) == '"':
            other = folder_of(match.group(2))
            if folder in MAY_INCLUDE:
                may = other == folder or other in MAY_INCLUDE[folder]
            else:
                may = test_may_include(folder, match.group(2))
            if not may:
                yield number, f"{folder} may not include {match.group(2)}"


def check_own_header_first(path, lines, all_paths):
    header = re.sub(r"\.cpp$", ".h", path)
    if header == path or header not in all_paths or path.startswith("tests/"):
        return
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if match:
            if match.group(2) != header:
                yield number, f"its own header {header} comes first"
            return


def check_lines(path, lines):
    folder = folder_of(path)
    pure = folder in PURE
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
        if path in MAY_TOUCH:
            code = line = re.sub(MAY_TOUCH[path], "", code)
        if pure and not INCLUDE.match(line) and IMPURE.search(code):
            yield number, "a pure folder reads no clock, logs nothing and prints nothing"
        if pure and INCLUDE.match(line) and IMPURE.search(line):
            yield number, "a pure folder includes no socket, thread, OpenGL or log"
        if folder in KNOWS_NO_FILE and INCLUDE.match(line) and FILES.search(line):
            yield number, f"{folder} knows no file"


def without_literals(lines):
    """The lines without directives and without what stands in comments, strings, raw strings."""
    raw_end = None
    directive = False
    for line in lines:
        directive = (directive or line.lstrip().startswith("#")) and raw_end is None
        if directive:
            directive = line.endswith("\\")
            yield ""
            continue
        if raw_end is not None:
            if raw_end not in line:
                yield ""
                continue
            line = ' ' * LINE_MAX + '0' + line.split(raw_end, 1)[1]
            raw_end = None
        opens = RAW_STRING.search(line)
        if opens and f'){opens.group(1)}"' not in line:
            raw_end = f'){opens.group(1)}"'
            line = line[: opens.start()] + '""'
        line = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])+\'', "0", line)
        yield line.split("//")[0].rstrip()


def check_functions(lines):
    """Bodies by indentation: clang-format closes a body in the column where its head begins.

    Any line of no more indent than the head ends the body, so nothing can hide what follows it.
    A function or a lambda within a body is part of it.
    """
    opened = None  # the number of the line that opens a body
    head = ""  # the statement or declaration that the line belongs to, so far
    indent = 0  # of its first line
    for number, line in enumerate(without_literals(lines), 1):
        if not line:
            continue
        if opened is not None:
            if len(line) - len(line.lstrip()) > indent:
                continue
            if number - opened - 1 > FUNCTION_MAX:
                yield opened, f"a function of {number - opened - 1} lines, at most {FUNCTION_MAX}"
            opened, head = None, ""
            if line.lstrip().startswith("}"):
                continue
        if not head:
            indent = len(line) - len(line.lstrip())
        head += line
        if BODY_OPENS.search(line) and "(" in head and not NO_FUNCTION.match(head):
            opened = number
        elif line[-1] == "{":
            head = ""
        elif head.count("(") <= head.count(")"):
            row = line.endswith("},") and "    : " not in head  # not a member that is initialised
            if row or line[-1] in ";:}":
                head = ""


def tracked_files(root: pathlib.Path, endings=(".h", ".cpp")):
    """What git tracks below root, or has found and not been told to ignore; sorted."""
    git = subprocess.run(
        ["git", "-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        capture_output=True, text=True, check=False,
    )
    if git.returncode == 0:
        paths = set(git.stdout.split("\0"))
    else:
        paths = {file.relative_to(root).as_posix() for file in root.rglob("*")}
    return sorted(
        path for path in paths
        if path.endswith(endings) and not path.startswith("build/")
        and (root / path).is_file()
    )


def words_of(root: pathlib.Path):
    """Every word of code, scripts and settings."""
    endings = (".h", ".cpp", ".py", ".js", ".mjs", ".toml", ".glsl", ".sh", ".html", "CMakeLists.txt")
    words = set()
    for path in tracked_files(root, endings):
        words.update(re.findall(r"\w+", (root / path).read_text(encoding="utf-8")))
    return words


def findings(root: pathlib.Path):
    for circle in cycles(MAY_INCLUDE):
        yield "scripts/tidy.py", 1, "MAY_INCLUDE is a circle: " + " -> ".join(circle)
    all_paths = tracked_files(root)
    if not all_paths:
        yield ".", 1, "no source here"
    lists = tracked_files(root, ("CMakeLists.txt",))
    yield from library_links.findings(root, lists, folder_of, MAY_INCLUDE)
    yield from unity_names.collisions(root, all_paths)
    yield from said_texts.findings(root, all_paths)
    yield from shader_texts.findings(root, tracked_files(root, (".glsl",)))
    yield from readmes.findings(root, all_paths, tracked_files(root, (".md",)), words_of(root))
    for path in all_paths:
        lines = (root / path).read_text(encoding="utf-8").splitlines()
        if len(lines) > FILE_MAX:
            yield path, FILE_MAX, f"{len(lines)} lines, at most {FILE_MAX}"
        if path.endswith(".h") and lines and lines[0] != "#pragma once":
            yield path, 1, "a header begins with #pragma once"
        checks = (
            check_includes(path, lines),
            check_own_header_first(path, lines, all_paths),
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
