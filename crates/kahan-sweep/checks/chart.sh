# A chart of the merged rows (`kahan chart --from`) is the chart of the orbits themselves, number by number.
if [[ -z ${KAHAN:-} ]]; then
    cargo build --release --locked --quiet --manifest-path "$crate/../../Cargo.toml" --bin kahan
    KAHAN=$crate/../../target/release/kahan
fi
cp "$KAHAN" "$folder/bin/kahan"
cat >cells.toml <<'PLAN'
[subject]
name = "henon-heiles"
params = { a = 1, b = 1, c = -1 }
[question]
ask = "observe"
steps = 1000
observe = ["sali", "fli", "megno", "lyapunov", "escape"]
[question.over]
x = 0
y = "-0.5:0.5:101"
p = 0.3
q = "0:0.5:51"
eps = 0.05
PLAN
kahan sweep cells.toml --out cells >/dev/null
for color in sali fli megno lyapunov escape; do
    kahan chart henon-heiles --param a=1 --param b=1 --param c=-1 --eps 0.05 --at 0,0,0.3,0 --steps 1000 \
        --over y=-1/2:1/2:+1/100 --over q=0:1/2:+1/100 --color $color --out orbits.csv >/dev/null
    kahan chart --from cells --over y --over q --color $color --out rows.csv >/dev/null
    cmp <(tail -n +2 orbits.csv) <(tail -n +2 rows.csv) || fail "$color: other numbers"
done
