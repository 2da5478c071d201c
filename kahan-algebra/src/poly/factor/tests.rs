use crate::poly::{Budget, Polynomial, Variable};
#[test]
fn smoke() {
    let v = |i| Polynomial::variable(Variable(i));
    let p = &(&v(0) * &v(0)) - &(&v(1) * &v(1));
    assert_eq!(p.factors(&mut Budget::unlimited()).factors.len(), 2);
}
