#!/usr/bin/env bash
# the_icon_is_installed.sh CMAKE BUILD: what an installation lays where desktops look for a program and its icon.
set -euo pipefail
cmake=$1 build=$2
there=$(mktemp -d)
trap 'rm -rf "$there"' EXIT
"$cmake" --install "$build" --prefix "$there" >/dev/null

entry=$there/share/applications/pdrender.desktop
grep -qx "Icon=pdrender" "$entry"
grep -qx "StartupWMClass=pdrender" "$entry"  # of its windows under X11: the program's name
test -x "$there/bin/$(sed -n 's/^Exec=\([^ ]*\).*/\1/p' "$entry")"
test -s "$there/share/icons/hicolor/scalable/apps/pdrender.svg"
for size in 16 32 48 64 128 256; do
    test -s "$there/share/icons/hicolor/${size}x$size/apps/pdrender.png"
done
