use kahan_syntax::rational::Rational;

use super::*;
use crate::arithmetic::Exact;
use crate::poly::Variable;

fn constants() -> Plan {
    let mut builder = PlanBuilder::default();
    let [a, b] = [2, 3].map(|v| builder.input(Variable(v)));
    let difference = builder.push(Operation::Subtract(a, b));
    builder.finish(&[difference, a])
}

fn values(constants: &Plan, kernel: &Plan) -> Vec<Option<Rational>> {
    let input = |Variable(v): Variable| Rational::from([3, -5, 7, 11][usize::from(v)]);
    let prepared = constants.evaluate(&Exact, |read| read.variable().map(input));
    kernel.evaluate(&Exact, |read| read.value(&prepared, |variable| Some(input(variable))))
}

/// If c = a − b is replaced by b − a, the results 1 − cx, −cy and −cxy need no negation.
#[test]
fn a_difference_is_prepared_the_way_that_needs_no_negation() {
    let mut builder = PlanBuilder::default();
    let [x, y] = [0, 1].map(|v| builder.input(Variable(v)));
    let c = builder.prepared(0);
    let (cx, cy) = (builder.multiply(c, x), builder.multiply(c, y));
    let one = builder.constant(&Rational::one());
    let sum = builder.push(Operation::Subtract(one, cx));
    let (product, both) = (builder.changed_sign(cy), builder.multiply(cx, y));
    let both = builder.changed_sign(both);
    let kernel = builder.finish(&[sum, product, both]);
    let (turned, chosen) = with_signs(constants(), kernel.clone());
    assert_eq!(values(&turned, &chosen), values(&constants(), &kernel));
    assert_eq!((kernel.cost().additions, chosen.cost().additions), (3, 1));
    assert!(
        !chosen.operations.iter().any(|step| matches!(step, Operation::Negate(_) | Operation::Subtract(..)))
    );
}

/// The program contains a·b + c, a·b − c and a − b·c, and a value that is used with both signs.
#[test]
fn fused_operations_keep_their_values() {
    let mut builder = PlanBuilder::default();
    let [x, y] = [0, 1].map(|v| builder.input(Variable(v)));
    let (c, a) = (builder.prepared(0), builder.prepared(1));
    let cx = builder.multiply(c, x);
    let first = builder.push(Operation::SubtractProduct(y, a, cx));
    let second = builder.push(Operation::MultiplySubtract(cx, y, first));
    let third = builder.push(Operation::MultiplyAdd(c, second, x));
    let quotient = builder.push(Operation::Divide(third, cx));
    let outputs = [first, second, third, quotient].map(|node| builder.changed_sign(node));
    let kernel = builder.finish(&outputs);
    let (turned, chosen) = with_signs(constants(), kernel.clone());
    assert_eq!(values(&turned, &chosen), values(&constants(), &kernel));
    assert!(chosen.cost().operations() < kernel.cost().operations());
}

#[test]
fn without_a_difference_nothing_changes() {
    let mut builder = PlanBuilder::default();
    let (x, a) = (builder.input(Variable(0)), builder.prepared(1));
    let product = builder.multiply(a, x);
    let negated = builder.changed_sign(product);
    let kernel = builder.finish(&[negated]);
    assert_eq!(with_signs(constants(), kernel.clone()), (constants(), kernel));
}
