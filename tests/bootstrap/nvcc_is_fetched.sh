#!/usr/bin/env bash
# Where CMake finds no CUDA compiler, `bootstrap test` fetches one and configures again; where it cannot or may not, it says
# why in one line and tests go on.
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

mkdir -p "$folder/tree/tests" "$folder/tree/cmake" "$folder/bin"
cp bootstrap "$folder/tree"
cp tests/skipped "$folder/tree/tests"
cp cmake/nvcc.txt "$folder/tree/cmake"
# A CMake that knows of no compiler but the one in build/nvcc.
cat >"$folder/bin/cmake" <<'TEXT'
#!/bin/sh
[ "$1" = --preset ] || exit 0
mkdir -p build/release build/example
touch build/release/build.ninja build/example/matrix.dat
found=PDR_NVCC-NOTFOUND
[ ! -e build/nvcc/nvidia/cu13/lib64/libcudart.so ] || found=build/nvcc/nvidia/cu13/bin/nvcc
echo "PDR_NVCC:FILEPATH=$found" >build/release/CMakeCache.txt
TEXT
# A pip that fetches where it may, and checks that it is asked for what is pinned.
cat >"$folder/bin/python3" <<'TEXT'
#!/bin/sh
[ "$3" != --version ] || exit 0
echo "$@" >>"$PIP_CALLS"
[ -z "$PIP_FAILS" ] || { printf 'WARNING: retrying\nERROR: no network\n'; exit 1; }
while [ "$1" != --target ]; do shift; done
mkdir -p "$2/nvidia/cu13/bin" "$2/nvidia/cu13/lib"
touch "$2/nvidia/cu13/bin/nvcc" "$2/nvidia/cu13/lib/libcudart.so.13"
chmod +x "$2/nvidia/cu13/bin/nvcc"
TEXT
printf '#!/bin/sh\necho x86_64\n' >"$folder/bin/uname"
printf '#!/bin/sh\necho installed\n' >"$folder/bin/dpkg-query"
for refused in apt-get sudo; do printf '#!/bin/sh\nexit 1\n' >"$folder/bin/$refused"; done
printf '#!/bin/sh\nexit 0\n' >"$folder/bin/ctest"
chmod +x "$folder"/bin/*

# said [SETTING...]: what bootstrap test says of it; it must end with 0.
said() {
    env "$@" PATH="$folder/bin:$PATH" PIP_CALLS="$folder/calls" "$folder/tree/bootstrap" test >"$folder/said" 2>&1 ||
        { cat "$folder/said" >&2; exit 1; }
    cat "$folder/said"
}

said PIP_FAILS= PDR_FETCH_NVCC=0 | grep -q "skipped: there is no CUDA compiler (nvcc), and PDR_FETCH_NVCC is 0"
[ ! -e "$folder/calls" ]
said PIP_FAILS=1 PDR_FETCH_NVCC=1 | grep -q "skipped: the CUDA compiler cannot be fetched: ERROR: no network"
[ "$(ls "$folder/tree/build")" = "$(printf 'example\nrelease')" ]
said PIP_FAILS= PDR_FETCH_NVCC=1 | grep -q "fetching the CUDA compiler"
grep -q -- --require-hashes "$folder/calls"
grep -q "cu13/bin/nvcc" "$folder/tree/build/release/CMakeCache.txt"
rm "$folder/calls"
if said PIP_FAILS= PDR_FETCH_NVCC=1 | grep "CUDA compiler"; then exit 1; fi
[ ! -e "$folder/calls" ]
# A build folder that does not know yet of one that was fetched for another.
echo "PDR_NVCC:FILEPATH=PDR_NVCC-NOTFOUND" >"$folder/tree/build/release/CMakeCache.txt"
said PIP_FAILS= PDR_FETCH_NVCC=1 >/dev/null
[ ! -e "$folder/calls" ]
grep -q "cu13/bin/nvcc" "$folder/tree/build/release/CMakeCache.txt"
