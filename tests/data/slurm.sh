#!/usr/bin/env bash
# Runs a command on a Slurm cluster of this machine alone: starts munged, slurmctld and slurmd with a configuration,
# keys and ports of their own, runs the command with SLURM_CONF set, and stops them.
#
#   slurm.sh FOLDER COMMAND [ARGUMENT ...]       FOLDER: an empty one, for the configuration and the daemons' logs
#
# Status: the command's; 77 where Slurm is not installed or cannot be started here, and standard error says why.
set -uo pipefail
PATH=$PATH:/usr/sbin:/sbin

folder=$(realpath "$1")
shift
skip() {
  echo "slurm.sh: $1" >&2
  tail -n 5 "$folder"/*.log 2>/dev/null >&2
  exit 77
}
for program in munged slurmctld slurmd sbatch scontrol; do
  command -v "$program" >/dev/null || skip "$program is not installed"
done

# The daemons stay in the foreground, so that exactly those that were started here are ended.
started=()
stop() {
  for ((i = ${#started[@]} - 1; i >= 0; i--)); do
    kill "${started[i]}" 2>/dev/null
    wait "${started[i]}" 2>/dev/null
  done
}
trap stop EXIT

chmod 755 "$folder"
mkdir -p "$folder"/{state,spool}
mkdir -m 755 -p "$folder/munge"
(umask 077 && head -c 1024 /dev/urandom >"$folder/munge/key")
munged --foreground --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" \
  --pid-file="$folder/munge/pid" --log-file="$folder/munged.log" --seed-file="$folder/munge/seed" \
  >>"$folder/munged.log" 2>&1 &
started+=($!)

port=$((20000 + RANDOM % 10000))
host=$(hostname -s)
user=$(id -un)
cat >"$folder/slurm.conf" <<CONF
ClusterName=blossom
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$folder/slurm.conf

for _ in {1..100}; do
  [[ -S $folder/munge/socket ]] && break
  sleep 0.1
done
[[ -S $folder/munge/socket ]] || skip "munged does not start"
slurmctld -D -f "$SLURM_CONF" >>"$folder/slurmctld.log" 2>&1 &
started+=($!)
slurmd -D -f "$SLURM_CONF" -N "$host" >>"$folder/slurmd.log" 2>&1 &
started+=($!)

for _ in {1..300}; do
  [[ $(sinfo --noheader --format=%t 2>/dev/null) == idle ]] && ready=1 && break
  sleep 0.1
done
[[ -n ${ready:-} ]] || skip "Slurm does not start"

"$@"
