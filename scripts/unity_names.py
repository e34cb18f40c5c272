"""Names of unnamed namespaces that stand twice in one target of CMake.

A unity build reads several sources as one, and which ones stand together shifts with every file that is added: such a
pair breaks the build at a change that has nothing to do with it. The sources are formatted, so a name of the namespace
begins in column 0.
"""

import pathlib
import re

TARGET = re.compile(r"\baucast_(?:library|test)\(\s*(\w+)([^()]*)\)")
# A type, a constant, an alias of a type, a function with what it takes.
NAMES = (
    re.compile(r"(?:class|struct|enum class|enum) (\w+)[^;]*\{"),
    re.compile(r"(?:inline )?const(?:expr)? [^=({]*?\b(k[A-Z]\w*)(?:\[\w*\])?\s*[={(;]"),
    re.compile(r"using (\w+ = .*);"),
    re.compile(r"[\w:<>,&*\s\[\]]*?\b(\w+)(\(.*?\)).* \{$"),
)
NO_NAMES = re.compile(r"[ }#/:]|TEST|MATCHER|INSTANTIATE|using namespace|using \w+::")
PARAMETER = re.compile(r"\s*\b\w+(?: = [^,]*)?(?=[,)])")


def heads(lines):
    """(number, text) of what begins in column 0 of the unnamed namespace, up to its { or ;."""
    inside, head, begin = False, "", 0
    for number, line in enumerate(lines, 1):
        if line == "namespace {" or line.startswith("}  // namespace"):
            inside, head = line == "namespace {", ""
        elif inside and line and (head or not NO_NAMES.match(line)):
            begin = begin if head else number
            head += ("" if not head else " ") + line.strip()
            if head[-1] in "{;}":
                yield begin, re.sub(r"^template <[^>]*> ", "", head)
                head = ""


def name_of(head):
    """What must differ within a target; None for what may be declared again."""
    for pattern in NAMES:
        match = pattern.match(head)
        if match:
            takes = match.group(2) if match.lastindex == 2 else ""
            return match.group(1) + PARAMETER.sub("", takes)
    return None


def targets(root, paths):
    """(target, its sources) of the CMakeLists.txt at and above the sources among paths."""
    folders = {folder for path in paths for folder in pathlib.PurePosixPath(path).parents}
    for folder in sorted(folders):
        lists = root / folder / "CMakeLists.txt"
        for target, words in TARGET.findall(lists.read_text(encoding="utf-8") if lists.is_file() else ""):
            sources = (str(folder / word) for word in words.split())
            yield target, [path for path in sources if path in paths and path.endswith(".cpp")]


def collisions(root: pathlib.Path, paths):
    """(path, number, text) for every name that another source of its target has already."""
    for target, sources in targets(root, paths):
        first = {}
        for path in sources:
            for number, head in heads((root / path).read_text(encoding="utf-8").splitlines()):
                name = name_of(head)
                if name is None:
                    continue
                key = name.split(" = ")[0]
                other, same = first.setdefault(key, (path, name))
                if other != path and (name == key or same != name):  # an alias may be said again
                    yield path, number, f"{target} has {key} already, in {other}"
