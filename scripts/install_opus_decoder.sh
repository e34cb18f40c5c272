#!/usr/bin/env bash
# Fetches what decodes the voice in a page, opus-decoder (MIT, by Ethan Halsall), with npm, checks it and
# puts it into a folder:
#
#     scripts/install_opus_decoder.sh FOLDER
#
# With the file there it touches no network. scripts/build_web.sh starts it.
set -eu
export LC_ALL=C

package=opus-decoder@0.7.12
archive_sha256=da533b53ee80a0c98c58f2ea9e37221c21025145f0b0037def38ae1a31c3d5dc
file=opus-decoder.min.js
file_sha256=68a08546a23df78bc837808af82af5a7550899ed5e17e281826dc2b3320dccdf

fail() {
    printf 'install_opus_decoder.sh: %s\n' "$*" >&2
    exit 1
}

# Whether the file has this SHA-256.
is_intact() { [ -f "$1" ] && [ "$(sha256sum <"$1" | cut -d' ' -f1)" = "$2" ]; }

folder=${1:?name a folder}
if is_intact "$folder/$file" "$file_sha256"; then exit 0; fi

command -v npm >/dev/null || fail "npm is not installed"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
(cd "$work" && npm pack --silent "$package" >archive_name) ||
    fail "npm cannot fetch $package: check the network, then try again"
archive=$work/$(tail -n 1 "$work/archive_name")
is_intact "$archive" "$archive_sha256" ||
    fail "what npm fetched is not $package as it was published; nothing was installed"
tar -xzf "$archive" -C "$work" "package/dist/$file"
is_intact "$work/package/dist/$file" "$file_sha256" || fail "$file is damaged; nothing was installed"
mkdir -p "$folder"
mv "$work/package/dist/$file" "$folder/$file"
