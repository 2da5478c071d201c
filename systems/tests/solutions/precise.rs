//! Tests the 256-bit number type: rounding, text, undefined values and elementary functions.

use kahan_core::Pivot;
use kahan_core::num_traits::Zero;
use kahan_core::prelude::*;
use kahan_systems::special::{Float256, Real};

use crate::solutions::exact_orbits::rational;
use crate::solutions::measure::{assert_close, number};

fn power_of_two(n: usize) -> BigRational {
    BigRational::from_integer(kahan_core::num_traits::pow(2.into(), n))
}

#[test]
fn rationals_are_rounded_once_to_nearest_with_ties_to_even() {
    // The numbers 2²⁵⁶ + 1 and 2²⁵⁶ + 3 are midway between two floats, and round to the even one.
    let of = |offset: &str| Float256::from_rational(&(power_of_two(256) + rational(offset)));
    assert_eq!(of("1"), of("0"));
    assert_eq!(of("3"), of("4"));
    assert_ne!(of("2"), of("0"));
    assert_eq!(of("1000000000000000001/1000000000000000000"), of("2"));
    assert_eq!(of("999999999999999999/1000000000000000000"), of("0"));
    assert_eq!(of("-1/2").to_digits(20), of("0").to_digits(20));
    let third = Float256::from_rational(&rational("-1/3"));
    assert_eq!(third, Float256::from_int(-1) / Float256::from_int(3));
    assert_eq!(Float256::epsilon(), Float256::from_rational(&(rational("1") / power_of_two(255))));
    assert_ne!(Float256::from_int(1) + Float256::epsilon(), Float256::from_int(1));
}

#[test]
fn text_is_read_and_written() {
    for (text, fraction) in
        [("-1.5e-3", "-3/2000"), ("0.1", "1/10"), ("1e3", "1000/1"), ("+7", "7"), ("-3/7", "-3/7")]
    {
        assert_eq!(number(text), Float256::from_rational(&rational(fraction)), "{text}");
    }
    for text in ["", "x", "1/0", "1/x", "0x10", "1e999999999", "1.5/2", "--1"] {
        assert!(text.parse::<Float256>().is_err(), "{text}");
    }
    let message = "1/0".parse::<Float256>().unwrap_err().to_string();
    assert!(message.starts_with("`1/0` is not a number"), "{message}");
    let written = |text: &str, digits: usize| number(text).to_digits(digits);
    assert_eq!(written("2/3", 10), "0.6666666667");
    assert_eq!(written("-200/3", 5), "-66.667");
    assert_eq!(written("1/2", 4), "0.5000");
    assert_eq!(written("123456", 3), "1.23e5");
    assert_eq!(written("99999", 3), "1.00e5");
    assert_eq!(written("-1/30000000", 3), "-3.33e-8");
    assert_eq!(written("0", 9), "0");
    assert_eq!(written("5", 1), "5");
    assert_eq!(format!("{:.4} {:?}", number("1/3"), Float256::UNDEFINED), "0.3333 undefined");
    for text in ["1/3", "-17e40", "123/457"] {
        assert_eq!(number(&number(text).to_digits(80)), number(text));
    }
}

#[test]
fn what_is_not_real_is_undefined_and_spreads() {
    let (zero, one) = (Float256::zero(), Float256::from_int(1));
    let undefined = [
        one / zero,
        zero / zero,
        Float256::from_int(-1).sqrt(),
        zero.ln(),
        Float256::from_int(-1).ln(),
        one.atanh(),
        Float256::from_int(-1).power_real(&Float256::half()),
        zero.power_real(&Float256::from_int(-1)),
        zero.gamma(),
        Float256::from_int(-3).digamma(),
        f64::NAN.into(),
        f64::INFINITY.into(),
    ];
    for value in undefined {
        assert!(!value.is_defined() && !value.is_finite_number() && value.to_f64().is_nan(), "{value}");
        assert!(value != value && value.partial_cmp(&one).is_none() && !value.magnitude_exceeds(&one));
        assert!(!(value * zero).is_defined() && !value.exp().is_defined());
        assert!(
            !value.sin_cos().0.is_defined() && !value.atan2(&one).is_defined() && !value.floor().is_defined()
        );
    }
    assert!(Float256::from(-0.0) == zero && (-zero).is_zero());
    assert_eq!(zero.atan2(&zero), zero);
}

