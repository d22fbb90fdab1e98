#!/usr/bin/env bash
# slurm_jobs.sh SOURCE: installer/slurm/pdrender-node.sbatch in a Slurm of its own, with a stand-in for the program.
#   PDR_REQUEUED_BY=script (default) or cluster: who sees to it that tasks run again
# Prints what was measured. Ends with 77 where Slurm is not installed or this is not root.
. "$1/tests/slurm/begin.sh"

codes=
[ "${PDR_REQUEUED_BY:-script}" = script ] || codes=69,70,75,134,137,139
startCluster "$folder" 4 "$codes"

export STANDIN_LOG=$folder/log PDR_NODE_PROGRAM=$source/tests/slurm/standin_node
touch "$STANDIN_LOG"

# submit WORDS...: the script under test; prints the job.
submit() {
    sbatch --parsable --output="$folder/job.%A.%a.txt" "$@" "$source/installer/slurm/pdrender-node.sbatch"
}
# said WHAT NAME: how many lines say that.
said() {
    grep -cE "^[0-9.]+ $1 $2 " "$STANDIN_LOG" || true
}
# atLeast COUNT WHAT NAME
atLeast() {
    [ "$(said "$2" "$3")" -ge "$1" ]
}
stateOf() {
    scontrol show job "$1" --oneliner | grep -o 'JobState=[A-Z]*' | cut -d= -f2
}
inState() {
    [ "$(stateOf "$1")" = "$2" ]
}

# Eight tasks of an array start.
began=$(now)
job=$(submit --array=0-7)
within 5 "8 tasks run" "$began" atLeast 8 up "slurm-$job-[0-7]-r0"

# What is killed comes again, under another name; it alone.
began=$(now)
kill -KILL "$(awk -v name="slurm-$job-3-r0" '$2 == "up" && $3 == name { print $4 }' "$STANDIN_LOG")"
within 8 "a killed program runs again" "$began" atLeast 1 up "slurm-$job-3-r1"
is 0 "$(said up "slurm-$job-[0-24-7]-r1")" "others that ran again"

# scancel drains: each is told and ends with 0.
began=$(now)
scancel "$job"
within 10 "8 tasks drained" "$began" atLeast 8 drained "slurm-$job-[0-7]-r[01]"
within 10 "no task left" "$began" noJobs
is 8 "$(said TERM "slurm-$job-[0-7]-r[01]")" "TERM of scancel"
is 8 "$(grep -l "exit code 0" "$folder"/job."$job".*.txt | wc -l)" "tasks that ended with 0"

# An error that may pass runs again; one that would come again does not.
job=$(submit --array=0)
within 8 "a task" "$(now)" atLeast 1 up "slurm-$job-0-r0"
echo 70 >"$STANDIN_LOG.exit"
within 20 "again after exit code 70" "$(now)" atLeast 1 up "slurm-$job-0-r1"
echo 78 >"$STANDIN_LOG.exit"
within 20 "failed after exit code 78" "$(now)" inState "${job}_0" FAILED
is 0 "$(said up "slurm-$job-0-r2")" "tries after exit code 78"

# The end of the time limit is told to the shell alone, which tells the program: once.
began=$(now)
job=$(submit --array=0 --time=1)
within 60 "drained before the time limit" "$began" atLeast 1 drained "slurm-$job-0-r0"
within 20 "completed" "$(now)" inState "${job}_0" COMPLETED
is 1 "$(said TERM "slurm-$job-0-r0")" "TERM of the time limit"

# Restarted too often: nobody tries again, and no program starts.
code=0
lines=$(wc -l <"$STANDIN_LOG")
SLURM_JOB_ID=1 SLURM_RESTART_COUNT=21 "$source/installer/slurm/pdrender-node.sbatch" 2>/dev/null || code=$?
is 78 "$code" "exit code after 21 restarts"
is "$lines" "$(wc -l <"$STANDIN_LOG")" "programs started after 21 restarts"
finish
