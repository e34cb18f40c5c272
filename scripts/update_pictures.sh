#!/usr/bin/env bash
# Renews the pictures of the README with the programs of build/release. Look at them before committing.
set -eu

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bin=$root/build/release/bin
mkdir -p "$root/data/pictures"

# The sets of data/expressions.toml, so that the captions are names.
stream=$(mktemp --suffix .txt)
trap 'rm -f "$stream"' EXIT
printf '%s\n' Beg_Stream 1,2,5B,26 1,2,4,5,20,25 9,10,17 4,5,7,23 6,12 1,4,15B End_Stream >"$stream"
for face in default marek; do
  "$bin/face-player" play "$stream" --face "$face" --size 320x320 \
      --sheet "$root/data/pictures/six_expressions_$face.png"
done
