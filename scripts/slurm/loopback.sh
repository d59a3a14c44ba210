# Sourced: a Slurm of one controller and two nodes on this machine's loopback address, in a folder of its own.
# shellcheck shell=bash
# loopback_up FOLDER, loopback_node_up N, loopback_node_halts N, loopback_node_goes_on N, loopback_node_dies N,
# loopback_down. Needs root, slurm-wlm, munge.

loopback_up() {
  loopback=$1
  mkdir -p "$loopback"/{state,log,spool-n1,spool-n2}
  mkdir -m 711 "$loopback/munge"
  (umask 277 && head -c 128 /dev/urandom > "$loopback/munge/key")
  munged --force --key-file="$loopback/munge/key" --socket="$loopback/munge/socket" --pid-file="$loopback/munge/pid" \
    --log-file="$loopback/munge/log" --seed-file="$loopback/munge/seed" --num-threads=2
  local host port
  host=$(hostname -s)
  port=$((20000 + $$ % 20000))  # two runs on one machine stay apart
  cat > "$loopback/slurm.conf" <<EOF
ClusterName=adit_loopback
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$loopback/munge/socket
CredType=cred/munge
StateSaveLocation=$loopback/state
SlurmdSpoolDir=$loopback/spool-%n
SlurmctldPidFile=$loopback/slurmctld.pid
SlurmdPidFile=$loopback/slurmd-%n.pid
SlurmctldLogFile=$loopback/log/slurmctld
SlurmdLogFile=$loopback/log/slurmd-%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_min_interval=100000
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobRequeue=0
ReturnToService=2
SlurmdTimeout=10
MailProg=/bin/true
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
EOF
  export SLURM_CONF=$loopback/slurm.conf
  slurmctld -f "$SLURM_CONF"
  loopback_node_up 1
  loopback_node_up 2
  local i
  for i in $(seq 60); do
    if [ "$(sinfo -h -t idle -o %D 2>/dev/null)" = 2 ]; then return 0; fi
    sleep 1
  done
  echo "the nodes did not come up in ${i} s:" >&2
  tail -n 20 "$loopback"/log/* >&2
  return 1
}

loopback_node_up() { slurmd -N "n$1" -f "$SLURM_CONF"; }

# What runs on a node of ours: its jobs' processes carry its name and our configuration in their environment.
loopback_processes_of() {
  local folder
  for folder in /proc/[0-9]*; do
    if grep -qzxs "SLURMD_NODENAME=n$1" "$folder/environ" 2>/dev/null &&
      grep -qzxsF "SLURM_CONF=$SLURM_CONF" "$folder/environ" 2>/dev/null; then
      echo "${folder#/proc/}"
      # The step's keeper, which slurmd started.
      local parent
      parent=$(awk '{ print $4 }' "$folder/stat" 2>/dev/null || true)
      if [ -n "$parent" ] && [ "$(cat "/proc/$parent/comm" 2>/dev/null)" = slurmstepd ]; then echo "$parent"; fi
    fi
  done | sort -u
}

# Stops all that runs on a node where it stands; prints the array task whose `adit` is among it, nothing where none is.
loopback_node_halts() {
  local pid
  for pid in $(loopback_processes_of "$1"); do kill -STOP "$pid" 2>/dev/null || true; done
  sleep 0.2  # a signal is taken when the kernel gets to it
  for pid in $(loopback_processes_of "$1"); do
    if [ "$(awk '{ print $2 $3 }' "/proc/$pid/stat" 2>/dev/null)" = '(adit)T' ]; then
      tr '\0' '\n' < "/proc/$pid/environ" | sed -n 's/^SLURM_ARRAY_TASK_ID=//p'
      return
    fi
  done
}

loopback_node_goes_on() {
  local pid
  for pid in $(loopback_processes_of "$1"); do kill -CONT "$pid" 2>/dev/null || true; done
}

# As when its power fails: nothing says goodbye.
loopback_node_dies() {
  local pid
  kill -9 "$(cat "$loopback/slurmd-n$1.pid")"
  for pid in $(loopback_processes_of "$1"); do kill -9 "$pid" 2>/dev/null || true; done
}

loopback_down() {
  local pid file
  for pid in $(loopback_processes_of 1) $(loopback_processes_of 2); do kill -9 "$pid" 2>/dev/null || true; done
  for file in "$loopback"/slurmd-n1.pid "$loopback"/slurmd-n2.pid "$loopback"/slurmctld.pid "$loopback"/munge/pid; do
    if [ -f "$file" ]; then kill "$(cat "$file")" 2>/dev/null || true; fi
  done
  # They write their last words before they go.
  for _ in $(seq 50); do
    if ! compgen -G "$loopback/*.pid" >/dev/null && [ ! -e "$loopback/munge/pid" ]; then break; fi
    sleep 0.2
  done
  rm -rf "$loopback"
}
