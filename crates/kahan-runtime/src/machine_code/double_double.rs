//! Double-double arithmetic as a program of doubles. Without overflow and underflow, the program
//! performs the operations of [`Dd`](kahan_core::Dd) in the same order.
//!
//! The program does not branch. Some operations are correct only far from overflow and underflow. A
//! guard, a number that begins at 0, becomes NaN after the first operation on numbers that are too
//! large or too small. If the guard is not 0, the interpreter repeats the steps.

use core::ops::Neg;
use std::cell::RefCell;

use kahan_core::num_traits::{One, Zero};
use kahan_core::{Constant, Scalar, operators};
use kahan_jit::{Input, Program};

use super::traced::{self, Traced};

type Double = Traced<f64>;

/// A number as the unevaluated sum of two doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pair {
    high: Double,
    low: Double,
}

#[derive(Debug, Default)]
struct GuardNotes {
    /// Whether the rounding errors of products are computed by fused multiply-adds.
    fuses: bool,
    of_sizes: Vec<Double>,
    /// High parts of double-double numbers that are known to be far from overflow and underflow.
    moderate: Vec<Double>,
}

thread_local! {
    static GUARD_NOTES: RefCell<GuardNotes> = RefCell::default();
}

/// A divisor a with 2^−DIVISOR_EXPONENT < |a| < 2^DIVISOR_EXPONENT causes neither overflow nor
/// underflow.
const DIVISOR_EXPONENT: i32 = 400;

/// Traces the numbers that `compute` returns, as two doubles each. The last result is the guard,
/// which becomes NaN if numbers are too large or too small.
pub(super) fn program(fuses: bool, compute: impl FnOnce() -> Option<Vec<Pair>>) -> Option<Program> {
    GUARD_NOTES.set(GuardNotes { fuses, ..GuardNotes::default() });
    traced::program(|| {
        let mut results: Vec<Double> =
            compute()?.into_iter().flat_map(|pair| [pair.high, pair.low]).collect();
        let guard = Double::input(Input::State(results.len()));
        // Sum the checks first, so that only one addition waits for the previous step's guard.
        let noted = GUARD_NOTES.take().of_sizes.into_iter().reduce(|a, b| a + b);
        results.push(noted.map_or(guard, |noted| guard + noted));
        Some(results)
    })
}

fn power_of_two(exponent: i32) -> f64 {
    libm::exp2(f64::from(exponent))
}

fn fuses() -> bool {
    GUARD_NOTES.with_borrow(|notes| notes.fuses)
}

/// Sets the guard, the program's last result, to NaN unless |a|·2^exponent is finite.
fn guard_below(a: Double, exponent: i32) {
    let note = a * Double::number(power_of_two(exponent)) * Double::number(0.0);
    GUARD_NOTES.with_borrow_mut(|notes| notes.of_sizes.push(note));
}

/// Sets the guard, the program's last result, to NaN unless |a| is between 2^−k and 2^k, where k is
/// [`DIVISOR_EXPONENT`]. For small |a|, `inverse`, which is near 1/a, is too large.
fn note_moderate(a: Double, inverse: Double) {
    guard_below(a, 1024 - DIVISOR_EXPONENT);
    guard_below(inverse, 1024 - DIVISOR_EXPONENT);
}

/// Sets the guard, the program's last result, to NaN unless |leading| < 2^1022.
fn guard_headroom(leading: Double) {
    guard_below(leading, 1024 - 1022);
}

/// Returns a + b and the rounding error of the sum (Knuth).
fn two_sum(a: Double, b: Double) -> (Double, Double) {
    let sum = a + b;
    let from_a = sum - b;
    let from_b = sum - from_a;
    (sum, (a - from_a) + (b - from_b))
}

/// Returns a + b and the rounding error of the sum, for |a| ≥ |b| (Dekker).
fn fast_two_sum(a: Double, b: Double) -> Pair {
    let high = a + b;
    Pair { high, low: b - (high - a) }
}

