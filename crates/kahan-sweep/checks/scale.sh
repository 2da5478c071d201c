# 10^8 orbits of few steps in 1000 shards: what a shard, a file and the merge cost, and the memory of each.
need time time
readonly shards=${KAHAN_SHARDS_OF_SCALE:-1000}
readonly room=$((shards * 100000 * 4 * 8 * 5 / 1000000000 + 1))
(($(df --output=avail --block-size=1G . | tail -n 1) > room)) || not_run "it takes $room GB of disk"
cat >scale.toml <<PLAN
draws = $((shards * 10000))

[subject]
name = "e6"

[question]
ask = "observe"
steps = 5
observe = ["final"]

[question.over]
x = { draw = "sobol", low = -1, high = 1 }
y = { draw = "uniform", low = 0.1, high = "1/2" }
z = 1
eps = "0.01:0.1:10"

[output]
rows_per_part = 100000
columns = ["x", "y", "eps", "final_x"]
PLAN
# measured FILE COMMAND…: seconds, and KB of memory at most.
measured() {
    command time --format='%e %M' --output="$1.time" "${@:2}" >/dev/null 2>measured.log || fail "$(cat measured.log)"
}
# All in one process, without merging; then a process a shard, one after another.
measured one kahan-sweep scale.toml --out one --shard 1/1
read -r seconds memory <one.time
begun=$(date +%s%N)
for ((shard = 1; shard <= shards; shard++)); do
    kahan-sweep scale.toml --out many --shard "$shard/$shards" >/dev/null
done
apart=$((($(date +%s%N) - begun) / 1000000))
cost=$(echo "scale=1; ($apart - 1000 * $seconds) / $shards" | bc)
echo "$((shards * 100000)) orbits in one process: $seconds s, $((memory / 1024)) MB; a shard more: $cost ms"
rm -rf one

measured status kahan-sweep scale.toml --out many --status
read -r looked _ <status.time
measured merge kahan-sweep scale.toml --out many --merge
read -r merged memory_merging <merge.time
size=$(stat --format=%s many/results.parquet)
echo "--status: $looked s; --merge: $merged s, $((memory_merging / 1024)) MB, to $((size / 1000000)) MB"
(($(echo "$cost <= 50 && $merged <= 60" | bc))) || fail "a shard costs 50 ms at most, and merging 60 s"
((memory < 300 * 1024 && memory_merging < 300 * 1024)) || fail "300 MB at most"
