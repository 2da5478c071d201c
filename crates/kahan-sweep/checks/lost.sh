# What a kill costs: a long part is killed after 12 s and gone on with; processor time is compared.
# Enough orbits for all threads, each far shorter than the time between two notes.
a_plan long.toml 160 600000 1000000
# seconds COMMAND…: processor time of a command and of what it waited for.
seconds() {
    { TIMEFORMAT=%U; time "$@" >/dev/null 2>&1; } 2>&1
}
killed_after() {
    kahan-sweep long.toml --out killed &
    sleep "$1"
    kill -KILL $!
    # The shell hears of its end only here.
    wait $! || true
}
whole=$(seconds kahan-sweep long.toml --out whole)
begun=$(seconds killed_after 12)
(($(parts killed) == 0)) || fail "the part was done before it was killed"
rest=$(seconds kahan-sweep long.toml --out killed)
cmp whole/results.parquet killed/results.parquet
lost=$(echo "$begun + $rest - $whole" | bc)
(($(echo "$rest < $whole - 5 && $lost <= 30 * $(nproc)" | bc))) || fail "of $whole s, $begun s and then $rest s: $lost s"
echo "of $whole s of processor time on $(nproc) cores $begun s were done when it was killed, and $rest s were left: $lost s were lost"
