//! A process that times, on request, the tiers of a step: fast, compensated, projective, stable, …

mod tasks;

fn main() -> std::io::Result<()> {
    kahan_bench_fields::serve::serve(&tasks::all())
}
