# Damaged parts: every byte of one flipped, every length of one cut, parts in wrong places and of other plans.
# 8 parts, small ones, so that all their bytes can be tried.
a_plan small.toml 16 50 20
kahan-sweep small.toml --out small >/dev/null
mkdir results
cp small/part-*.parquet results/
part='part-000000000003.parquet'
python3 "$crate/checks/damage.py" small.toml small "results/$part"

# merging_is_refused WORDS: with a reason of these words, and no file; then it is whole again.
merging_is_refused() {
    kahan-sweep small.toml --out results --merge >merge.log 2>&1 && fail "merged: $1"
    grep -q "$1" merge.log || fail "the reason is another than '$1': $(cat merge.log)"
    [[ ! -e results/results.parquet ]] || fail "refused, and there is a result"
    kahan-sweep small.toml --out results --status >status.log && fail "--status finds nothing: $1"
    cp small/part-*.parquet results/
}
rm results/$part
merging_is_refused '1 of 8 parts are missing'
cp small/part-000000000004.parquet results/$part
merging_is_refused 'another part under this name'
a_plan other.toml 16 50 20 8
kahan-sweep other.toml --out other >/dev/null
cp other/$part results/
merging_is_refused 'belongs to another plan'
: >results/$part
merging_is_refused 'is damaged'
kahan-sweep small.toml --out results --merge >/dev/null
cmp results/results.parquet small/results.parquet

# A run finds what is damaged, and computes it again.
rm results/results.parquet
printf 'XX' | dd of=results/$part bs=1 seek=500 conv=notrunc status=none
kahan-sweep small.toml --out results >/dev/null 2>again.log
grep -q "$part is damaged.*computed again" again.log || fail "$(cat again.log)"
cmp results/results.parquet small/results.parquet
echo "parts that are missing, misplaced, of another plan, empty: refused; a damaged one: computed again"

# Records of what is done, any byte of them flipped or cut: what is read of them is true.
need faketime faketime
a_plan one.toml 160 5000 1600
kahan-sweep one.toml --out one >/dev/null
faketime -f '+0 x4000' kahan-sweep one.toml --out begun >/dev/null 2>&1 &
until [[ $(find begun -name 'notes-*' -size +15k 2>/dev/null) ]]; do
    kill -0 $! 2>/dev/null || fail "no records before the sweep ended"
    sleep 0.01
done
kill -KILL "$(sweeps)"
wait $! 2>/dev/null || true
records=$(find begun -name 'notes-*')
RANDOM=7
for ((i = 0; i < 40; i++)); do
    rm -rf damaged
    cp -r begun damaged
    file=damaged/${records#begun/} size=$(stat -c %s "$records")
    at=$(((RANDOM * 32768 + RANDOM) % size))
    if ((i % 2)); then
        printf 'X' | dd of="$file" bs=1 seek="$at" conv=notrunc status=none
    else
        truncate --size="$at" "$file"
    fi
    kahan-sweep one.toml --out damaged >/dev/null
    cmp damaged/results.parquet one/results.parquet
done
echo "40 damaged files of records: the same bytes"
