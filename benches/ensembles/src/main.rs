//! A process that times ensembles of trajectories on request.

mod bounds;
mod counted;
mod tasks;

fn main() -> std::io::Result<()> {
    kahan_bench_fields::serve::serve(&tasks::all())
}
