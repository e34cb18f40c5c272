#!/usr/bin/env bash
# Writes data/streams/lecture.{txt,opus,vtt}, a short lecture with voice, face and captions, from
# scripts/lecture_words.txt. Needs au-speaker (scripts/packages_speaker.txt) and ffmpeg.
#   scripts/update_lecture.sh
set -eu

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

"$root/scripts/build.sh" release au-speaker aucast_data
"$root/build/release/bin/au-speaker" "$root/scripts/lecture_words.txt" --name lecture -o "$out" \
    --language en-gb
ffmpeg -v error -i "$out/lecture.wav" -c:a libopus -b:a 24k -application voip -ac 1 \
    -map_metadata -1 -fflags +bitexact -flags:a +bitexact "$out/lecture.opus"
cp "$out/lecture.txt" "$out/lecture.vtt" "$out/lecture.opus" "$root/data/streams/"
