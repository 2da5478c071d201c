//! Writes the chosen setting as Rust code.

use kahan_algebra::rational::Rational;
use kahan_dynamics::{Precision, Setting};

use crate::study::Study;

/// Writes Rust code that computes the orbit. A field without a type name becomes a `kahan!` block.
pub(super) fn rust_statement(
    study: &Study,
    parameters: &[Rational],
    start: &[Rational],
    setting: &Setting,
) -> String {
    let precision = setting.scheme().precision;
    let symbols = &study.system().field.symbols;
    let value = |value: &Rational| literal(precision, value);
    let named = || symbols.parameters.iter().zip(parameters);
    let (before, map) = match study.type_name() {
        Some(name) if symbols.parameters.is_empty() => (String::new(), name.to_owned()),
        Some(name) => {
            let fields: Vec<String> = named().map(|(name, v)| format!("{name}: {}", value(v))).collect();
            (String::new(), format!("{name} {{ {} }}", fields.join(", ")))
        }
        None => {
            let bindings = named().map(|(name, v)| format!("let {name} = {};\n", value(v)));
            let field = study.text().trim();
            (
                format!("{}let field = kahan! {{ {field} }};\n", bindings.collect::<String>()),
                "field".to_owned(),
            )
        }
    };
    let mut point: Vec<String> = start.iter().map(value).collect();
    if let (true, Some(first)) = (precision.is_single(), point.first_mut()) {
        // The suffix `_f32` on the first coordinate determines the scalar of all coordinates.
        if !first.contains('_') {
            *first += "_f32";
        }
    }
    before + &setting.in_rust(&map, &format!("vector![{}]", point.join(", ")))
}

/// Writes a number as a literal of the scalar: the nearest float, or a `Dd` with all its digits.
fn literal(precision: Precision, value: &Rational) -> String {
    match precision {
        Precision::Single | Precision::SingleThroughDouble => format!("{:?}", value.to_f32()),
        Precision::Double => format!("{:?}", value.to_f64()),
        Precision::DoubleDouble => {
            let (high, low) = value.to_double_double();
            if low == 0.0 { format!("Dd::from({high:?})") } else { format!("Dd::new({high:?}, {low:?})") }
        }
    }
}
