# A full disk, at every stage: nothing is half there, and with room again the same command goes on.
[[ $(id -u) == 0 ]] || not_run "a small disk is mounted as root only"
if [[ -z ${small_disk:-} ]]; then
    # What is mounted in a name space of its own goes with it.
    export small_disk=1
    exec unshare --mount --propagation private "$crate/check" disk
fi
mkdir disk
mount -t tmpfs -o size=64k check disk || not_run "no tmpfs can be mounted here"
needed=$(($(du -sk "$undisturbed/" | cut -f1)))
full=0
for percent in 1 5 20 35 50 65 80 95; do
    rm -rf disk/results
    mount -o "remount,size=$((64 + needed * percent / 100))k" disk
    status=0
    kahan-sweep plan.toml --out disk/results >full.log 2>&1 || status=$?
    ((status == 1)) || fail "status $status on a disk of $percent %: $(cat full.log)"
    grep -q '^error: .*No space left on device' full.log || fail "it does not say why: $(cat full.log)"
    [[ ! -e disk/results/results.parquet ]] || fail "there is a result of a full disk"
    same_parts disk/results
    full=$((full + 1))
    mount -o "remount,size=$((needed * 3))k" disk
    kahan-sweep plan.toml --out disk/results >/dev/null
    cmp disk/results/results.parquet "$undisturbed/results.parquet"
done
# A file that may not grow: the process is ended by a signal in the middle of a write.
bash -c 'ulimit -f 100; kahan-sweep plan.toml --out limited; exit $?' >/dev/null 2>&1 && fail "a limit of 100 kB was not met"
same_parts limited
kahan-sweep plan.toml --out limited >/dev/null
merges_to_the_same limited
# A disk that fills up while a part is under way: it is said at once, the work goes on, and is noted and
# written when there is room.
a_plan long.toml 400 300000 1000000
kahan-sweep long.toml --out whole >/dev/null
rm -rf disk/results
mount -o "remount,size=64k" disk
dd if=/dev/zero of=disk/ballast bs=1k count=60 status=none
kahan-sweep long.toml --out disk/results >long.log 2>&1 &
for ((i = 0; i < 200; i++)); do
    if grep -q '^note: .*No space left on device' long.log; then break; fi
    sleep 0.1
done
grep -q '^note: .*No space left on device' long.log || fail "nothing was said in 20 s: $(cat long.log)"
kill -0 $! || fail "the work did not go on: $(cat long.log)"
mount -o "remount,size=4m" disk
wait $! || fail "$(cat long.log)"
(($(grep -c '^note: ' long.log) == 1)) || fail "it was said again: $(cat long.log)"
cmp disk/results/results.parquet whole/results.parquet
echo "full at $full sizes, each said in a sentence; with room again the same bytes"
