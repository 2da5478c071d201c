//! A process that times the tiers of one step when it is asked to.

mod tasks;

fn main() -> std::io::Result<()> {
    kahan_bench_fields::serve::serve(&tasks::all())
}
