#!/usr/bin/env bash
# programs_are_hardened.sh READELF checked|unchecked PROGRAM...: addresses that cannot be overwritten, random places, canaries
# on the stack, and, where they are to be, checked copies of memory.
set -euo pipefail
readelf=$1 copies=$2
shift 2
code=0

# has PROGRAM WHAT PATTERN OPTION: whether `readelf OPTION` shows it.
has() {
    "$readelf" "$4" -W "$1" | grep -E -- "$3" >/dev/null || { echo "$(basename "$1"): no $2"; code=1; }
}

for program in "$@"; do
    has "$program" "relocations that are read-only" "GNU_RELRO" -l
    has "$program" "binding at the start" "BIND_NOW|FLAGS.*NOW" -d
    has "$program" "position independence" "FLAGS_1.*PIE" -d
    has "$program" "stack protector" "__stack_chk_fail" --dyn-syms
    [ "$copies" = unchecked ] || has "$program" "checked copies" "__(memcpy|memset|snprintf|fprintf|printf|read)_chk" --dyn-syms
done
exit $code
