# MPI (Debian's Open MPI): four ranks take a shard each; no MPI is linked.
need mpirun openmpi-bin
mpirun --allow-run-as-root -n 4 --oversubscribe kahan-sweep plan.toml --out results >ranks.log 2>&1 ||
    fail "$(cat ranks.log)"
# mpirun mixes what ranks say at the same time.
(($(grep -o 'Open MPI started this as task [1-4] of 4' ranks.log | sort -u | wc -l) == 4)) || fail "$(cat ranks.log)"
merges_to_the_same results
# A rank that dies takes the others with it; the same command goes on.
mpirun --allow-run-as-root -n 4 --oversubscribe kahan-sweep plan.toml --out again >again.log 2>&1 &
until_parts again 4
kill -KILL "$(sweeps | head -n 1)"
wait $! && fail "a rank was killed, and mpirun did not say so"
same_parts again
mpirun --allow-run-as-root -n 3 --oversubscribe kahan-sweep plan.toml --out again >again.log 2>&1 ||
    fail "$(cat again.log)"
merges_to_the_same again
echo "four ranks: the same bytes; one of four killed, then three ranks: the same bytes"
