# Two processes on one shard, and four on one sweep, at the same time and in one folder.
for round in 1 2 3 4 5; do
    rm -rf results
    runs=()
    for arguments in '' '' '--shard 1/2' '--threads 1'; do
        # shellcheck disable=SC2086
        kahan-sweep plan.toml --out results $arguments >"run-${#runs[@]}.log" 2>&1 &
        runs+=($!)
        sleep "0.0$round"
    done
    for run in "${!runs[@]}"; do
        wait "${runs[run]}" || fail "round $round: $(cat "run-$run.log")"
    done
    merges_to_the_same results
    left=$(find results -type f -not -name 'part-*.parquet' -not -name results.parquet)
    [[ -z $left ]] || fail "left over: $left"
done
echo "five rounds of four processes on the same parts: each ended well, the same bytes"
