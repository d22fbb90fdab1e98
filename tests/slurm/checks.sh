# What the tests with Slurm measure by and hold true. To be sourced.
FAILURES=0

haveSlurm() {
    command -v slurmctld slurmd munged sbatch >/dev/null && [ "$(id -u)" -eq 0 ]
}

now() {
    date +%s.%N
}

# within SECONDS WHAT BEGAN COMMAND...: COMMAND comes true within so many seconds of BEGAN; looked at for 120 s.
within() {
    local most=$1 what=$2 began=$3 try took
    shift 3
    for try in $(seq 2400); do
        ! "$@" || break
        sleep 0.05
    done
    took=$(awk -v a="$began" -v b="$(now)" 'BEGIN { printf "%.2f", b - a }')
    if ! "$@"; then
        printf 'FAIL  %s: not in %s s\n' "$what" "$took"
        FAILURES=$((FAILURES + 1))
    elif awk -v a="$took" -v b="$most" 'BEGIN { exit a <= b }'; then
        printf 'FAIL  %s: after %s s, not within %s s\n' "$what" "$took" "$most"
        FAILURES=$((FAILURES + 1))
    else
        printf 'ok    %s: after %s s\n' "$what" "$took"
    fi
}

# is WANTED FOUND WHAT
is() {
    if [ "$1" = "$2" ]; then
        printf 'ok    %s: %s\n' "$3" "$2"
    else
        printf 'FAIL  %s: %s, not %s\n' "$3" "$2" "$1"
        FAILURES=$((FAILURES + 1))
    fi
}

noJobs() {
    [ -z "$(squeue --noheader)" ]
}

finish() {
    printf '%s failed\n' "$FAILURES"
    [ "$FAILURES" -eq 0 ]
}
