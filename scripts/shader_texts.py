"""What tidy.py checks in shaders: what GLSL leaves undefined, and what passes of one picture must have in common."""

import re

# They draw the same triangles, one after the other, and the second draws only what is as near as
# the first found: their positions must agree to the last bit, which only `invariant` promises.
SAME_DEPTH = ("depth_vertex.glsl", "lit_vertex.glsl")
INVARIANT = re.compile(r"^invariant\s+gl_Position\s*;", re.MULTILINE)
NUMBER = r"\s*(-?(?:\d+\.?\d*|\.\d+))\s*,"
SMOOTHSTEP = re.compile(r"\bsmoothstep\s*\(" + NUMBER + NUMBER)


def without_comments(text):
    """The text with its lines, but without what is said beside the code."""
    text = re.sub(r"/\*.*?\*/", lambda comment: "\n" * comment.group().count("\n"), text, flags=re.DOTALL)
    return re.sub(r"//.*", "", text)


def findings(root, paths):
    folders = {}
    for path in paths:
        code = without_comments((root / path).read_text(encoding="utf-8"))
        folder, _, name = path.rpartition("/")
        folders.setdefault(folder, {})[name] = code
        for match in SMOOTHSTEP.finditer(code):
            if float(match.group(1)) >= float(match.group(2)):
                line = code.count("\n", 0, match.start()) + 1
                yield path, line, "smoothstep() is undefined unless its first edge is below its second"
    for folder, shaders in folders.items():
        for name in SAME_DEPTH:
            if not INVARIANT.search(shaders.get(name, "")) and "gl_Position" in "".join(shaders.values()):
                yield f"{folder}/{name}", 1, "does not declare `invariant gl_Position`"
