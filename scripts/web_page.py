#!/usr/bin/env python3
"""Puts the page together: its files, what emscripten made, and the faces.

    scripts/web_page.py CORE OUT      CORE: the folder of aucast_core.js and aucast_core.wasm

OUT is made anew. Beside each file stands what a server sends of it: the same, compressed by gzip.
data/faces.json says for each face which files it needs.
"""

import gzip
import json
import pathlib
import shutil
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


def main(core: pathlib.Path, out: pathlib.Path) -> None:
    shutil.rmtree(out, ignore_errors=True)
    shutil.copytree(ROOT / "client/web/page", out)
    for name in ("aucast_core.js", "aucast_core.wasm"):
        shutil.copyfile(core / name, out / name)
    faces = {face.parent.name: files_of(face.parent)
             for face in sorted((DATA / "faces").glob("*/face.toml"))}
    for name in sorted({name for files in faces.values() for name in files}):
        (out / "data" / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(DATA / name, out / "data" / name)
    (out / "data/faces.json").write_text(json.dumps(faces, indent=1) + "\n")
    for file in sorted(path for path in out.rglob("*") if path.is_file()):
        # No time and no name in it: the same page gives the same bytes.
        pathlib.Path(f"{file}.gz").write_bytes(gzip.compress(file.read_bytes(), 9, mtime=0))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