/// Returns a·b and its rounding error, by a fused multiply-add or by splitting (Dekker).
fn two_product(a: Double, b: Double) -> (Double, Double) {
    let product = a * b;
    if fuses() {
        return (product, a.multiply_subtract(b, product));
    }
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    let left = a_high * b_high - product + a_high * b_low + a_low * b_high;
    (product, left + a_low * b_low)
}

/// Splits a into two floats of 26 bits (Veltkamp). Sets the guard, the program's last result, to
/// NaN if |a| is above 2⁹⁹⁵.
fn split(a: Double) -> (Double, Double) {
    guard_below(a, 1024 - 995);
    let spread = Double::number(power_of_two(27) + 1.0) * a;
    let high = spread - (spread - a);
    (high, a - high)
}

fn remainder(whole: Double, a: Double, b: Double) -> Double {
    if fuses() {
        return whole.subtract_product(a, b);
    }
    let (product, error) = two_product(a, b);
    whole - product - error
}

impl Pair {
    pub(super) fn of(entry: fn(usize) -> Input, place: usize) -> Self {
        Pair { high: Double::input(entry(2 * place)), low: Double::input(entry(2 * place + 1)) }
    }

    fn sum(self, other: Self) -> Self {
        let (leading, error) = two_sum(self.high, other.high);
        guard_headroom(leading);
        let (lower, rest) = two_sum(self.low, other.low);
        let Pair { high, low } = fast_two_sum(leading, error + lower);
        fast_two_sum(high, rest + low)
    }

    fn product(self, other: Self) -> Self {
        let (leading, error) = two_product(self.high, other.high);
        guard_headroom(leading);
        let lower = self.low.multiply_add(other.high, self.high * other.low);
        fast_two_sum(leading, error + lower)
    }

    fn over(self, divisor: Self) -> Self {
        let leading = self.high / divisor.high;
        let reciprocal = Double::number(1.0) / divisor.high;
        note_moderate(divisor.high, reciprocal);
        let is_ordinary = self.high.literal().is_some_and(|value| {
            // A constant in this range, divided by a checked divisor, cannot overflow or underflow.
            (power_of_two(-40)..power_of_two(40)).contains(&value.abs())
        });
        if is_ordinary {
            GUARD_NOTES.with_borrow_mut(|notes| notes.moderate.push(leading));
        } else if !GUARD_NOTES.with_borrow(|notes| notes.moderate.contains(&self.high)) {
            note_moderate(self.high, Double::number(1.0) / self.high);
        }
        let correction = self.low.subtract_product(leading, divisor.low);
        let remainder = remainder(self.high, leading, divisor.high) + correction;
        fast_two_sum(leading, remainder * reciprocal)
    }
}

operators! { [] Pair: Pair::sum, |a: Self, b: Self| a + -b, Pair::product, Pair::over }

impl Neg for Pair {
    type Output = Self;

    fn neg(self) -> Self {
        Pair { high: -self.high, low: -self.low }
    }
}

impl Zero for Pair {
    fn zero() -> Self {
        Pair { high: Double::number(0.0), low: Double::number(0.0) }
    }

    fn is_zero(&self) -> bool {
        false
    }
}

impl One for Pair {
    fn one() -> Self {
        Pair { high: Double::number(1.0), low: Double::number(0.0) }
    }
}

impl Scalar for Pair {
    fn constant(c: &Constant<'_>) -> Self {
        let (high, low) = c.to_double_double();
        Pair { high: Double::number(high), low: Double::number(low) }
    }

    fn quotient(self, divisor: Self) -> Option<Self> {
        Some(self / divisor)
    }

    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        let (leading, product_error) = two_product(self.high, factor.high);
        let (sum, sum_error) = two_sum(leading, addend.high);
        guard_headroom(sum);
        let lower = self.low.multiply_add(factor.high, self.high.multiply_add(factor.low, addend.low));
        fast_two_sum(sum, sum_error + (product_error + lower))
    }

    fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
        self.multiply_add(factor, -subtrahend)
    }

    fn subtract_product(self, a: Self, b: Self) -> Self {
        (-a).multiply_add(b, self)
    }
}
