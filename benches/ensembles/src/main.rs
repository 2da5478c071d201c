//! A process that times ensembles when it is asked to: several builds of it, for the processor at
//! large and for this one, are timed in turns by the benchmarks.

mod bounds;
mod counted;
mod tasks;

fn main() -> std::io::Result<()> {
    kahan_bench_fields::serve::serve(&tasks::all())
}
