//! Times the compilation of steps, integrals and ensembles to machine code.

use std::hint::black_box;

use kahan_bench_fields::serve::Task;
use kahan_bench_fields::{EPS, block_of, start};
use kahan_runtime::{Field, FieldText, Map};

use crate::pair::timed;

const RATES: [(&str, f64); 3] = [("a1", 1.1), ("a2", -2.3), ("a3", 1.7)];
const WEIGHTS: [(&str, f64); 3] = [("w1", 1.0), ("w2", 1.7), ("w3", 2.9)];

pub(crate) fn all() -> Vec<Task> {
    let (e6, euler, clebsch) = (
        include_str!("../../../systems/src/catalog/e6.rs"),
        include_str!("../../../systems/src/catalog/euler.rs"),
        include_str!("../../../systems/src/catalog/clebsch.rs"),
    );
    let mut tasks = Vec::new();
    tasks.extend(field("E6", e6, &[], &start::SPACE));
    tasks.extend(field("EulerTop", euler, &RATES, &start::SPACE));
    tasks.extend(field("Clebsch", clebsch, &WEIGHTS, &start::CLEBSCH));
    tasks
}

type Use = fn(&Map, &[f64]);

fn field(
    system: &'static str,
    file: &'static str,
    values: &'static [(&'static str, f64)],
    state: &'static [f64],
) -> [Task; 2] {
    let text = block_of(file).unwrap_or_else(|| panic!("{system}: a file without a block"));
    let text = FieldText::new(text.to_owned(), system.to_owned());
    let read = text.unproved_system().unwrap_or_else(|mistakes| panic!("{system}: {mistakes}"));
    let task = |what, first_use: Use| {
        let read = read.clone();
        let time = move || {
            let field = Field::of(&read);
            let map = field.with(values.iter().copied()).expect("a value for each parameter");
            black_box(field.derived().step());
            timed(|| first_use(&map, state))
        };
        Task {
            system,
            what,
            operations: 0,
            seconds: Box::new(move |units| units as f64 * median(units, &time)),
        }
    };
    [task("compiling: step and integrals", with_integrals), task("compiling: step and columns", with_columns)]
}

fn median(count: usize, time: impl Fn() -> f64) -> f64 {
    let mut times: Vec<f64> = (0..count).map(|_| time()).collect();
    times.sort_by(f64::total_cmp);
    times.get(count / 2).copied().unwrap_or(0.0)
}

fn with_integrals(map: &Map, state: &[f64]) {
    let mut integrals = vec![0.0; map.field().integrals().len()];
    map.at(EPS).integrals(state, &mut integrals).expect("an entry for each integral");
    black_box(integrals);
}

fn with_columns(map: &Map, state: &[f64]) {
    let mut columns: Vec<[f64; 8]> = state.iter().map(|x| [*x; 8]).collect();
    let mut columns: Vec<&mut [f64]> = columns.iter_mut().map(|column| &mut column[..]).collect();
    map.at(EPS).advance_columns(&mut columns, &[], &[], 1).expect("a column for each variable");
    black_box(columns);
}
