//! Numbers on the command line.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
pub(crate) use kahan_study::numbers::ScalarKind;

/// Reads the name of a scalar.
pub(crate) fn scalar() -> impl TypedValueParser<Value = ScalarKind> {
    let names = ScalarKind::ALL.map(|kind| PossibleValue::new(kind.name()).help(kind.meaning()));
    PossibleValuesParser::new(names).map(|name| {
        let kind = ScalarKind::ALL.into_iter().find(|kind| kind.name() == name);
        kind.expect("clap takes no other names")
    })
}
