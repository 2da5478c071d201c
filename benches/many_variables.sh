#!/usr/bin/env bash
# many_variables.sh [SITES…]: Volterra's ring as a block of so many variables (24, 48 and 200 unless
# told): what its crate takes to build beyond the library, in seconds, with step, try_step and
# jacobian called, and what each of them takes, in microseconds, the least of five rounds.
set -euo pipefail

checkout=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/src"
cat >"$folder/Cargo.toml" <<MANIFEST
[package]
name = "ring"
version = "0.0.0"
edition = "2024"

[workspace]

[dependencies]
kahan-core = { path = "$checkout/kahan-core" }
MANIFEST
cp "$checkout/Cargo.lock" "$folder/"

# ring SITES: the equations of the ring.
ring() {
    for ((i = 0; i < $1; i++)); do
        echo "    x${i}dot = x$i*(x$(((i + 1) % $1)) - x$(((i + $1 - 1) % $1)));"
    done
}

# program SITES: times of the three functions, as one line.
program() {
    cat <<PROGRAM
use std::hint::black_box;
use std::time::Instant;

use kahan_core::prelude::*;

kahan! {
    pub struct Ring;
$(ring "$1")
}

fn microseconds(runs: u32, mut run: impl FnMut()) -> f64 {
    let round = |_| {
        let begin = Instant::now();
        (0..runs).for_each(|_| run());
        begin.elapsed().as_secs_f64() * 1e6 / f64::from(runs)
    };
    (0..5).map(round).fold(f64::INFINITY, f64::min)
}

fn main() {
    let at = Ring.at(black_box(0.01));
    let mut x: SVector<f64, $1> = SVector::from_fn(|i, _| 1.0 + 0.5 * (0.7 * i as f64).sin());
    let step = microseconds(50_000, || x = at.step(&x));
    let promised = microseconds(2_000, || x = at.try_step(&x).expect("no pole is near"));
    let jacobian = microseconds(500, || {
        black_box(at.jacobian(black_box(&x)));
    });
    println!("step {step:.3} us, try_step {promised:.1} us, jacobian {jacobian:.1} us");
}
PROGRAM
}

cd "$folder"
echo 'fn main() {}' >src/main.rs
cargo build --release --quiet
for sites in "${@:-24 48 200}"; do
    for n in $sites; do
        program "$n" >src/main.rs
        begin=$(date +%s.%N)
        cargo build --release --quiet
        built=$(echo "$(date +%s.%N) - $begin" | bc)
        echo "$n variables: built in ${built:0:4} s; $(./target/release/ring)"
    done
done
