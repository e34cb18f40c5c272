#!/usr/bin/env bash
# Checks form and habits of the C++ sources; silent when there is nothing to say.
#   scripts/lint.sh format [FILE...]      clang-format (.clang-format), default: all that git tracks
#   scripts/lint.sh tidy [FILE...]        clang-tidy (.clang-tidy), default: all of the programs
#   scripts/lint.sh alone                 reads each source of the programs by itself, with Clang's warnings
set -eu

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
what=${1:-}
shift || true

case $what in
format)
    if [ $# -eq 0 ]; then
        git ls-files -z '*.h' '*.cpp' | xargs -0 clang-format --dry-run -Werror
    else
        clang-format --dry-run -Werror "$@"
    fi
    ;;
tidy)
    # Of a file its own command; of all several at a time, as headers take most of it. Tests are
    # left out then.
    preset=dev
    [ $# -gt 0 ] || preset=lint
    database=build/$preset
    cmake --preset $preset -DCMAKE_MESSAGE_LOG_LEVEL=WARNING >/dev/null
    if [ $# -eq 0 ]; then
        mapfile -t files < <(python3 -c '
import json, sys
for entry in json.load(open(sys.argv[1] + "/compile_commands.json")):
    if not entry["file"].endswith("_embedded.cpp"):
        print(entry["file"])' $database | sort -u)
        [ ${#files[@]} -gt 0 ] || { echo "$database knows no source of the programs" >&2; exit 1; }
        set -- "${files[@]}"
    fi
    # What is on stderr counts suppressed findings of other people's headers.
    printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p $database --quiet 2>/dev/null
    ;;
alone)
    # A unity build hides a forgotten include. Nothing is compiled: warnings come before that.
    cmake --preset clang -DCMAKE_MESSAGE_LOG_LEVEL=WARNING >/dev/null
    python3 -c '
import json
for entry in json.load(open("build/clang/compile_commands.json")):
    name = entry["file"].removeprefix(entry["directory"].removesuffix("build/clang"))
    if not name.startswith(("tests/", "build/")):
        print(entry["command"].split(" -o ")[0], "-fsyntax-only", entry["file"])' |
        xargs -d '\n' -n 1 -P "$(nproc)" sh -c
    ;;
*)
    sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
    exit 2
    ;;
esac
