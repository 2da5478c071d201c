//! Maps of fields read at run time give back all memory when they are dropped.
//!
//! The allocator of this program counts what a thread allocates and frees while it is measured.

use allocation_counter::measure;
use kahan_algebra::lexer::lex;
use kahan_algebra::rational::Rational;
use kahan_core::Dd;
use kahan_core::prelude::*;
use kahan_runtime::interpreted::{Interpreted, round};

/// More digits than a ratio of small integers has, in the field and in what is given for it.
const TEXT: &str = "xdot = y + 0.1234567890123456789*x^2; ydot = mu*x*y - x;";
const MU: &str = "123456789012345678901234567890/98765432109876543210987654321";

/// Reads the field, puts it over three scalars and follows an orbit of each.
fn follow() {
    let reading = kahan_algebra::read(&lex(TEXT).tokens);
    let number = |text| Rational::parse(text).unwrap();
    let exact = Interpreted::<BigRational, 2>::new(&reading.system, &[number(MU).to_big()]).unwrap();
    let start = vector![round::<BigRational>(&number("0.3")), round(&number("0"))];
    assert!(exact.orbit(start, number("0.01").to_big()).nth(3).is_some());
    let last = exact.rounded::<f64>().orbit(vector![0.3, 0.0], 0.01).nth(3).unwrap();
    let wide = exact.rounded::<Dd>().orbit(vector![Dd::from(0.3), Dd::from(0.0)], Dd::from(0.01)).nth(3);
    assert!((wide.unwrap().map(f64::from) - last).amax() < 1e-15);
}

#[test]
fn maps_that_were_dropped_hold_no_memory() {
    // What is made once for the whole program.
    follow();
    let counted = measure(|| (0..50).for_each(|_| follow()));
    assert!(counted.count_total > 0, "nothing is counted");
    assert_eq!(counted.bytes_current, 0);
}

/// Registers are on the stack, and what ε and the parameters fix is computed once.
#[test]
fn steps_of_floats_allocate_nothing() {
    fn count<T: Scalar, const N: usize>(map: &Interpreted<T, N>, x: SVector<T, N>, eps: T) -> u64 {
        let at = map.at(eps);
        let counted = measure(|| {
            let last = (0..100).fold(x.clone(), |x, _| at.step(&x));
            assert!(last != x && map.field(&last) != x, "nothing is computed");
        });
        counted.count_total
    }
    let reading = kahan_algebra::read(&lex(TEXT).tokens);
    let mu = Rational::parse(MU).unwrap().to_big();
    let exact = Interpreted::<BigRational, 2>::new(&reading.system, &[mu]).unwrap();
    assert_eq!(count(&exact.rounded::<f64>(), vector![0.3, 0.0], 0.01), 0);
    assert_eq!(count(&exact.rounded::<f32>(), vector![0.3, 0.0], 0.01), 0);
    assert_eq!(count(&exact.rounded::<Dd>(), vector![Dd::from(0.3), Dd::from(0.0)], Dd::from(0.01)), 0);
}
