//! The chosen setting as Rust to paste.

use kahan_algebra::rational::Rational;
use kahan_measure::trade::{Kind, ScalarKind, Setting};

use super::comparison::Comparison;

/// The orbit of a setting: one statement, after the field where that is the user's own.
pub(super) fn rust_of(comparison: &Comparison<'_>, setting: &Setting) -> String {
    let Kind { scalar, compensated, .. } = setting.kind;
    let symbols = &comparison.system.field.symbols;
    let value = |value: &Rational| literal(scalar, value);
    let named = || symbols.parameters.iter().zip(comparison.parameters);
    let type_name = comparison.block.entry.map(|entry| entry.type_name);
    let header = comparison.system.header.as_ref().map(|header| header.name.text.as_str());
    let (before, map) = match type_name.or(header) {
        Some(name) if symbols.parameters.is_empty() => (String::new(), name.to_owned()),
        Some(name) => {
            let fields: Vec<String> = named().map(|(name, v)| format!("{name}: {}", value(v))).collect();
            (String::new(), format!("{name} {{ {} }}", fields.join(", ")))
        }
        None => {
            let bindings = named().map(|(name, v)| format!("let {name} = {};\n", value(v)));
            let field = comparison.block.text().trim();
            (
                format!("{}let field = kahan! {{ {field} }};\n", bindings.collect::<String>()),
                "field".to_owned(),
            )
        }
    };
    let map = if scalar == ScalarKind::F32ThroughF64 { format!("ThroughF64({map})") } else { map };
    let mut point: Vec<String> = comparison.start.iter().map(value).collect();
    if let (ScalarKind::F32 | ScalarKind::F32ThroughF64, Some(first)) = (scalar, point.first_mut()) {
        // One suffix tells the scalar of all.
        if !first.contains('_') {
            *first += "_f32";
        }
    }
    let eps = match scalar {
        ScalarKind::Dd => format!("Dd::from({:?})", setting.eps),
        _ => format!("{:?}", setting.eps),
    };
    let mut line = format!("{before}let orbit = {map}.orbit(vector![{}], {eps})", point.join(", "));
    if setting.kind.order != 2 {
        line += &format!(".composed(Composition::{})", setting.kind.composition().name());
    }
    if compensated {
        line += ".compensated()";
    }
    // x₀ and every step after it.
    line + &format!(".take({});", setting.steps + 1)
}

/// A number as the scalar's literal: the float that it rounds to, or in `Dd` all its digits.
fn literal(scalar: ScalarKind, value: &Rational) -> String {
    match scalar {
        ScalarKind::F32 | ScalarKind::F32ThroughF64 => format!("{:?}", value.to_f32()),
        ScalarKind::F64 => format!("{:?}", value.to_f64()),
        ScalarKind::Dd => {
            let (high, low) = value.to_double_double();
            if low == 0.0 { format!("Dd::from({high:?})") } else { format!("Dd::new({high:?}, {low:?})") }
        }
    }
}
