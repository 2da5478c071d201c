# GNU parallel: five shards, two at a time, one killed and named again.
need parallel parallel
shards() {
    parallel --will-cite --jobs 2 kahan-sweep plan.toml --out results --shard {}/5 --threads 1 ::: 1 2 3 4 5
}
shards >first.log 2>&1 &
until_parts results 4
kill -KILL "$(sweeps | head -n 1)"
wait $! && fail "a shard was killed, and parallel did not say so"
kahan-sweep plan.toml --out results --status && fail "nothing is missing, with a shard killed"
shards >second.log 2>&1 || fail "$(cat second.log)"
merges_to_the_same results
echo "five shards, one killed in the middle and run again: the same bytes"
