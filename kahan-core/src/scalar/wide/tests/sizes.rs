//! Tests that operations on magnitudes round by at most 2⁻⁵², and give NaN out of range.

use core::cmp::Ordering;

use num_traits::Zero;

use super::super::{Size, Wide};
use super::{Dyadic, Random};

fn dyadic(size: Size) -> Dyadic {
    Dyadic::size(size)
}

/// Returns whether `computed` and `exact` differ by at most 2^−bits of the exact number.
fn is_near(computed: &Dyadic, exact: &Dyadic, bits: i64) -> bool {
    computed.minus(exact).scaled(bits).is_within(exact)
}

#[test]
fn a_size_is_near_its_number_and_orders_as_it_does() {
    let mut random = Random(31);
    for _ in 0..10_000 {
        let [a, b] = random.pair();
        let (x, y) = (Dyadic::of(a), Dyadic::of(b));
        assert!(is_near(
            &dyadic(a.size()),
            &Dyadic { integer: x.integer.magnitude().clone().into(), ..x },
            50
        ));
        if a.size() > b.size() + b.size().scaled(-48) {
            assert!(y.is_within(&x));
        }
        assert_eq!(a.size() > b.size(), dyadic(a.size()).minus(&dyadic(b.size())).integer > Zero::zero());
        assert_eq!(Size::zero().partial_cmp(&a.size()), Some(Ordering::Less));
        assert_eq!(a.size(), (-a).size());
    }
}

#[test]
fn each_operation_rounds_by_at_most_one_part_in_2_to_the_52() {
    let mut random = Random(32);
    for _ in 0..10_000 {
        let [a, b] = random.pair().map(|number| number.size());
        let (x, y) = (dyadic(a), dyadic(b));
        assert!(is_near(&dyadic(a + b), &x.plus(&y), 52));
        assert!(is_near(&dyadic(a * b), &x.times(&y), 52));
        assert!(is_near(&dyadic(a / b).times(&y), &x, 52));
        assert!(a + Size::zero() == a && Size::zero() + a == a && (a * Size::zero()).is_zero());
    }
}

#[test]
fn doubles_come_and_go_unchanged() {
    let mut random = Random(33);
    let drawn = (0..10_000).map(|_| f64::from_bits(random.bits()).abs());
    for value in drawn.chain([0.0, 5e-324, f64::MIN_POSITIVE, f64::MAX, f64::INFINITY, f64::NAN]) {
        let back = f64::from(Size::from(value));
        assert!(back == value || (back.is_nan() && value.is_nan()), "{value:e} became {back:e}");
    }
}

#[test]
fn beyond_the_doubles_a_size_goes_on_and_beyond_its_range_nothing_is_known() {
    let (tiny, huge) = (Size::from(1e-300), Size::from(1e300));
    assert!(tiny * tiny > Size::zero() && huge * huge > huge);
    assert_eq!((f64::from(tiny * tiny), f64::from(huge * huge)), (0.0, f64::INFINITY));
    assert_eq!(f64::from(huge * huge * tiny * tiny).round(), 1.0);
    // The exponents differ by more than a 64-bit integer can hold.
    let edge = |exponent| Size::from(1.5).scaled(exponent);
    assert_eq!(edge(i64::MAX - 1) + edge(i64::MIN + 1), edge(i64::MAX - 1));
    let unknown = edge(i64::MAX - 1) * edge(i64::MAX - 1);
    for unknown in
        [unknown, edge(i64::MIN + 1) / edge(i64::MAX - 1), (Wide::from(1.0) / Wide::from(0.0)).size()]
    {
        for other in [Size::zero(), Size::from(1.0), huge, unknown] {
            assert_eq!((unknown.partial_cmp(&other), other.partial_cmp(&unknown)), (None, None));
            assert_eq!((unknown + other).partial_cmp(&other), None);
        }
        assert!(f64::from(unknown).is_nan());
    }
    let infinite = Size::from(f64::INFINITY);
    assert!(infinite > huge * huge && infinite + huge == infinite && infinite * huge == infinite);
}
