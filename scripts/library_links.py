"""What CMake's libraries link must be in folders that their own folder may include: the linker finds what is missing
among them, and this finds what is too much."""

import pathlib
import re

TARGET = re.compile(r"^ *aucast_(?:library|program)\(\s*([\w-]+)([^()]*)\)", re.M)


def findings(root: pathlib.Path, lists, folder_of, may_include):
    """(path, number, text) for every library that is linked from below; `lists`: the CMakeLists.txt."""
    folders, links = {}, []
    for path in lists:
        text = (root / path).read_text(encoding="utf-8")
        for match in TARGET.finditer(text):
            folders[match.group(1)] = folder_of(path)
            number = text.count("\n", 0, match.start()) + 1
            links += [(path, number, word) for word in match.group(2).partition("LINK")[2].split()]
    for path, number, library in links:
        own, other = folder_of(path), folders.get(library, "")
        if own and other and other != own and other not in may_include[own]:
            yield path, number, f"{own} may not link {library}, which is of {other}"
