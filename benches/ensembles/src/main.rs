//! A process that times ensembles of trajectories on request. The benchmarks alternate between a
//! build for all processors and a build for this processor.

mod bounds;
mod counted;
mod tasks;

fn main() -> std::io::Result<()> {
    kahan_bench_fields::serve::serve(&tasks::all())
}
