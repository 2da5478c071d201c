//! A process that times fields read at run time, and the macro's code, on request.

mod chains;
mod columns;
mod compiling;
mod pair;

use kahan_bench_fields::serve::{Task, serve};
use kahan_bench_fields::{self as fields, Clebsch, EulerTop, Lorenz, SOURCES, Source, start};
use kahan_core::ExtendScalars;

use pair::Pair;

fn main() -> std::io::Result<()> {
    let [lotka_volterra, top, e1, e3, e5, e6, lorenz, clebsch] = SOURCES;
    let mut tasks = Vec::new();
    tasks.extend(system(lotka_volterra, fields::LotkaVolterra, &[], start::LOTKA_VOLTERRA));
    let EulerTop { a1, a2, a3 } = fields::euler_top();
    tasks.extend(system(top, fields::euler_top(), &[("a1", a1), ("a2", a2), ("a3", a3)], start::SPACE));
    tasks.extend(system(e1, fields::E1, &[], start::SPACE));
    tasks.extend(system(e3, fields::E3, &[], start::SPACE));
    tasks.extend(system(e5, fields::E5, &[], start::SPACE));
    tasks.extend(system(e6, fields::E6, &[], start::SPACE));
    let Lorenz { sigma, rho, beta } = fields::lorenz();
    let values = [("sigma", sigma), ("rho", rho), ("beta", beta)];
    tasks.extend(system(lorenz, fields::lorenz(), &values, start::LORENZ));
    let Clebsch { w1, w2, w3 } = fields::clebsch();
    tasks.extend(system(clebsch, fields::clebsch(), &[("w1", w1), ("w2", w2), ("w3", w3)], start::CLEBSCH));
    tasks.extend(compiling::all());
    serve(&tasks)
}

fn system<M, const N: usize>(
    source: Source,
    generated: M,
    values: &[(&str, f64)],
    start: [f64; N],
) -> Vec<Task>
where
    M: ExtendScalars<f64, N> + Sync + Copy + 'static,
    M::Prepared: Sync,
{
    let pair = Pair::new(source, generated, values, start);
    let mut tasks = chains::of(&pair);
    tasks.extend(columns::of(&pair));
    tasks
}
