# A Slurm of a test's own on this host: as root, without systemd and without cgroups, its keys, state and logs in one
# folder. To be sourced.
#   startCluster FOLDER NODES [CODES]   all nodes idle when it returns; exports SLURM_CONF; CODES: RequeueExit, "70,75"
#   stopCluster FOLDER                  ends what it began, by the ids that the daemons wrote down
# Ports are this folder's own as far as its process id tells them apart.

# What slurmctld has to be told. A job that failed runs again after cred_expire instead of two minutes; LLN spreads jobs. What
# ran on a host that died runs again after 25 s with a MessageTimeout of 5, after 32 to 35 s with 10 (measured).
slurmConf() {
    local folder=$1 nodes=$2 codes=${3:-} base=$((20000 + $$ % 20000)) host
    host=$(hostname -s)
    cat <<TEXT
ClusterName=pdrtest
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket,cred_expire=5
CredType=cred/munge
SlurmctldPort=$base
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool.%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.%n.log
MpiDefault=none
SwitchType=switch/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/backfill
SchedulerParameters=bf_interval=1,sched_interval=1,batch_sched_delay=0,sched_min_interval=0
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=10
InactiveLimit=0
MinJobAge=300
KillWait=10
MessageTimeout=5
JobRequeue=1
PropagateResourceLimits=NONE
${codes:+RequeueExit=$codes}
NodeName=n[1-$nodes] NodeHostname=$host NodeAddr=127.0.0.1 Port=[$((base + 1))-$((base + nodes))] CPUs=16 RealMemory=1000
PartitionName=render Nodes=n[1-$nodes] Default=YES LLN=YES MaxTime=INFINITE State=UP
TEXT
}

startCluster() {
    local folder=$1 nodes=$2 node try
    mkdir -p "$folder/munge" "$folder/state"
    chmod 755 "$folder" "$folder/munge"  # munged wants to see that others may pass
    (umask 077 && head -c 1024 /dev/urandom >"$folder/munge/key")
    munged --key-file="$folder/munge/key" --socket="$folder/munge/socket" --pid-file="$folder/munge/pid" \
        --log-file="$folder/munge/log" --seed-file="$folder/munge/seed"
    export SLURM_CONF=$folder/slurm.conf
    slurmConf "$folder" "$nodes" "${3:-}" >"$SLURM_CONF"
    echo 'CgroupPlugin=autodetect' >"$folder/cgroup.conf"
    slurmctld -f "$SLURM_CONF"
    for node in $(seq "$nodes"); do
        mkdir -p "$folder/spool.n$node"
        slurmd -N "n$node" -f "$SLURM_CONF"
    done
    for try in $(seq 600); do
        [ "$(sinfo --noheader --format='%T %D' 2>/dev/null)" = "idle $nodes" ] && return
        sleep 0.05
    done
    sinfo
    return 1
}

stopCluster() {
    local folder=$1 file try
    export SLURM_CONF=$folder/slurm.conf
    scancel --user="$(id -un)" 2>/dev/null || true
    for try in $(seq 240); do
        [ -n "$(squeue --noheader 2>/dev/null)" ] || break
        sleep 0.05
    done
    for file in "$folder"/slurmd.n*.pid "$folder/slurmctld.pid" "$folder/munge/pid"; do
        [ ! -s "$file" ] || kill "$(cat "$file")" 2>/dev/null || true
    done
    for try in $(seq 400); do  # they write into the folder to their end
        [ -e "$folder/munge/pid" ] || [ -e "$folder/slurmctld.pid" ] || break
        sleep 0.05
    done
}
