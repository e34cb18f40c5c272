#!/usr/bin/env bash
# Configures and builds one preset, with progress visible and as many jobs as cores and memory allow.
#   scripts/build.sh [PRESET] [TARGET...]      default: release, everything
set -eu

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${1:-release}
[ $# -eq 0 ] || shift

# A sanitizer build of one file takes about 1.5 GB at worst.
memory_gb=$(awk '/^MemAvailable:/ { print int($2 / 1048576) }' /proc/meminfo)
jobs=$((memory_gb * 2 / 3))
cores=$(nproc)
[ "$jobs" -lt "$cores" ] || jobs=$cores
[ "$jobs" -ge 1 ] || jobs=1

cd "$root"
printf 'Configuring %s\n' "$preset"
cmake --preset "$preset" -DCMAKE_MESSAGE_LOG_LEVEL=WARNING
printf 'Building %s with %d jobs\n' "$preset" "$jobs"
cmake --build --preset "$preset" --parallel "$jobs" ${1:+--target "$@"}
