#!/usr/bin/env bash
# A Slurm cluster of this machine alone, for a test: munged, slurmctld and slurmd on the loopback address, no cgroups.
#
# Run     tests/slurm/cluster.sh start FOLDER      as root; prints the path of slurm.conf, for SLURM_CONF
#         tests/slurm/cluster.sh stop FOLDER
#         tests/slurm/cluster.sh watch FOLDER      stops it when its standard input ends, as when a test is killed
# Needs   apt-get install slurm-wlm munge
set -eu
PATH=$PATH:/usr/sbin:/sbin
what=$1 folder=$2

must() {
  "$@" || {
    echo "$1 ended with status $?" >&2
    exit 1
  }
}

start() {
  mkdir -p "$folder"/{state,spool,munge}
  chmod 755 "$folder"
  # munged wants its key and its folder to be its own, and nobody else to write there
  dd if=/dev/urandom of="$folder/munge/key" bs=128 count=1 status=none
  chown -R munge:munge "$folder/munge"
  chmod 711 "$folder/munge"
  chmod 400 "$folder/munge/key"
  must runuser -u munge -- munged --key-file="$folder/munge/key" --socket="$folder/munge/socket" \
    --pid-file="$folder/munge/pid" --log-file="$folder/munge/log" --seed-file="$folder/munge/seed"
  host=$(hostname -s)
  port=$((20000 + $$ % 20000))
  cat >"$folder/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket,cred_expire=5
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SwitchType=switch/none
MpiDefault=none
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=1,batch_sched_delay=0,bf_interval=1
ReturnToService=2
JobRequeue=1
KillWait=10
SlurmctldDebug=info
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=test Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
  export SLURM_CONF="$folder/slurm.conf"
  must slurmctld -f "$SLURM_CONF"
  must slurmd -f "$SLURM_CONF"
  for _ in $(seq 60); do
    if sinfo -h -o %T 2>/dev/null | grep -q idle; then
      echo "$SLURM_CONF"
      return
    fi
    sleep 0.25
  done
  echo "the cluster did not come up:" >&2
  tail -n 3 "$folder"/slurmctld.log "$folder"/slurmd.log >&2
  stop
  exit 1
}

stop() {
  for pid in "$folder/slurmd.pid" "$folder/slurmctld.pid" "$folder/munge/pid"; do
    if [ -s "$pid" ]; then kill "$(cat "$pid")" 2>/dev/null || true; fi
  done
}

watch() {
  cat >/dev/null
  stop
}

"$what"