#[test]
fn floor_goes_down() {
    for (x, floor) in
        [("7/2", 3), ("-7/2", -4), ("-1/1000", -1), ("1/1000", 0), ("-5", -5), ("12", 12), ("-4", -4)]
    {
        assert_eq!(number(x).floor(), Float256::from_int(floor), "{x}");
    }
}

type Function = fn(&Float256) -> Float256;

#[test]
fn elementary_functions_have_all_digits() {
    // The values are from mpmath 1.3 at 90 digits, printed by nstr(…, 78).
    let table: [(Function, &str, &str); 19] = [
        (
            Real::exp,
            "17/13",
            "3.69763086456666039966442136274003545507614021531785666623723540569300887249544",
        ),
        (
            Real::exp,
            "-1234/7",
            "2.75478079949334990406965133681681966813189434740810217815979744292798907605169e-77",
        ),
        (
            Real::exp_m1,
            "1e-30",
            "1.00000000000000000000000000000050000000000000000000000000000016666666666666667e-30",
        ),
        (
            Real::ln,
            "17/13",
            "0.268263986594679344196047176307807930782935067825537670878192227218827908476521",
        ),
        (
            Real::ln,
            "1e100",
            "230.258509299404568401799145468436420760110148862877297603332790096757260967735",
        ),
        (
            Real::ln_1p,
            "-1e-20",
            "-0.0000000000000000000100000000000000000000500000000000000000003333333333333333333358333333333333333",
        ),
        (
            Real::sin,
            "17/13",
            "0.965587340923578650057120309943881546152971228967861580092546239602858948276218",
        ),
        (
            Real::cos,
            "17/13",
            "0.260079001551706775172769167760980775791710117923060475420145052502665683389855",
        ),
        (
            Real::sin,
            "1e20",
            "-0.645251285265780844205811711312523007406904196686897118303117006887898616218857",
        ),
        (
            Real::cos,
            "355/113",
            "-0.999999999999964418433716934312971425203232458079176811201607874642593311373125",
        ),
        (
            Real::atan,
            "17/13",
            "0.917949695694122330885578289524145577609259079533656656257521375719168635829058",
        ),
        (
            Real::sinh,
            "17/13",
            "1.71359371375232239317141328709906381147383283161224834629205985662548698100313",
        ),
        (
            Real::cosh,
            "-40",
            "117692633418509992.703949955374517404378612936273072231282943017023973590702691",
        ),
        (
            Real::tanh,
            "1e-10",
            "0.0000000000999999999999999999996666666666666666666679999999999999999999946031746031746032",
        ),
        (
            Real::tanh,
            "17/13",
            "0.863690336165825587787435775592028527272632478753620631997486748818915585355658",
        ),
        (
            Real::atanh,
            "127/128",
            "2.7706317725792130731227695940109199398806474623385059804722899814969829283636",
        ),
        (
            Real::asinh,
            "-1e-15",
            "-0.000000000000000999999999999999999999999999999833333333333333333333333333333408333333333333333",
        ),
        (
            Real::asinh,
            "12345",
            "10.1141535839796556256729520287316463615540022679308569688572267317142742875997",
        ),
        (
            Real::sqrt,
            "17/13",
            "1.14354374979373119404707755491779974241915273182468165850485344694244902421394",
        ),
    ];
    for (function, argument, expected) in table {
        assert_close(&function(&number(argument)), &number(expected), 74, argument);
    }
    let power = number("17/13").power_real(&number("-7/3"));
    assert_close(
        &power,
        &number("0.534753544850981069860919023262252808931792622375957845567945481176267053361935"),
        75,
        "power",
    );
    assert_close(
        &number("-1").atan2(&number("-3")),
        &number("-2.8198420991931510450612387689208415651764141038174496295421415329510601688804"),
        75,
        "atan2",
    );
    assert_close(
        &Float256::pi(),
        &number("3.14159265358979323846264338327950288419716939937510582097494459230781640628621"),
        76,
        "pi",
    );
}

#[test]
fn kahan_maps_run_in_256_bits() {
    let start = vector!["3/7", "11/13", "23/47"].map(number);
    let exact = kahan_systems::E4.step(&start.map(|_| rational("1")), rational("1/2"));
    let value = kahan_systems::E4.step(&start.map(|_| Float256::from_int(1)), Float256::half());
    for i in 0..3 {
        assert_close(&value[i], &Float256::from_rational(&exact[i]), 75, "a step");
    }
    assert!(kahan_systems::E4.try_step(&start, Float256::half()).is_ok());
}
