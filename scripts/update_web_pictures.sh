#!/usr/bin/env bash
# Renews the pictures of the page in client/web/pictures, with the programs of build/release and the
# page of scripts/build_web.sh. Look at them before committing. It needs packages_web_test.txt.
#   scripts/update_web_pictures.sh [FOLDER]    default: client/web/pictures
set -eu

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$(realpath -m "${1:-$root/client/web/pictures}")
mkdir -p "$out"
"$root/tests/web/run" --install
cd "$root/tests/web"
LIBGL_ALWAYS_SOFTWARE=1 xvfb-run --auto-servernum --server-args='-screen 0 1600x1200x24' \
    node pictures.mjs "$out"
