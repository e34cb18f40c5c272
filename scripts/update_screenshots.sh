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
    AUCAST_SCREEN=usual xvfb-run -a -s "-screen 0 1280x800x24 -noreset" "$0" "$out"
    AUCAST_SCREEN=twice xvfb-run -a -s "-screen 0 2560x1600x24 -noreset" "$0" "$out"
    AUCAST_SCREEN=small xvfb-run -a -s "-screen 0 800x600x24 -noreset" "$0" "$out"
    exit
fi

scale=1
width=1280
name=
case $AUCAST_SCREEN in
    twice) scale=2 width=2560 name=_twice ;;
    small) width=800 name=_small ;;
esac
work=$(mktemp -d)
data=/tmp/aucast  # is seen in the picture of the file dialog
mkdir "$data"     # not what somebody else has there
cp -r "$bin/data/." "$data"
server=
player=
finish() {
    [ -z "$player" ] || kill -INT "$player" 2>/dev/null || true
    [ -z "$server" ] || kill "$server" 2>/dev/null || true
    wait
    rm -rf "$work" "$data"
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
if [ -z "$port" ]; then
    cat "$work/server.txt" >&2
    exit 1
fi
"$bin/face-player" "127.0.0.1:$port" --data "$data" --speed 1000 --no-sound &
player=$!

# Places are those of a window of 1280 x 800; the panel is as far from the right everywhere.
click() {
    xdotool mousemove $((width - (1280 - $1) * scale)) $(($2 * scale))
    sleep 0.3
    xdotool click 1
    settle
}
# Until what stands still stands still; software OpenGL may be slow.
settle() {
    local before= now= alike=0
    for i in $(seq 40); do
        sleep 0.5
        now=$(import -window root rgb:- | md5sum)
        if [ "$now" = "$before" ]; then alike=$((alike + 1)); else alike=0; fi
        [ "$alike" -lt 3 ] || break
        before=$now
    done
}
shot() {
    xdotool mousemove $((width / 4)) $((20 * scale))
    sleep 1
    case $1 in play | camera) ;; *) settle ;; esac  # what plays does not stand still
    import -window root "$work/shot.png"
    # At twice the scale the panel says it all.
    [ "$scale" -eq 1 ] || mogrify -gravity East -crop 760x1600+0+0 +repage "$work/shot.png"
    convert "$work/shot.png" -colors 256 -strip "PNG8:$out/$1$name.png"
}
sleep 14
shot play
# The Expression tab: Happiness. It pauses what plays.
click 996 54
click 1070 154
shot expression
[ "$scale" -eq 1 ] || exit 0
if [ "$AUCAST_SCREEN" = small ]; then
    click 1117 54
    click 1119 460
    click 955 394
    shot compose
    exit
fi
# The Editor tab, AU 12 from the list.
click 1057 54
click 1135 123
click 1135 368
shot editor
# The Compose tab: a smile of AUs 6 and 12, then surprise from the pad.
click 1117 54
click 1056 597
click 1246 597
click 955 394
click 1119 460
click 955 394
click 980 170
shot compose
# Over the face: the file dialog and the list of keys.
xdotool key o
settle
shot open
xdotool key Escape
settle
xdotool key question
settle
shot keys
xdotool key Escape
settle
# The View tab: wireframe and muscles.
click 1173 54
click 1118 485
click 1118 547
shot view
click 1118 485  # kept for the next start
click 1118 547
# The Camera tab, with a film of another face in the place of a camera.
if [ ! -e "$data/models/face_landmark_with_attention.tflite" ]; then
    echo "the picture of the camera is left: scripts/install_models.sh fetches what reads faces"
    exit
fi
kill -INT "$player"
wait "$player" || true
"$bin/face-player" play "$data/streams/talk.txt" --face marek --data "$data" --size 640x480 \
    --record "$work/film.mp4"
(cd "$work" && exec "$bin/face-player" --mirror film.mp4 --data "$data") &
player=$!
sleep 10
shot camera
