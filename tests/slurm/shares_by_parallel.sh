#!/usr/bin/env bash
# shares_by_parallel.sh SOURCE BUILD: the shares of an image under GNU parallel, one of which fails at first, and the image of their
# films. The command is that of resources/manual/shares.md. Ends with 77 where GNU parallel is not installed.
set -euo pipefail
source=$1
export PATH=$2/bin:$PATH
. "$source/tests/slurm/checks.sh"
parallel --version 2>/dev/null | grep -q GNU || { echo "GNU parallel is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir films
pdrender-cli example ct >/dev/null 2>&1
pdrender-cli render ct --size 96x64 --samples 8 -o alone.exr >/dev/null 2>&1

# The program of a share that is killed once: parallel runs it again.
cat >once <<'TEXT'
#!/bin/sh
case "$*" in *"--share 3/6"*) [ -e failed ] || { touch failed; kill -KILL $$; } ;; esac
exec pdrender-cli "$@"
TEXT
chmod +x once
parallel --will-cite --retries 3 -j 2 ./once render ct --size 96x64 --samples 8 --share {}/6 -o films/{}.film ::: $(seq 6) >/dev/null 2>&1
is yes "$([ -e failed ] && echo yes)" "a share was killed"
pdrender-cli merge ct films/*.film --size 96x64 -o shares.exr >/dev/null 2>&1
code=0
python3 "$source/tests/slurm/same_image.py" alone.exr shares.exr || code=$?
is 0 "$code" "difference to the image of one machine"
finish
