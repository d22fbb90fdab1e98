#!/usr/bin/env bash
# Makes the manual's images of the window anew: the program on a chest, under an X server of its own.
#   tools/manual/window_pictures.sh FOLDER PICTURE...
# PICTURE: window-light window-dark window-small window-4k tissue light slices measuring nodes; none: all of them. SECONDS_OPEN (45) and the number
# of the X DISPLAY (81) may be set. Needs ./bootstrap build, Xvfb, openbox, xdotool and ImageMagick.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=$(realpath "${1:?a folder of DICOM files}")
shift
export DISPLAY=:${DISPLAY_NUMBER:-81}
export LC_ALL=C.UTF-8
seconds=${SECONDS_OPEN:-45}
scratch=$(mktemp -d)
started=()

stop() {
    ((${#started[@]} == 0)) || kill "${started[@]}" 2>/dev/null || true
    wait
    started=()
}
trap 'stop; rm -rf "$scratch"' EXIT

# shot NAME THEME WxH SECONDS [KEY [XDOTOOL...]]: the whole screen, when the series has been open for that long. XDOTOOL: what the
# mouse does after the key.
shot() {
    local name=$1 theme=$2 size=$3 open=$4 key=${5:-} gestures=("${@:6}")
    rm -rf "$scratch"/.[a-z]*  # a plan that the last shot left would be restored
    mkdir -p "$scratch/.config/pd-render"
    echo '<openbox_config><applications><application class="*"><maximized>yes</maximized></application></applications></openbox_config>' \
        >"$scratch/openbox.xml"
    printf "[General]\ntheme=%s\nlanguage=en\n${settings:-}\n" "$theme" >"$scratch/.config/pd-render/pdrender.ini"
    Xvfb "$DISPLAY" -screen 0 "${size}x24" >/dev/null 2>&1 &
    started+=($!)
    sleep 2
    HOME=$scratch openbox --config-file "$scratch/openbox.xml" >/dev/null 2>&1 &
    started+=($!)
    sleep 2  # a window that opens before it is ready stays hidden
    HOME=$scratch XDG_CONFIG_HOME=$scratch/.config build/release/bin/pdrender "$folder" >"$scratch/said" 2>&1 &
    started+=($!)
    local window
    window=$(xdotool search --sync --onlyvisible --pid $! --name "PD-Render" | head -1)
    [ -z "$key" ] || { sleep 8; xdotool windowfocus "$window" key "$key"; }
    ((${#gestures[@]} == 0)) || { sleep 2; xdotool "${gestures[@]}"; }
    sleep "$open"
    import -window root "$scratch/$name.png"
    convert "$scratch/$name.png" -resize '1920x1200>' -strip -quality 85 "resources/manual/pictures/$name.jpg"
    stop
}

window-light() { shot window-light light 1280x800 "$seconds"; }
window-dark() { shot window-dark dark 1280x800 "$seconds"; }
window-small() { shot window-small dark 800x600 "$seconds"; }
window-4k() { QT_SCALE_FACTOR=2 shot window-4k dark 3840x2160 $((2 * seconds)); }
tissue() { shot tissue dark 1100x740 "$seconds" F5; }
light() { shot light dark 1100x740 "$seconds" F8; }
slices() { shot slices dark 1366x768 "$seconds" l; }
# Between the inner sides of the ribs, in the window for soft tissue, and the list of measurements.
measuring() {
    shot measuring dark 1366x768 "$seconds" m mousemove 806 330 key 1 sleep 1 click 1 sleep 1 mousemove 960 330 sleep 1 click 1 \
        sleep 1 key ctrl+m mousemove 1000 720
}

# With two nodes of this machine, and one that is not there.
nodes() {
    local port=${NODE_PORT:-14743} node
    for node in left right; do
        build/release/bin/pdrender-node --coordinator "127.0.0.1:$port" --name "$node" --threads 1 >/dev/null 2>&1 &
        started+=($!)
    done
    settings="[nodes]\nlistenedPort=$port\naddresses=127.0.0.1:$((port + 1))" shot nodes dark 1280x800 "$seconds" F12
}

[ $# -gt 0 ] || set -- window-light window-dark window-small window-4k tissue light slices measuring nodes
for picture in "$@"; do
    "$picture"
done
