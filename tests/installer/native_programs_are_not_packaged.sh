#!/usr/bin/env bash
# native_programs_are_not_packaged.sh CMAKE SOURCE BUILD: what is made for this processor alone becomes no package.
set -euo pipefail
cmake=$1 source=$2 build=$3

# Package without one is refused, with what to do; the others are not.
said=$("$cmake" -DCPACK_PDR_ARCH=native -P "$source/installer/portable_only.cmake" 2>&1) && { echo "native was packaged"; exit 1; }
grep -q "release-portable" <<<"$said"
"$cmake" -DCPACK_PDR_ARCH=x86-64-v3 -P "$source/installer/portable_only.cmake"
"$cmake" -DCPACK_PDR_ARCH= -P "$source/installer/portable_only.cmake"

# cpack asks that file about this build.
grep -q 'CPACK_PROJECT_CONFIG_FILE ".*installer/portable_only.cmake"' "$build/CPackConfig.cmake"
arch=$(sed -n 's/^PDR_ARCH:STRING=//p' "$build/CMakeCache.txt")
grep -q "CPACK_PDR_ARCH \"$arch\"" "$build/CPackConfig.cmake"

# What is for others is configured for others.
"$cmake" --list-presets -S "$source" | grep release-portable >/dev/null
for preset in release-portable cuda-release; do
    "$cmake" -N --preset "$preset" -S "$source" | grep 'PDR_ARCH="x86-64-v3"' >/dev/null || { echo "$preset is native"; exit 1; }
done
