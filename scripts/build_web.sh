#!/usr/bin/env bash
# Builds the page for browsers into build/web/page. The programs in build/release find it there, and
# `cmake --install` takes it along. It needs scripts/install_deps.sh scripts/packages_web.txt
set -eu

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
command -v em++ >/dev/null || {
    printf 'emscripten is missing: scripts/install_deps.sh scripts/packages_web.txt\n' >&2
    exit 1
}
# Debian's emscripten links with modules of Debian's node; another node does not look there.
export NODE_PATH=${NODE_PATH:+$NODE_PATH:}/usr/share/nodejs
"$root/scripts/build.sh" web aucast_page
mkdir -p "$root/build/release/bin/data"
ln -sfn ../../../web/page "$root/build/release/bin/data/web"
printf 'The page is in %s\n' "$root/build/web/page"
