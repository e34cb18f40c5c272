#!/usr/bin/env bash
# Builds the page for browsers into build/web/page. The programs in build/release find it there, and
# `cmake --install` takes it along. It needs scripts/install_deps.sh scripts/packages_web.txt
# The voice is decoded by a package of npm; where that cannot be had, the page has no voice.
set -eu

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
command -v em++ >/dev/null || {
    printf 'emscripten is missing: scripts/install_deps.sh scripts/packages_web.txt\n' >&2
    exit 1
}
# Debian's emscripten links with modules of Debian's node; another node does not look there.
export NODE_PATH=${NODE_PATH:+$NODE_PATH:}/usr/share/nodejs
decoder=$root/build/web/opus-decoder
without_voice=
"$root/scripts/install_opus_decoder.sh" "$decoder" || {
    rm -rf "$decoder"
    without_voice=', without voice'
}
"$root/scripts/build.sh" web aucast_page
mkdir -p "$root/build/release/bin/data"
ln -sfn ../../../web/page "$root/build/release/bin/data/web"
printf 'The page is in %s%s\n' "$root/build/web/page" "$without_voice"
