//! Run-time maps free all their memory when they are dropped.

use allocation_counter::measure;
use kahan_algebra::rational::Rational;
use kahan_core::prelude::*;
use kahan_core::{Composition, Dd};
use kahan_runtime::interpreted::{Interpreted, round};
use kahan_runtime::{Field, MachineFloat, Map};

/// The field and a parameter have numbers with too many digits for a ratio of machine integers.
const TEXT: &str = "xdot = y + 0.1234567890123456789*x^2; ydot = mu*x*y - x;";
const MU: &str = "123456789012345678901234567890/98765432109876543210987654321";

fn exact() -> Interpreted<BigRational, 2> {
    let map = Field::parse(TEXT).unwrap().with([("mu", Rational::parse(MU).unwrap())]).unwrap();
    map.as_kahan_map().unwrap()
}

fn follow() {
    let number = |text| Rational::parse(text).unwrap();
    let exact = exact();
    let start = vector![round::<BigRational>(&number("0.3")), round(&number("0"))];
    assert!(exact.orbit(start, number("0.01").to_big()).nth(3).is_some());
    let last = exact.rounded::<f64>().orbit(vector![0.3, 0.0], 0.01).nth(3).unwrap();
    let wide = exact.rounded::<Dd>().orbit(vector![Dd::from(0.3), Dd::from(0.0)], Dd::from(0.01)).nth(3);
    assert!((wide.unwrap().map(f64::from) - last).amax() < 1e-15);
}

#[test]
fn maps_that_were_dropped_hold_no_memory() {
    follow();
    let counted = measure(|| (0..50).for_each(|_| follow()));
    assert!(counted.count_total > 0, "nothing is counted");
    assert_eq!(counted.bytes_current, 0);
}

/// Steps do not allocate: registers are on the stack, and constants are computed only once.
#[test]
fn steps_of_floats_allocate_nothing() {
    fn count<T: Scalar, const N: usize>(map: &Interpreted<T, N>, x: SVector<T, N>, eps: T) -> u64 {
        let at = map.at(eps);
        let slope = map.field(&x);
        let counted = measure(|| {
            let last = (0..100).fold(x.clone(), |x, _| at.step(&x));
            assert!(last != x && map.field(&last) != slope, "nothing is computed");
        });
        counted.count_total
    }
    let exact = exact();
    assert_eq!(count(&exact.rounded::<f64>(), vector![0.3, 0.0], 0.01), 0);
    assert_eq!(count(&exact.rounded::<f32>(), vector![0.3, 0.0], 0.01), 0);
    assert_eq!(count(&exact.rounded::<Dd>(), vector![Dd::from(0.3), Dd::from(0.0)], Dd::from(0.01)), 0);
}

/// Returns a field of many variables, sparse or with all variables in each equation.
fn field_in(n: usize, is_dense: bool) -> Field {
    let terms = |i: usize| if is_dense { (0..n).collect() } else { vec![i, (i + 1) % n] };
    let equation = |i: usize| {
        let terms: Vec<String> =
            terms(i).iter().map(|j| format!("{}/7*x{j}*x{}", i + j + 1, (i + j) % n)).collect();
        format!("x{i}dot = a - {};", terms.join(" - "))
    };
    Field::parse(&(0..n).map(equation).collect::<String>()).unwrap()
}

fn no_step_allocates<T: MachineFloat>(n: usize, is_dense: bool) {
    let map = field_in(n, is_dense).with([("a", 0.5)]).unwrap();
    let eps: T = round(&Rational::new(1, 100));
    for at in [map.at(eps), map.at(eps).composed(Composition::KAHAN_LI_8), map.at(T::zero())] {
        let [mut x, mut carry, mut next] = [eps, T::zero(), eps].map(|value| vec![value; n]);
        let (mut columns, each) = (vec![vec![eps; 21]; n], [eps; 21]);
        let mut columns: Vec<&mut [T]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        let mut run = || {
            at.step(&x, &mut next).unwrap();
            at.advance(&mut x, 3).unwrap();
            at.advance_with_carry(&mut x, &mut carry, 3).unwrap();
            at.field(&x, &mut next).unwrap();
            at.advance_columns(&mut columns, &[], &[], 9).unwrap();
            at.advance_columns(&mut columns, &each, &[&each], 9).unwrap();
        };
        // The first runs trigger the compilation of the elimination's code.
        (0..4).for_each(|_| run());
        assert_eq!(measure(run).count_total, 0, "{n} variables, {eps:?}");
    }
}

#[test]
fn no_step_of_slices_allocates() {
    for (n, is_dense) in [(1, false), (3, true), (9, true), (20, false)] {
        no_step_allocates::<f64>(n, is_dense);
        no_step_allocates::<f32>(n, is_dense);
    }
}

#[test]
fn maps_and_fields_of_slices_that_were_dropped_hold_no_memory() {
    let step = |map: &Map| {
        let (mut x, mut y) = ([0.25, 0.5], [0.5, 0.25]);
        map.at(0.01).advance(&mut x, 2).unwrap();
        map.at(0.01).step(&[0.25, 0.5], &mut [0.0; 2]).unwrap();
        map.at(0.01_f32).step(&[0.25, 0.5], &mut [0.0; 2]).unwrap();
        map.at(0.01).jacobian(&x, &mut [0.0; 4]).unwrap();
        map.at(0.01).advance_columns(&mut [&mut x, &mut y], &[], &[], 2).unwrap();
    };
    let number = Rational::parse(MU).unwrap();
    let read = || Field::parse(TEXT).unwrap();
    let kept = read();
    step(&kept.with([("mu", &number)]).unwrap());

    let maps = measure(|| {
        for k in 0..10_000 {
            let map = kept.with([("mu", k)]).unwrap();
            map.at(0.01).step(&[0.25, 0.5], &mut [0.0; 2]).unwrap();
        }
    });
    assert!(maps.count_total > 0, "nothing is counted");
    assert_eq!(maps.bytes_current, 0, "maps");
    let fields = measure(|| (0..200).for_each(|_| step(&read().with([("mu", &number)]).unwrap())));
    assert_eq!(fields.bytes_current, 0, "fields");
}
