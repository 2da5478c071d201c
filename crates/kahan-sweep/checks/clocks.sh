# Clocks that differ: machines in other years, one that runs fast, times of files that make no sense.
need faketime faketime
shard() {
    faketime -f "$1" kahan-sweep plan.toml --out results --shard "$2/4" >/dev/null
}
shard '@1970-01-02 00:00:00' 1 &
early=$!
shard '@2099-01-01 00:00:00' 2 &
late=$!
shard '+0 x1000' 3 &
wait "$early" && wait "$late" && wait $!
# A part under way, from the future; then the rest by a clock that stands still and one that goes slowly.
(faketime -f '+9y x400' timeout --signal=KILL 0.3 kahan-sweep plan.toml --out results --shard 4/4 >/dev/null 2>&1) || true
touch --date=2099-01-01 results/part-*.p*
touch --date=1970-01-02 results/part-00000000000*.parquet plan.toml
shard '-30y x0.01' 4
merges_to_the_same results
echo "shards of 1970, 2099, a clock 1000 times as fast and one 100 times as slow: the same bytes"
