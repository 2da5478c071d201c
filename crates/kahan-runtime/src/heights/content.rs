//! Divides the coordinates of a point, which are integers, by their greatest common divisor, called
//! the content.
//!
//! For many integrable maps the content is long, for example two thirds of the coordinates' digits
//! for the catalog's system E4. A gcd of such long numbers costs more than the step itself, so
//! [`ContentPredictor`] predicts the content of long points from earlier steps.
//!
//! # Maps without a long content
//!
//! If [`MAX_NEGLIGIBLE_CONTENTS`] contents in a row have less than one per cent of the digits, the
//! search stops until the computation of heights finds a longer content.

use std::collections::VecDeque;

use dashu_int::ops::{BitTest, DivRem, Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};

use super::integers::{bits, greatest_common_divisor, short_gcd};
use super::map::Image;
use super::reduction::in_halves;

/// A content (the gcd of the coordinates of a point) is negligible if it has less than 1/NEGLIGIBLE
/// of their digits.
const NEGLIGIBLE: usize = 100;
/// After this number of successive negligible contents, no more contents are sought.
const MAX_NEGLIGIBLE_CONTENTS: u32 = 3;
/// The number of bits of the longest coordinate above which predicting the content saves time.
const WORTH_PREDICTING: usize = 1 << 13;
const WORTH_A_THREAD: usize = 1 << 17;
const LAGS: usize = 4;

#[derive(Clone, Debug)]
pub(crate) struct PrimitivePoint {
    pub(crate) point: Vec<IBig>,
    pub(crate) weight_parts: Vec<IBig>,
}

/// The predictor of contents, the gcds of the coordinates of points, along an orbit.
///
/// Let F₋ be the inverse map, X a point and X₋ the previous point. Then F₋(X) = γX₋ for an integer
/// γ. By singularity confinement, a prime that divides a content also divides γ a few steps
/// earlier. This number of steps, the lag, is constant along an orbit.
///
/// The predictor finds the lag while numbers are short. Later it first divides the new point by
/// gcd(γ, W̃), if possible; γ is that of `lag` steps ago, and W̃ the last coordinate.
#[derive(Clone, Debug, Default)]
pub(crate) struct ContentPredictor {
    misses: u32,
    /// The factors γ in F₋(X) = γX₋ for the latest points X, most recent first.
    behind: VecDeque<UBig>,
    /// The number of steps from an entry of `behind` to the content that it predicts, if known.
    lag: Option<usize>,
    /// The number of coming steps for which no prediction is tried.
    pause: u32,
    next_pause: u32,
    was_predicted: bool,
}

impl ContentPredictor {
    /// Divides the point by its predicted or computed content.
    pub(crate) fn divide_out(&mut self, image: Image, before: Option<&[IBig]>) -> PrimitivePoint {
        let Image { point, weight_behind, weight_parts } = image;
        self.was_predicted = false;
        if self.misses >= MAX_NEGLIGIBLE_CONTENTS {
            self.behind.clear();
            return PrimitivePoint { point, weight_parts };
        }
        let size = longest(&point);
        let is_long = size > WORTH_PREDICTING;
        if !is_long || self.pause == 0 {
            let gamma = before.and_then(<[IBig]>::last).zip(weight_behind).and_then(factor_of_step_back);
            self.behind.push_front(gamma.unwrap_or_default());
            self.behind.truncate(LAGS);
            let gamma = self.lag.filter(|_| is_long).and_then(|lag| self.behind.get(lag));
            if let Some(quotients) = gamma.and_then(|gamma| predicted(&point, gamma)) {
                self.was_predicted = true;
                return PrimitivePoint { point: quotients, weight_parts: Vec::new() };
            }
        }
        let content = greatest_common_divisor(&point);
        self.misses = if is_negligible(&content, size) { self.misses + 1 } else { 0 };
        if self.pause == 0 {
            self.find_lag(&content);
            if is_long && self.lag.is_none() {
                self.pause_predictions();
            }
        } else {
            self.pause -= 1;
        }
        if content.is_one() {
            return PrimitivePoint { point, weight_parts };
        }
        PrimitivePoint {
            point: quotients(&point, &content).expect("a common divisor divides"),
            weight_parts: Vec::new(),
        }
    }

    /// Finds the lag at which gcd(γ, content) has more than half of the digits of the content.
    fn find_lag(&mut self, content: &UBig) {
        let shares = self.behind.iter().map(|gamma| short_gcd(content, gamma).bit_len()).enumerate();
        let best = shares.max_by_key(|&(lag, share)| (share, std::cmp::Reverse(lag)));
        self.lag = best.filter(|(_, share)| 2 * share > content.bit_len().max(64)).map(|(lag, _)| lag);
    }

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

/// Divides the last coordinate of F₋(X) = γX₋, named `behind`, by that of X₋, where F₋ is the
/// inverse map. Returns |γ|, or `None` if γ is not an integer.
fn factor_of_step_back((weight, behind): (&IBig, IBig)) -> Option<UBig> {
    let (gamma, rest) = behind.div_rem(weight);
    rest.is_zero().then(|| gamma.unsigned_abs())
}

fn is_negligible(content: &UBig, size: usize) -> bool {
    content.bit_len().saturating_mul(NEGLIGIBLE) < size
}

pub(crate) fn longest(point: &[IBig]) -> usize {
    point.iter().map(bits).max().unwrap_or(0)
}

/// Divides the point by gcd(γ, W̃) or a factor of it, where W̃ is the last coordinate of the point.
/// Returns `None` if the divisor would have few digits.
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

/// Divides the coordinates by a divisor. Fails with a nonzero remainder if there is one.
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
