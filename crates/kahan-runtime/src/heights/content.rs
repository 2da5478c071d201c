//! The content of a step: the common factor of X̃₁ … X̃_n and W̃, divided out so that numbers stay
//! as short as they can.
//!
//! *Integrable maps* live from it: two thirds of a step of dE4 are content. A gcd of such long
//! numbers is the dearest part of a step, so it is predicted. Let γ be the factor of the step back,
//! F₋(X) = γX₋ (F₋ the inverse map, X₋ the point before). A prime divides a content where the orbit
//! modulo it meets a base point of the map, having been contracted a few steps earlier (singularity
//! confinement); the orbit met a base point of the inverse map in between, so the same prime
//! divides an earlier γ, always by the same number of steps: for dE4 the content of a step from X_n
//! is γ_{n−1} up to a few digits. So the lags at which γ holds a good part of the content are
//! learnt while numbers are short, and later gcd(γ, W̃) is tried first: γ costs one division, and
//! the gcd is short where γ is little more than the content. A prediction decides nothing: exact
//! divisions check it, and what it left is found by
//! [`common_factors`](super::reduction::common_factors), on numbers that are short by then.
//!
//! *Other maps* have next to none, so the search stops after three finds in a row of less than one
//! per cent of the digits. The little there is comes out all the same with the common factors that
//! the heights need; if that is one per cent or more, the search begins again.

use std::collections::VecDeque;

use dashu_int::ops::{BitTest, DivRem, Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};

use super::integers::{bits, greatest_common_divisor, short_gcd};
use super::map::Image;
use super::reduction::in_halves;

/// Finds less than one part in so many of the digits count as nothing.
const NEGLIGIBLE: usize = 100;
/// So many such finds in a row end the search.
const PATIENCE: u32 = 3;
/// From this many bits on a gcd costs clearly more than the division that a prediction takes.
const WORTH_PREDICTING: usize = 1 << 13;
/// From this many bits on a division is worth a thread.
const WORTH_A_THREAD: usize = 1 << 17;
/// The greatest lag that is tried.
const LAGS: usize = 4;

/// A point with hardly any content.
#[derive(Clone, Debug)]
pub(crate) struct Primitive {
    /// X₁ … X_n and W.
    pub(crate) point: Vec<IBig>,
    /// Numbers whose product is W; none where they are not known.
    pub(crate) weight_parts: Vec<IBig>,
}

/// What is known of the contents of an orbit.
#[derive(Clone, Debug, Default)]
pub(crate) struct Content {
    /// How many finds in a row were negligible.
    misses: u32,
    /// γ of the latest points, the latest first.
    behind: VecDeque<UBig>,
    /// The lag that predicts, once known.
    lag: Option<usize>,
    /// Long steps for which nothing is predicted or learnt, and how many there will be after the
    /// next failure.
    pause: u32,
    next_pause: u32,
    /// Whether the last step was predicted.
    was_predicted: bool,
}

impl Content {
    /// Divides out what the search finds; then [`left`](Self::left) must be told of the rest.
    /// `before` is the point before the one that was stepped, where there is one.
    pub(crate) fn divide_out(&mut self, image: Image, before: Option<&[IBig]>) -> Primitive {
        let Image { point, weight_behind, weight_parts } = image;
        self.was_predicted = false;
        if self.misses >= PATIENCE {
            self.behind.clear();
            return Primitive { point, weight_parts };
        }
        let size = longest(&point);
        let is_long = size > WORTH_PREDICTING;
        if !is_long || self.pause == 0 {
            let gamma = before.and_then(<[IBig]>::last).zip(weight_behind).and_then(factor_behind);
            self.behind.push_front(gamma.unwrap_or_default());
            self.behind.truncate(LAGS);
            let gamma = self.lag.filter(|_| is_long).and_then(|lag| self.behind.get(lag));
            if let Some(quotients) = gamma.and_then(|gamma| predicted(&point, gamma)) {
                self.was_predicted = true;
                return Primitive { point: quotients, weight_parts: Vec::new() };
            }
        }
        let content = greatest_common_divisor(&point);
        self.misses = if is_negligible(&content, size) { self.misses + 1 } else { 0 };
        if self.pause == 0 {
            self.learn(&content);
            if is_long && self.lag.is_none() {
                self.pause_predictions();
            }
        } else {
            self.pause -= 1;
        }
        if content.is_one() {
            return Primitive { point, weight_parts };
        }
        Primitive {
            point: quotients(&point, &content).expect("a common divisor divides"),
            weight_parts: Vec::new(),
        }
    }

    /// The lag whose γ holds most of a content that is worth it.
    fn learn(&mut self, content: &UBig) {
        let shares = self.behind.iter().map(|gamma| short_gcd(content, gamma).bit_len()).enumerate();
        let best = shares.max_by_key(|&(lag, share)| (share, std::cmp::Reverse(lag)));
        self.lag = best.filter(|(_, share)| 2 * share > content.bit_len().max(64)).map(|(lag, _)| lag);
    }

    /// Takes notice of the content that the search had left in a point of `size` bits.
    pub(crate) fn left(&mut self, content: &UBig, size: usize) {
        if !is_negligible(content, size) {
            self.misses = 0;
            if self.was_predicted {
                self.lag = None;
                self.pause_predictions();
            }
        } else if self.was_predicted {
            self.next_pause = 0;
        }
    }

    fn pause_predictions(&mut self) {
        self.behind.clear();
        self.next_pause = (2 * self.next_pause).max(LAGS as u32);
        self.pause = self.next_pause;
    }
}

/// γ = W₋/W from the W of the point before and the last coordinate of the step back; none where the
/// point before had a content of its own that does not divide.
fn factor_behind((weight, behind): (&IBig, IBig)) -> Option<UBig> {
    let (gamma, rest) = behind.div_rem(weight);
    rest.is_zero().then(|| gamma.unsigned_abs())
}

fn is_negligible(content: &UBig, size: usize) -> bool {
    content.bit_len().saturating_mul(NEGLIGIBLE) < size
}

/// The number of bits of the longest.
pub(crate) fn longest(point: &[IBig]) -> usize {
    point.iter().map(bits).max().unwrap_or(0)
}

/// The point divided by what γ and W̃ share; `None` where that is less than a quarter of γ.
fn predicted(point: &[IBig], gamma: &UBig) -> Option<Vec<IBig>> {
    if gamma.is_zero() {
        return None;
    }
    let mut shared = short_gcd(gamma, &point.last()?.unsigned_abs());
    while 4 * shared.bit_len() >= gamma.bit_len() {
        match quotients(point, &shared) {
            Ok(quotients) => return Some(quotients),
            Err(remainder) => shared = shared.gcd(remainder),
        }
    }
    None
}

/// The quotients by a common divisor; a remainder if it is none. Long divisions are shared out
/// between two threads.
fn quotients(point: &[IBig], divisor: &UBig) -> Result<Vec<IBig>, UBig> {
    if longest(point) > WORTH_A_THREAD && point.len() > 1 {
        let halves = in_halves(point, |half| quotients_in_turn(half, divisor));
        return Ok(halves.into_iter().collect::<Result<Vec<_>, _>>()?.concat());
    }
    quotients_in_turn(point, divisor)
}

fn quotients_in_turn(point: &[IBig], divisor: &UBig) -> Result<Vec<IBig>, UBig> {
    let quotient = |x: &IBig| {
        let (quotient, remainder) = x.unsigned_abs().div_rem(divisor);
        if remainder.is_zero() { Ok(IBig::from_parts(x.sign(), quotient)) } else { Err(remainder) }
    };
    point.iter().map(quotient).collect()
}
