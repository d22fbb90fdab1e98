#!/usr/bin/env bash
# script_alone.sh SOURCE: installer/slurm/pdrender-node.sbatch without Slurm: what tracks a job's processes elsewhere is acted, and
# so is the cluster's answer.
set -euo pipefail
source=$1
. "$source/tests/slurm/checks.sh"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export STANDIN_LOG=$folder/log PDR_NODE_PROGRAM=$source/tests/slurm/standin_node SLURM_JOB_ID=1
export PATH=$folder:$PATH
printf '#!/bin/sh\necho "$*" >>"%s/asked"\ncat "%s/config"\n' "$folder" "$folder" >"$folder/scontrol"
chmod +x "$folder/scontrol"

# run CONFIG: starts the script, waits for its program, sets SCRIPT.
run() {
    printf '%s\n' "$1" >"$folder/config"
    rm -f "$folder/asked"
    : >"$STANDIN_LOG"
    "$source/installer/slurm/pdrender-node.sbatch" --idle-minutes 1 2>/dev/null &
    SCRIPT=$!
    until grep -q ' up slurm-1-0-r0 ' "$STANDIN_LOG"; do sleep 0.02; done
}
terms() {
    grep -c ' TERM ' "$STANDIN_LOG" || true
}
ended() {
    local code=0
    wait "$SCRIPT" || code=$?
    echo "$code" >"$folder/code"
}
program() {
    awk '$2 == "up" { print $4 }' "$STANDIN_LOG"
}

run 'ProctrackType           = proctrack/cgroup'
kill -TERM "$SCRIPT"
ended
is 0 "$(cat "$folder/code")" "exit code where cgroups track processes"
is 1 "$(terms)" "TERM where cgroups track processes"

run 'ProctrackType           = proctrack/linuxproc'
kill -TERM "$SCRIPT" "$(program)"  # as Slurm does there
ended
is 0 "$(cat "$folder/code")" "exit code where all are told"
is 1 "$(terms)" "TERM where all are told"

run 'ProctrackType           = proctrack/linuxproc'
kill -USR1 "$SCRIPT"
ended
is 0 "$(cat "$folder/code")" "exit code at the time limit"

for code in 64 69 70 75 76 77 78; do
    run 'RequeueExit             = (null)'
    echo "$code" >"$STANDIN_LOG.exit"
    ended
    is "$code" "$(cat "$folder/code")" "exit code"
    case $code in 69 | 70 | 75) wanted=1 ;; *) wanted=0 ;; esac
    is "$wanted" "$(grep -c '^requeue 1$' "$folder/asked" || true)" "requests to run again after $code"
done

run 'RequeueExit             = 69,70,75,134,137,139'
kill -KILL "$(program)"
ended
is 137 "$(cat "$folder/code")" "exit code of a program that was killed"
is 0 "$(grep -c '^requeue 1$' "$folder/asked" || true)" "requests where the cluster sees to it"
finish
