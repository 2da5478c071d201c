# Dask (PyPI's dask and distributed): a real scheduler and two workers, one killed in the middle.
python_with dask distributed
dask scheduler --host 127.0.0.1 --port 0 --no-dashboard --scheduler-file scheduler.json >scheduler.log 2>&1 &
workers=()
for name in first second; do
    dask worker --scheduler-file scheduler.json --host 127.0.0.1 --nthreads 1 --no-nanny --no-dashboard --name "$name" \
        --local-directory "$name" >"$name.log" 2>&1 &
    workers+=($!)
done
for ((i = 0; i < 60; i++)); do
    grep -q tcp scheduler.json 2>/dev/null && break
    sleep 0.5
done
address=$(python -c 'import json; print(json.load(open("scheduler.json"))["address"])')
python "$crate/examples/dask_shards.py" "$address" plan.toml results 6 >shards.log 2>&1 &
shards=$!
until_parts results 4
# What it was running goes on as an orphan, while the other worker does the same shard.
kill -KILL "${workers[0]}"
wait "${workers[0]}" 2>/dev/null || true
wait "$shards" || fail "$(tail -n 3 shards.log)"
merges_to_the_same results
echo "six futures on two workers, one killed in the middle: the same bytes"
