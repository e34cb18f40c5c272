#!/usr/bin/env python3
"""Puts the page together: its files, what emscripten made, and the faces.

    scripts/web_page.py CORE OPUS OUT

CORE is the folder of aucast_core.js and aucast_core.wasm. OPUS is the one of opus-decoder.min.js, which
may be missing: then the page has no voice. OUT is made anew. Beside each file stands what a server sends
of it: the same, compressed by gzip. data/parts.json says which files each face needs, and whether the
decoder is there. A mesh goes by in another order: NAME.packed.
"""

import gzip
import json
import pathlib
import re
import shutil
import struct
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
DATA = ROOT / "data"
RULES = "rules/facs.toml"


def files_of(face: pathlib.Path) -> list[str]:
    """The files of one face, from data/; a face may name those of another one."""
    told = tomllib.loads((face / "face.toml").read_text())
    names = ["face.toml"] + [told[key] for key in ("mesh", "muscles", "aus") if key in told]
    return [RULES] + [str((face / name).resolve().relative_to(DATA)) for name in names]


def packed(mesh: bytes) -> bytes:
    """A PLY file's numbers in an order that gzip likes; packed_mesh.js has it undone."""
    head = mesh[:mesh.index(b"end_header\n") + len(b"end_header\n")]
    vertex_lines, face_lines = re.search(
        rb"element vertex (\d+\n.*)element face (\d+\nproperty list uchar uint [a-z_]+\n)end_header\n",
        head, re.DOTALL).groups()
    vertices, faces = int(vertex_lines.split()[0]), int(face_lines.split()[0])
    stride = sum({b"float": 4, b"uchar": 1}[kind]
                 for kind in re.findall(rb"^property (\w+)", vertex_lines, re.MULTILINE))
    at = len(head) + vertices * stride
    planes = [differences(mesh[len(head) + column:at:stride]) for column in range(stride)]
    sizes, steps, before = bytearray(), [], 0
    for _ in range(faces):
        sizes.append(mesh[at])
        corners = struct.unpack_from(f"<{mesh[at]}I", mesh, at + 1)
        at += 1 + 4 * len(corners)
        for corner in corners:
            steps.append(corner - before & 0xFFFFFFFF)
            before = corner
    assert at == len(mesh)
    flat = struct.pack(f"<{len(steps)}I", *steps)
    numbers = struct.pack("<5I", len(head), vertices, stride, faces, len(steps))
    return b"".join([numbers, head, *planes, sizes, *(flat[byte::4] for byte in range(4))])


def differences(plane: bytes) -> bytes:
    return bytes((now - before) & 0xFF for before, now in zip(b"\0" + plane, plane))


def main(core: pathlib.Path, opus: pathlib.Path, out: pathlib.Path) -> None:
    shutil.rmtree(out, ignore_errors=True)
    shutil.copytree(ROOT / "client/web/page", out)
    for name in ("aucast_core.js", "aucast_core.wasm"):
        shutil.copyfile(core / name, out / name)
    faces = {face.parent.name: files_of(face.parent)
             for face in sorted((DATA / "faces").glob("*/face.toml"))}
    for name in sorted({name for files in faces.values() for name in files}):
        (out / "data" / name).parent.mkdir(parents=True, exist_ok=True)
        content = (DATA / name).read_bytes()
        if name.endswith(".ply"):
            (out / "data" / f"{name}.packed").write_bytes(packed(content))
        else:
            (out / "data" / name).write_bytes(content)
    decoder = opus / "opus-decoder.min.js"
    if decoder.is_file():
        shutil.copyfile(decoder, out / decoder.name)
        shutil.copyfile(ROOT / "client/web/opus_decoder_licence.txt",
                        out / "opus_decoder_licence.txt")
    parts = {"faces": faces, "opus": decoder.is_file()}
    (out / "data/parts.json").write_text(json.dumps(parts, indent=1) + "\n")
    for file in sorted(path for path in out.rglob("*") if path.is_file()):
        # No time and no name in it: the same page gives the same bytes.
        pathlib.Path(f"{file}.gz").write_bytes(gzip.compress(file.read_bytes(), 9, mtime=0))


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*map(pathlib.Path, sys.argv[1:]))
