//! Tests literals: floats are correctly rounded, and exact numbers stay exact.

use crate::{Constant, Scalar};

/// The constant −(2⁶⁴ + 1)/3, written as the macro writes long literals.
const LONG: Constant<'_> = Constant::exact(
    true,
    &[1, 1],
    &[3],
    -(0x5555_5555_5555_5555_u64 as f32),
    -(0x5555_5555_5555_5400_u64 as f64),
    -(0x155 as f64 + 2.0 / 3.0),
);

#[test]
fn integers_round_to_nearest() {
    let n = Constant::integer((1 << 53) + 1);
    assert_eq!(n.to_f64(), 9_007_199_254_740_992.0);
    assert_eq!(n.to_double_double(), (9_007_199_254_740_992.0, 1.0));
    assert_eq!(Constant::integer((1 << 24) + 1).to_f32(), 16_777_216.0);
    assert_eq!(Constant::integer(i64::MAX).to_double_double(), (9_223_372_036_854_775_808.0, -1.0));
    assert_eq!(Constant::integer(i64::MIN).to_double_double(), (-9_223_372_036_854_775_808.0, 0.0));
}

#[test]
fn ratios_are_the_literals_that_they_spell() {
    assert_eq!(Constant::ratio(1, 10).to_f64(), 0.1);
    assert_eq!(Constant::ratio(1, 10).to_f32(), 0.1);
    assert_eq!(Constant::ratio(-3, 2000).to_f64(), -1.5e-3);
    assert_eq!(f64::constant(&Constant::ratio(22, 7)), 22.0 / 7.0);
    assert_eq!(f32::constant(&Constant::ratio(22, 7)), 22.0 / 7.0);
}

#[test]
fn constants_can_be_static_data() {
    const TENTH: Constant<'_> = Constant::ratio(1, 10);
    static ALL: [Constant<'_>; 3] = [Constant::integer(2), TENTH, LONG];
    assert_eq!(ALL.map(|c| c.to_f64() < 0.0), [false, false, true]);
}

#[test]
#[should_panic(expected = "up to 2^24")]
fn a_ratio_beyond_the_exact_range_is_refused() {
    let _ = Constant::ratio(1, (1 << 24) + 1);
}

#[cfg(feature = "exact")]
mod exact {
    use num_traits::{Signed, Zero};

    use super::{Constant, LONG, Scalar};
    use crate::tests::rationals::{Q, q};

    fn rational(x: f64) -> Q {
        Q::from_float(x).unwrap()
    }

    #[test]
    fn constants_are_the_numbers_themselves() {
        assert_eq!(Q::constant(&Constant::integer(-7)), q(-7, 1));
        assert_eq!(Q::constant(&Constant::ratio(6, 4)), q(3, 2));
        assert_eq!(Q::constant(&Constant::exact(false, &[], &[1], 0.0, 0.0, 0.0)), Q::zero());
        let power = Q::from_integer(num_bigint::BigInt::from(1_u128 << 64));
        assert_eq!(Q::constant(&LONG), -(power + q(1, 1)) / q(3, 1));
    }

    /// Returns whether |x − approximation| ≤ unit·|x|.
    fn is_rounded(x: &Q, approximation: f64, unit: f64) -> bool {
        (x - rational(approximation)).abs() <= x.abs() * rational(unit)
    }

    #[test]
    fn each_part_of_a_constant_is_what_the_parts_before_it_leave_rounded() {
        let limit = 1 << 24;
        let ratios =
            [(1, 3), (1, 10), (-22, 7), (1, limit), (limit, 1), (limit - 1, limit - 3), (355, 113), (0, 1)];
        let ratios = ratios.map(|(n, d)| Constant::ratio(n, d));
        for constant in ratios.into_iter().chain([LONG, Constant::integer(i64::MAX)]) {
            let exact = constant.to_ratio();
            let (high, low) = constant.to_double_double();
            let left = &exact - rational(high);
            assert!(is_rounded(&exact, f64::from(constant.to_f32()), f64::from(f32::EPSILON) / 2.0));
            assert!(is_rounded(&exact, high, f64::EPSILON / 2.0));
            assert!(is_rounded(&left, low, f64::EPSILON / 2.0));
            assert_eq!(high, constant.to_f64());
        }
    }
}
