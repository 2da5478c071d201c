//! A process that times steps of different kinds on request, such as fast, compensated and stable.

mod tasks;

fn main() -> std::io::Result<()> {
    kahan_bench_fields::serve::serve(&tasks::all())
}
