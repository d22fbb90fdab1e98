# An image that is made alone, and then by nodes that a Slurm of the test's own starts. To be sourced behind cluster.sh and
# checks.sh, with `folder`, `programs`, SIZE and SAMPLES set. `coordinator` is the process that waits for nodes, empty where there is none.
coordinator=

prepareImages() {
    "$programs/pdrender-node" --make-certificates "$folder/certificates" >/dev/null
    "$programs/pdrender-cli" example "$folder/ct" >/dev/null 2>&1
    export PDR_BUNDLE=$folder/certificates/node PDR_NODE_PROGRAM=$programs/pdrender-node
    render=("$programs/pdrender-cli" render "$folder/ct" --size "$SIZE" --samples "$SAMPLES")
    "${render[@]}" -o "$folder/alone.exr" >/dev/null 2>&1
}
# startImage PORT NODES: begins when so many nodes are there; 0: any port. Exports PDR_COORDINATOR.
startImage() {
    rm -f "$folder/nodes.exr"
    "${render[@]}" -o "$folder/nodes.exr" --listen "127.0.0.1:$1" --bundle "$folder/certificates/coordinator" --await "$2" \
        --nodes-only >"$folder/said" 2>&1 &
    coordinator=$!
    within 120 "the coordinator listens" "$(now)" heard 1 'waiting for nodes at'
    PDR_COORDINATOR=$(sed -n 's/^waiting for nodes at //p' "$folder/said")
    export PDR_COORDINATOR
}
# heard COUNT PATTERN: the coordinator has said so many such lines.
heard() {
    [ "$(grep -cE "$2" "$folder/said")" -ge "$1" ]
}
# works COUNT TASKS: so many connections, in the logs of those tasks.
works() {
    [ "$(cat "$folder/job.$job".$2.txt 2>/dev/null | grep -c '^pdrender-node: works for ')" -ge "$1" ]
}
over() {
    ! kill -0 "$coordinator" 2>/dev/null
}
# To its end: it must be the one that was made alone.
checkImage() {
    local code=0
    wait "$coordinator" || code=$?
    coordinator=
    is 0 "$code" "exit code of the one who writes the image"
    code=0
    python3 "$source/tests/slurm/same_image.py" "$folder/alone.exr" "$folder/nodes.exr" || code=$?
    is 0 "$code" "difference to the image of one machine"
    grep -E '^node .* of the samples' "$folder/said" || true
}
stopImage() {
    [ -z "$coordinator" ] || kill "$coordinator" 2>/dev/null || true
}
