#!/usr/bin/env bash
# Renews the program's icon: our own face, smiling, on a round ground. Needs ImageMagick.
set -eu

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$root/build/release/bin/face-player" pose 6:60,12 --size 1024x1024 --background 31506b \
    --png "$work/face.png"
convert "$work/face.png" -crop 1000x1000+12+0 +repage -resize 256x256 "$work/small.png"
convert -size 256x256 xc:black -fill white -draw 'circle 127.5,127.5 127.5,1' "$work/round.png"
convert "$work/small.png" "$work/round.png" -alpha off -compose CopyOpacity -composite \
    -strip "PNG32:$root/data/icons/aucast.png"
