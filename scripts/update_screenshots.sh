#!/usr/bin/env bash
# Renews the pictures of the window in client/gui/pictures with the programs of build/release: a
# server sends, and a real mouse goes through the panels. Look at them before committing.
# Needs xvfb, xdotool, x11-utils and imagemagick.
#   scripts/update_screenshots.sh [FOLDER]    default: client/gui/pictures
set -eu

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bin=$root/build/release/bin
out=${1:-$root/client/gui/pictures}
mkdir -p "$out"

if [ -z "${AUCAST_SCREEN:-}" ]; then
    AUCAST_SCREEN=1 xvfb-run -a -s "-screen 0 1280x800x24 -noreset" "$0" "$out"
    AUCAST_SCREEN=2 xvfb-run -a -s "-screen 0 2560x1600x24 -noreset" "$0" "$out"
    exit
fi

scale=$AUCAST_SCREEN
work=$(mktemp -d)
server=
player=
finish() {
    [ -z "$player" ] || kill -INT "$player" 2>/dev/null || true
    [ -z "$server" ] || kill "$server" 2>/dev/null || true
    wait
    rm -rf "$work"
}
trap finish EXIT

# GLFW takes the scale of the screen from here.
xprop -root -f RESOURCE_MANAGER 8s -set RESOURCE_MANAGER "Xft.dpi: $((96 * scale))"
export XDG_CONFIG_HOME=$work
for i in $(seq 20); do
    printf '6,12\n1,2,5B,26\n51,52:40\n1,4,15B\n4,5,7,23\n9,10,17\n'
done | (echo Beg_Stream; cat; echo End_Stream) >"$work/demo.txt"
"$bin/au-transmitter" --port 0 "$work/demo.txt" >"$work/server.txt" 2>&1 &
server=$!
for i in $(seq 100); do
    port=$(sed -n 's/.*listening on.*:\([0-9]*\).*/\1/p' "$work/server.txt" | head -n 1)
    [ -z "$port" ] || break
    sleep 0.1
done
"$bin/face-player" "127.0.0.1:$port" --speed 1000 &
player=$!

# Places are those of a window of 1280 x 800.
click() {
    xdotool mousemove $(($1 * scale)) $(($2 * scale))
    sleep 0.3
    xdotool click 1
    sleep 0.7
}
shot() {
    xdotool mousemove $((600 * scale)) $((20 * scale))
    sleep 1
    import -window root "$work/shot.png"
    # At twice the scale the panel says it all.
    [ "$scale" -eq 1 ] || mogrify -gravity East -crop 760x1600+0+0 +repage "$work/shot.png"
    convert "$work/shot.png" -colors 256 -strip "PNG8:$out/$1$2.png"
}
name=
[ "$scale" -eq 1 ] || name=_twice
sleep 14
shot play "$name"
[ "$scale" -eq 1 ] || exit 0
click 1003 54
click 974 130
sleep 4
shot expression ""
click 1153 54
click 1118 211
click 1118 273
shot view ""
