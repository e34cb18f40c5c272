#!/usr/bin/env bash
# Installs the Debian packages named in the given lists (default: packages.txt beside this script) that
# are not installed yet. As root directly, otherwise through sudo; with neither it prints the line to
# type and exits 1. With everything installed it touches no network.
set -u
export LC_ALL=C DEBIAN_FRONTEND=noninteractive

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
lists=("$@")
[ ${#lists[@]} -gt 0 ] || lists=("$here/packages.txt")

fail() {
    printf '%s\n' "$*" >&2
    exit 1
}

# The packages of the lists that are not installed, and that no installed package provides: a nodejs
# that is not Debian's brings npm along, and then Debian's npm cannot be installed.
missing_packages() {
    local package there
    there=$(installed_packages)
    while read -r package _; do
        case $package in '' | '#'*) continue ;; esac
        grep -qxF "$package" <<<"$there" || printf '%s\n' "$package"
    done < <(cat "${lists[@]}")
}

# Their names and what they provide, one a line.
installed_packages() {
    dpkg-query -W -f '${db:Status-Status} ${Package}, ${Provides}\n' |
        sed -n 's/^installed //; T; s/ *([^)]*)//g; s/, */\n/g; p'
}

command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
    fail "This script knows Debian and its like (apt-get is not here). Install what stands in" \
        "${lists[*]} by your system's own means, then build with CMake."

mapfile -t missing < <(missing_packages)
[ ${#missing[@]} -gt 0 ] || exit 0

line="apt-get install --no-install-recommends ${missing[*]}"
if [ "$(id -u)" -eq 0 ]; then
    as_root=()
elif command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
    as_root=(sudo DEBIAN_FRONTEND=noninteractive)
else
    fail "These packages are missing and this user may not install them. As root:
  $line"
fi

printf 'Installing %d packages: %s\n' "${#missing[@]}" "${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt=(apt-get -o DPkg::Lock::Timeout=60 -o Acquire::Retries=2)

# A failed update alone is no reason to stop: the lists on disk may do.
"${as_root[@]}" "${apt[@]}" update >"$log" 2>&1 || true
if ! "${as_root[@]}" "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >>"$log" 2>&1; then
    mapfile -t missing < <(missing_packages)
    printf 'Could not be installed: %s\n' "${missing[*]}" >&2
    printf 'What apt said:\n' >&2
    grep -E '^(E|W|Err)[: ]' "$log" | sort -u | tail -n 12 | sed 's/^/  /' >&2
    if grep -q 'Could not get lock\|Unable to acquire' "$log"; then
        printf 'Another program holds the package database: wait for it to end, then try again.\n' >&2
    elif grep -q 'Could not resolve\|failure resolving\|Failed to fetch\|Could not connect\|Unable to locate' "$log"; then
        printf 'The package servers cannot be reached: check the network, then try again.\n' >&2
    fi
    exit 1
fi

mapfile -t missing < <(missing_packages)
[ ${#missing[@]} -eq 0 ] || fail "apt-get says it is done, but these are still missing: ${missing[*]}"
