#!/usr/bin/env bash
# Renews what the golden tests compare with (tests/golden/baselines) from the present build, then
# shows what changed. Look at every changed picture before committing it.
#   scripts/update_golden.sh [PRESET]      default: release
set -eu

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${1:-release}

"$root/scripts/build.sh" "$preset"
cd "$root"
AUCAST_UPDATE_GOLDEN=1 ctest --preset "$preset" -L golden
git status --short -- tests/golden
