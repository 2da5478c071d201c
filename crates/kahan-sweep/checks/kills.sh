# 200 kills at random moments, in shards, in whole runs, in the merging, and while records of what is done are written.
need faketime faketime
readonly kills=${KAHAN_KILLS:-200}
RANDOM=${KAHAN_SEED:-2024}
# With a clock that runs 400 times as fast, what is done is noted every 20 ms, not every 8 s, and kills meet it.
fast=$(dpkg -L libfaketime | grep 'libfaketime\.so')

killed=0 sweeps=0 noted=0 left=0
while ((killed < kills)); do
    rm -rf results
    mkdir results
    sweeps=$((sweeps + 1))
    until kahan-sweep plan.toml --out results --status >/dev/null && [[ -f results/results.parquet ]]; do
        case $((RANDOM % 4)) in
            0) arguments=() longest=900 ;;
            1) arguments=(--shard "$((1 + RANDOM % 2))/2") longest=900 ;;
            2) arguments=(--shard "$((1 + RANDOM % 3))/3" --threads 1) longest=900 ;;
            3) arguments=(--merge) longest=30 ;;
        esac
        environment=()
        ((RANDOM % 2)) && environment=("LD_PRELOAD=$fast" "FAKETIME=+0 x400")
        env "${environment[@]}" kahan-sweep plan.toml --out results "${arguments[@]}" >/dev/null 2>&1 &
        sleep "$(printf '0.%03d' $((RANDOM % longest)))"
        kill -KILL $! 2>/dev/null || true
        status=0
        wait $! 2>/dev/null || status=$?
        if ((status == 137)); then
            killed=$((killed + 1))
            noted=$((noted + ($(find results -name 'notes-*' | wc -l) > 0)))
        fi
        same_parts results
    done
    merges_to_the_same results
    left=$((left + $(find results -type f -not -name 'part-*.parquet' -not -name results.parquet | wc -l)))
done
((noted > kills / 20)) || fail "of $killed kills only $noted met records of what was done"
echo "$killed kills in $sweeps sweeps, $noted of them with records of what was done: the same bytes; $left files left over"
