//! Plans the map of a tangent vector v to ṽ for known x and x̃:
//!
//! ```text
//! A(x,ε)·(ṽ − v) = 2ε f′((x + x̃)/2)·v,
//! ```
//!
//! This is the second half of the map of the variational field. Operations come from
//! [`blocks`](crate::plan::forms::blocks).

use kahan_syntax::table::sorted_by_key;

use crate::field::Field;
use crate::symbols::Symbol;

use crate::plan::accuracy::Accuracy;
use crate::plan::forms::blocks::{BlockOrder, Blocks};
use crate::plan::forms::candidate::Candidate;
use crate::plan::writing::writer::Writer;
use crate::plan::{Node, Plan};

const ROW_ORDERS: usize = 3;
/// The most operations of a plan. A longer plan would not be faster than a second step, from which
/// a difference quotient gives ṽ.
const MOST_OPERATIONS: usize = 300;

/// Returns the plan of the image ṽ of a tangent vector v. Its inputs are x, v and x̃, where
/// `SecondState(i)` stands for x̃ᵢ. Returns `None` if every candidate loses digits in long steps.
pub(crate) fn tangent_plan(variational: &Field) -> Option<Plan> {
    let blocks = Blocks::of_tangent(variational);
    let accuracy = Accuracy::of(variational);
    let empty = Writer::empty(variational);
    let cheapest = |arrangements: &[BlockOrder], turns: usize| {
        let forms = empty.iter().flat_map(|empty| {
            arrangements.iter().flat_map(|arrangement| blocks.candidates(empty, arrangement, turns))
        });
        forms.min_by_key(|form| (form.operations, form.price)).map(|form| carried(form, variational))
    };
    let eliminating = cheapest(blocks.with_elimination().as_slice(), ROW_ORDERS);
    let whole = cheapest(&blocks.without_elimination(ROW_ORDERS, MOST_OPERATIONS), 1);
    let forms = [eliminating, whole].into_iter().flatten();
    let cheap_first = sorted_by_key(forms, |form| form.cost().operations());
    cheap_first.into_iter().find(|form| accuracy.keeps_tangents(form))
}

fn carried(form: Candidate, variational: &Field) -> Plan {
    let Candidate { mut builder, numerators, reciprocals, .. } = form;
    let n = numerators.len();
    let carried = numerators.iter().zip(&reciprocals).enumerate().map(|(i, (&numerator, reciprocal))| {
        let increment = match reciprocal {
            Some(reciprocal) => builder.multiply(numerator, *reciprocal),
            None => numerator,
        };
        let entry = builder.input(variational.symbols.variable(Symbol::State(n + i)));
        builder.add(entry, increment)
    });
    let carried: Vec<Node> = carried.collect();
    builder.finish(&carried)
}
