# Slurm (Debian's slurm-wlm): a real slurmctld and slurmd on this machine, and the array job of --for slurm.
need munged munge
need slurmctld slurmctld
need slurmd slurmd
need sbatch slurm-client
[[ $(id -u) == 0 ]] || not_run "slurmd starts jobs as root only"

# A cluster of one node, without systemd, with a key and ports of its own.
head -c 128 /dev/urandom >munge.key
chmod 600 munge.key
munged --foreground --force --key-file="$PWD/munge.key" --socket="$PWD/munge.socket" --pid-file="$PWD/munged.pid" \
    --log-file="$PWD/munged.log" --seed-file="$PWD/munged.seed" >munged.out 2>&1 &
mkdir state spool
node=$(hostname -s)
cat >slurm.conf <<CONF
ClusterName=check
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$((20000 + $$ % 20000))
SlurmdPort=$((20001 + $$ % 20000))
SlurmUser=root
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$PWD/munge.socket
StateSaveLocation=$PWD/state
SlurmdSpoolDir=$PWD/spool
SlurmctldPidFile=$PWD/slurmctld.pid
SlurmdPidFile=$PWD/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1
MpiDefault=none
ReturnToService=2
SlurmdParameters=config_overrides
NodeName=$node NodeAddr=127.0.0.1 CPUs=2
PartitionName=check Nodes=$node Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$PWD/slurm.conf
slurmctld -D >slurmctld.log 2>&1 &
slurmd -D -N "$node" >slurmd.log 2>&1 &
for ((i = 0; i < 60; i++)); do
    [[ $(sinfo --noheader --format=%T 2>/dev/null) == idle ]] && break
    sleep 0.5
done
((i < 60)) || not_run "the node does not come up: $(tail -n 3 slurmctld.log slurmd.log)"

kahan-sweep plan.toml --out results --for slurm --shards 5 >job.sh
sbatch --test-only job.sh
job=$(sbatch --parsable job.sh)
until_parts results 4
scancel --signal=KILL --batch "${job}_2"
while [[ -n $(squeue --noheader --job "$job") ]]; do
    sleep 0.5
done
kahan-sweep plan.toml --out results --status && fail "nothing is missing, with a task killed"
# The line of the script's head: what was cut short goes on when it is submitted again.
sbatch --wait job.sh
merges_to_the_same results
# Without --shard the array's variables say it.
sed -i 's| --shard "[^"]*"||; s|--out results|--out unsaid|' job.sh
sbatch --wait job.sh
merges_to_the_same unsaid
grep -qs 'Slurm started this as task 5 of 5' kahan-sweep-*-5.log || fail "the array was not recognised"
echo "an array of five, one killed in the middle and submitted again: the same bytes; without --shard: the same bytes"
