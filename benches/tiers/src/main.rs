//! A process that times, on request, all tiers of one step.

mod tasks;

fn main() -> std::io::Result<()> {
    kahan_bench_fields::serve::serve(&tasks::all())
}
