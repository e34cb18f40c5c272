"""What tidy.py asks of pages: READMEs name every file and the thread of their folders, in lines one can
read, and no page names a class that is not there."""

import pathlib
import re

LINE_MAX = 140
CLASS = re.compile(r"^class [^;]*\{", re.M)
CODE = re.compile(r"```.*?```|`[^`]+`", re.S)
NAME = re.compile(r"\b[A-Z][a-z0-9]+(?:[A-Z][a-z0-9]*)+\b")
OTHERS = {"PascalCase", "TimeoutStopSec"}  # an example; a word of systemd


def nearest(path: str, readmes) -> str:
    """The README.md of the file's folder or of the closest one above it, but the root's; or ''."""
    for folder in pathlib.PurePosixPath(path).parents:
        readme = f"{folder}/README.md"
        if readme in readmes:
            return readme
    return ""


def unnamed(root: pathlib.Path, sources, readmes):
    """Sources that their README does not name as code (`stem`); once for header and source."""
    named = {
        readme: set(re.findall(r"\w+", " ".join(CODE.findall((root / readme).read_text(encoding="utf-8")))))
        for readme in readmes
    }
    seen = set()
    for path in sources:
        file = pathlib.PurePosixPath(path)
        stem = (file.parent, file.stem)
        if path.startswith("tests/") or stem in seen:
            continue
        seen.add(stem)
        readme = nearest(path, readmes)
        if not readme:
            yield path, 1, "no README.md of its folder or of one above"
        elif file.stem not in named[readme]:
            yield path, 1, f"{readme} does not name `{file.stem}`"


def threadless(root: pathlib.Path, sources, readmes):
    """READMEs of classes that do not say on which thread these run; those of tests and scripts need not."""
    owners = set()
    for path in sources:
        if path.endswith(".h") and not path.startswith(("tests/", "scripts/")):
            if CLASS.search((root / path).read_text(encoding="utf-8")):
                owners.add(nearest(path, readmes))
    for readme in sorted(owners - {""}):
        if "thread" not in (root / readme).read_text(encoding="utf-8").lower():
            yield readme, 1, "does not say on which thread the folder runs"


def too_wide(root: pathlib.Path, readmes):
    """Lines that are too long and neither of a table nor of a link."""
    for readme in readmes:
        for number, line in enumerate((root / readme).read_text(encoding="utf-8").splitlines(), 1):
            if len(line) > LINE_MAX and not line.startswith("|") and "](" not in line and "http" not in line:
                yield readme, number, f"{len(line)} columns, at most {LINE_MAX}"


def gone(root: pathlib.Path, pages, words):
    """Classes that a page names as code (`TwoHumps`) and that are not among the words of the sources."""
    for page in pages:
        text = (root / page).read_text(encoding="utf-8")
        for code in re.finditer(r"`([^`\n]+)`", text):
            for name in NAME.findall(code[1]):
                if name not in words and name not in OTHERS:
                    yield page, text.count("\n", 0, code.start()) + 1, f"there is no `{name}`"


def findings(root: pathlib.Path, sources, pages, words):
    """Nothing for a tree without a README at its root: it is no project. `words`: those of all that is no page."""
    readmes = [page for page in pages if pathlib.PurePosixPath(page).name == "README.md"]
    if "README.md" in readmes:
        yield from unnamed(root, sources, readmes)
        yield from threadless(root, sources, readmes)
        yield from too_wide(root, readmes)
        yield from gone(root, [page for page in pages if page != "CHANGELOG.md"], words)
