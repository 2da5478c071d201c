//! A process that times ensembles on request. The benchmarks time several builds of it in turns,
//! for all processors and for this one.

mod bounds;
mod counted;
mod tasks;

fn main() -> std::io::Result<()> {
    kahan_bench_fields::serve::serve(&tasks::all())
}
