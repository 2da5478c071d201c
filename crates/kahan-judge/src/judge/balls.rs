//! Tests results by balls around the exact step x̃, for maps with too many terms to be expanded.
//!
//! Undecided questions are repeated with twice the bits, and finally with exact rational numbers.

use std::cmp::Ordering;

use kahan_algebra::prime_field::SplitMix64;

use super::fraction::{ERROR_BOUND_FACTOR, Fraction, greatest};
use super::{ExactMap, ExactStep, PolePolynomial, Verdict};
use crate::ball::Ball;
use crate::dyadic::Dyadic;
use crate::elimination::{self, Eliminated, largest, precisions};
use crate::equation::{AtPoint, Equation};
use crate::float::Format;

struct Balls {
    equation: AtPoint,
    /// The first precision in which the ball of det A excludes 0.
    bits: u64,
    next: Vec<Ball>,
}

impl Balls {
    /// Solves the equation for x̃. Returns `None` at a pole, where det A = 0.
    fn of(equation: AtPoint) -> Option<Box<dyn ExactStep>> {
        for bits in precisions() {
            match elimination::next(&equation, bits) {
                Eliminated::Solved(next) => return Some(Box::new(Self { equation, bits, next })),
                Eliminated::Singular => return None,
                Eliminated::Unknown => {}
            }
        }
        Some(Box::new(Fraction::of_equation(&equation)?))
    }

    /// Calls `of_balls` at growing precision until it returns an answer; otherwise calls `exactly`.
    fn answer<R>(
        &self,
        of_balls: impl Fn(&[Ball], u64) -> Option<R>,
        exactly: impl FnOnce(&Fraction) -> R,
    ) -> R {
        if let Some(answer) = of_balls(&self.next, self.bits) {
            return answer;
        }
        for bits in precisions().filter(|bits| *bits > self.bits) {
            if let Eliminated::Solved(next) = elimination::next(&self.equation, bits)
                && let Some(answer) = of_balls(&next, bits)
            {
                return answer;
            }
        }
        exactly(&Fraction::of_equation(&self.equation).expect("a ball without 0 holds det A"))
    }
}

impl ExactStep for Balls {
    fn judge(&self, format: &Format, result: &[Dyadic]) -> Verdict {
        let of_balls = |next: &[Ball], bits: u64| {
            let error = |(y, x): (&Dyadic, &Ball)| Ball::exactly(y.clone()).minus(x, bits);
            let errors: Vec<Ball> = result.iter().zip(next).map(error).collect();
            let (least, most) = range(&errors);
            let (size, size_at_most) = range(next);
            let is_within = |share: &Dyadic| {
                let is_below = most.compare(&(&size * share)) != Ordering::Greater;
                let is_above = least.compare(&(&size_at_most * share)) == Ordering::Greater;
                (is_below || is_above).then_some(is_below)
            };
            let thousandth = |(error, size): (&Dyadic, &Dyadic)| {
                (error * &Dyadic::new(1000, 0)).compare(size) != Ordering::Greater
            };
            let is_rough = thousandth((&most, &size));
            Some(Verdict {
                keeps_promise: is_within(&Dyadic::new(ERROR_BOUND_FACTOR, -format.precision))?,
                is_rough: (is_rough || !thousandth((&least, &size_at_most))).then_some(is_rough)?,
                error_u: if most.is_zero() {
                    0.0
                } else {
                    most.clone().scaled(format.precision).ratio(&size)
                },
            })
        };
        self.answer(of_balls, |fraction| fraction.judge(format, result))
    }

    fn fits(&self, format: &Format) -> bool {
        self.answer(|next, _| fit(format, next), |fraction| fraction.fits(format))
    }
}

impl ExactMap for Equation {
    fn equation(&self) -> &Equation {
        self
    }

    fn step(&self, point: &[Dyadic]) -> Option<Box<dyn ExactStep>> {
        Balls::of(self.at(point))
    }

    fn zeros(
        &self,
        _is_removable: bool,
        point: &[Dyadic],
        random: &mut SplitMix64,
    ) -> Option<PolePolynomial> {
        Some(zeros(self, point, random))
    }
}

