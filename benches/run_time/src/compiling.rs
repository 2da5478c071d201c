//! From a plan to machine code: the step and the integrals of fields of the catalog.

use std::hint::black_box;

use kahan_bench_fields::serve::Task;
use kahan_bench_fields::{EPS, block_of, start};
use kahan_runtime::{Field, FieldText};

use crate::pair::timed;

/// The parameters of Clebsch's field.
const WEIGHTS: [(&str, f64); 3] = [("w1", 1.0), ("w2", 1.7), ("w3", 2.9)];

/// The fields with their claims, one of three variables and one of six.
pub(crate) fn all() -> [Task; 2] {
    let (e6, clebsch) = (
        include_str!("../../../systems/src/catalog/e6.rs"),
        include_str!("../../../systems/src/catalog/clebsch.rs"),
    );
    [field("E6", e6, &[], &start::SPACE), field("Clebsch", clebsch, &WEIGHTS, &start::CLEBSCH)]
}

/// A unit is a field that is planned and was never compiled; what is told is so many times the
/// median.
fn field(
    system: &'static str,
    file: &'static str,
    values: &'static [(&'static str, f64)],
    state: &'static [f64],
) -> Task {
    let text = block_of(file).unwrap_or_else(|| panic!("{system}: a file without a block"));
    let text = FieldText::new(text.to_owned(), system.to_owned());
    let read = text.unproved_system().unwrap_or_else(|mistakes| panic!("{system}: {mistakes}"));
    let seconds = move |units: usize| {
        let mut times: Vec<f64> = (0..units)
            .map(|_| {
                let field = Field::of(&read);
                let map = field.with(values.iter().copied()).expect("a value for each parameter");
                black_box(field.derived().step());
                let mut integrals = vec![0.0; field.integrals().len()];
                timed(|| {
                    let at = map.at(EPS);
                    at.integrals(state, &mut integrals).expect("an entry for each integral");
                    black_box((&at, &integrals));
                })
            })
            .collect();
        times.sort_by(f64::total_cmp);
        times.get(units / 2).map_or(0.0, |median| median * units as f64)
    };
    Task { system, what: "compiling", operations: 0, seconds: Box::new(seconds) }
}
