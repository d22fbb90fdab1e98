#!/usr/bin/env bash
# The list of what was skipped names each program with its reasons and counts, and is silent where nothing was skipped.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cat >"$folder/log" <<'LOG'
PASS   : FirstTest::initTestCase()
SKIP   : FirstTest::reads(a file) the data is not there: put it (all of it) beside the tree
   Loc: [../tests/first_test.cpp(10)]
SKIP   : FirstTest::writes() the data is not there: put it (all of it) beside the tree
FAIL!  : FirstTest::fails() 'ok' returned FALSE. ()
SKIP   : SecondTest::asRoot() root may write everywhere
LOG
cat >"$folder/expected" <<'LIST'
== 3 test functions were skipped; what they test is not shown by this run:
   FirstTest (2): the data is not there: put it (all of it) beside the tree
   SecondTest (1): root may write everywhere
LIST
./skipped "$folder/log" | diff "$folder/expected" -
echo "PASS   : FirstTest::initTestCase()" >"$folder/log"
[ -z "$(./skipped "$folder/log")" ]
[ -z "$(./skipped "$folder/none")" ]

# bootstrap ends as ctest ends, whatever it lists.
mkdir -p "$folder/tree/build/release/Testing/Temporary" "$folder/tree/build/example" "$folder/tree/tests" "$folder/bin"
touch "$folder/tree/build/example/matrix.dat"  # nothing to fetch
cp ../bootstrap "$folder/tree"
cp skipped "$folder/tree/tests"
touch "$folder/tree/build/release/build.ninja"
printf '#!/bin/sh\necho "$@" >>"%s/calls"\n' "$folder" >"$folder/bin/cmake"
printf '#!/bin/sh\necho "SKIP   : ATest::a() no data" >build/release/Testing/Temporary/LastTest.log\nexit 8\n' >"$folder/bin/ctest"
printf '#!/bin/sh\necho installed\n' >"$folder/bin/dpkg-query"
for refused in apt-get sudo; do printf '#!/bin/sh\nexit 1\n' >"$folder/bin/$refused"; done
chmod +x "$folder"/bin/*
code=0
PATH=$folder/bin:$PATH "$folder/tree/bootstrap" test >"$folder/said" 2>&1 || code=$?
[ $code -eq 8 ] || { echo "bootstrap test ended with $code, ctest with 8"; cat "$folder/said"; exit 1; }
grep -q "ATest (1): no data" "$folder/said"

# Only tests need everything to be built.
grep -qx -- "--build --preset cpu-release" "$folder/calls"
PATH=$folder/bin:$PATH "$folder/tree/bootstrap" build >/dev/null
tail -n 1 "$folder/calls" | grep -qx -- "--build --preset cpu-release --target pdrender --target pdrender-cli --target pdrender-bench --target pdrender-node"