/// Returns lower and upper bounds of the largest magnitude among the balls.
fn range(balls: &[Ball]) -> (Dyadic, Dyadic) {
    (largest(balls.iter().map(Ball::least)), largest(balls.iter().map(Ball::most)))
}

/// Returns whether the format holds all of x̃ with full precision; `None` if undecided.
pub(crate) fn fit(format: &Format, next: &[Ball]) -> Option<bool> {
    let (least, greatest) = (Dyadic::new(1, format.least_binade), greatest(format));
    let verdict = |ball: &Ball| {
        let (low, high) = (ball.least(), ball.most());
        let is_below = ball.is_not_zero() && high.compare(&least) == Ordering::Less;
        if is_below || low.compare(&greatest) == Ordering::Greater {
            return Some(false);
        }
        let is_inside = low.compare(&least) != Ordering::Less && high.compare(&greatest) != Ordering::Greater;
        (ball.is_zero() || is_inside).then_some(true)
    };
    let verdicts: Vec<Option<bool>> = next.iter().map(verdict).collect();
    if verdicts.contains(&Some(false)) {
        return Some(false);
    }
    verdicts.iter().all(Option::is_some).then_some(true)
}

/// Returns the condition number of the step in (x, ε), or infinity if no precision suffices.
pub(super) fn condition(equation: &Equation, point: &[Dyadic]) -> f64 {
    let (at, curvature) = (equation.at(point), equation.curvature(point));
    precisions().find_map(|bits| elimination::condition(&at, &curvature, bits)).unwrap_or(f64::INFINITY)
}

/// Expands det A row by row as a polynomial in one variable, chosen at random: ε or a state.
fn zeros(equation: &Equation, point: &[Dyadic], random: &mut SplitMix64) -> PolePolynomial {
    /// With this many bits, roots are as precise as the longest scalar type, unless many digits
    /// cancel.
    const ROOT_BITS: u64 = 320;
    let n = equation.dimension();
    let chosen = random.below(n as u64 + 1) as usize;
    let variable = if chosen == n { equation.epsilon() } else { chosen };
    let at = |value: i64| {
        let mut moved = point.to_vec();
        moved[variable] = Dyadic::new(value, 0);
        equation.at(&moved)
    };
    let (zero, one) = (at(0), at(1));
    // `minors[s]` is the minor of the rows so far and of the columns whose bits are set in s.
    let mut minors = vec![None; 1 << n];
    minors[0] = Some(vec![Dyadic::new(1, 0)]);
    for i in 0..n {
        let mut entries: Vec<(usize, [Dyadic; 2])> = Vec::new();
        let mut slopes = one.row(i);
        for (j, constant) in zero.row(i) {
            let at_one = slopes.iter().position(|(k, _)| *k == j).map(|k| slopes.swap_remove(k).1);
            let slope = &at_one.unwrap_or_else(Dyadic::zero) - &constant;
            entries.push((j, [constant, slope]));
        }
        let mut next = vec![None; 1 << n];
        for (columns, minor) in minors.iter().enumerate() {
            let Some(minor) = minor else { continue };
            for (j, entry) in entries.iter().filter(|(j, _)| columns >> j & 1 == 0) {
                let is_odd = (columns >> j).count_ones() % 2 == 1;
                let sum = next[columns | 1 << j].get_or_insert_with(Vec::new);
                add_product(sum, minor, entry, is_odd, ROOT_BITS);
            }
        }
        minors = next;
    }
    PolePolynomial { variable, coefficients: minors.swap_remove((1 << n) - 1).unwrap_or_default() }
}

fn add_product(sum: &mut Vec<Dyadic>, minor: &[Dyadic], entry: &[Dyadic; 2], is_subtracted: bool, bits: u64) {
    for (power, coefficient) in minor.iter().enumerate() {
        for (raised, factor) in entry.iter().enumerate() {
            if factor.is_zero() || coefficient.is_zero() {
                continue;
            }
            sum.resize_with(sum.len().max(power + raised + 1), Dyadic::zero);
            let product = coefficient * factor;
            let place = &mut sum[power + raised];
            let value = if is_subtracted { &*place - &product } else { &*place + &product };
            *place = value.truncated(bits).map_or(value, |(cut, _)| cut);
        }
    }
}
