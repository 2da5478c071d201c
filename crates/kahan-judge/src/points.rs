//! Seeded random points. Each point depends on the settings, the systems and the index of its
//! trial, not on threads.
//!
//! Logarithms of absolute values are mostly distributed about uniformly. A quarter of the
//! significands have few bits, so that exact poles occur.

use kahan_algebra::prime_field::SplitMix64;

use super::dyadic::Dyadic;
use super::float::Float;
use super::judge::{ExactMap, PolePolynomial};
use super::regime::Regime;
use super::roots::root;

#[derive(Clone, Debug)]
pub(crate) struct Inputs<T> {
    pub(crate) parameters: Vec<T>,
    pub(crate) x: Vec<T>,
    pub(crate) eps: T,
    /// The regime of the point; `MixedMagnitudes` if the search for a nearby pole failed.
    pub(crate) regime: Regime,
}

impl<T: Float> Inputs<T> {
    pub(crate) fn exact(&self) -> Option<Vec<Dyadic>> {
        self.x.iter().chain(&self.parameters).chain([&self.eps]).map(|value| value.exact()).collect()
    }

    fn set(&mut self, variable: usize, value: T) {
        let (states, parameters) = (self.x.len(), self.parameters.len());
        match variable {
            i if i < states => self.x[i] = value,
            i if i < states + parameters => self.parameters[i - states] = value,
            _ => self.eps = value,
        }
    }
}

/// A source of random inputs for one system.
pub(crate) struct InputSampler<'a, T> {
    pub(crate) judge: &'a dyn ExactMap,
    pub(crate) fixed: &'a [Option<T>],
    /// Whether parameters are drawn from the whole range of floats.
    pub(crate) is_odd: bool,
    pub(crate) random: SplitMix64,
}

impl<T: Float> InputSampler<'_, T> {
    pub(crate) fn draw(&mut self, regime: Regime) -> Inputs<T> {
        match regime {
            Regime::Ordinary => self.ordinary(),
            Regime::MixedMagnitudes => self.mixed(),
            Regime::NearPole => self.near_pole(false, regime),
            Regime::NearRemovablePole => self.near_pole(true, regime),
            Regime::Subnormal => self.inputs_in_regime(regime, |points| {
                let binade = points.between(T::FORMAT.least_binade - T::BITS + 1, T::FORMAT.least_binade - 1);
                points.float(binade)
            }),
            Regime::LargeSteps => {
                let inputs = Inputs { regime, ..self.ordinary() };
                self.with_size(inputs, 0, 9)
            }
            Regime::NotFinite => {
                self.inputs_in_regime(regime, |points| T::not_finite(points.random.next_u64()))
            }
        }
    }

    fn ordinary(&mut self) -> Inputs<T> {
        let inputs = self.scaled(0);
        if self.is_odd && self.random.below(2) == 0 { self.with_size(inputs, -20, -1) } else { inputs }
    }

    /// Replaces ε so that ‖εf′‖∞ lies roughly between 2^low and 2^high.
    fn with_size(&mut self, mut inputs: Inputs<T>, low: i64, high: i64) -> Inputs<T> {
        let binade = self.between(low, high);
        let size: T = self.float(binade);
        let slope = inputs.exact().map_or(0.0, |point| self.judge.equation().at(&point).slope());
        let eps = size.exact().map_or(0.0, |size| size.near_f64()) / slope;
        inputs.eps = Dyadic::of(eps).map_or(size, |eps| T::near(&eps));
        inputs
    }

    /// Draws an ordinary point, multiplies it by 2^binade, and divides ε by 2^binade.
    fn scaled(&mut self, binade: i64) -> Inputs<T> {
        let sizes: Vec<i64> =
            (0..self.judge.equation().dimension()).map(|_| binade + self.between(-5, 1)).collect();
        let eps = self.between(-10, -1) - binade;
        self.draw_inputs(Regime::Ordinary, &sizes, eps)
    }

    fn mixed(&mut self) -> Inputs<T> {
        let n = self.judge.equation().dimension();
        let limit = T::STATE_BINADES;
        let kind = self.random.below(4);
        if kind == 0 {
            let binade = self.between(4 - limit, limit - 1);
            return Inputs { regime: Regime::MixedMagnitudes, ..self.scaled(binade) };
        }
        let (sizes, eps): (Vec<i64>, i64) = match kind {
            // Components have any size, and ε‖x‖ is between 2^−60 and 2^60.
            1 => {
                let sizes: Vec<i64> = (0..n).map(|_| self.between(-limit, limit)).collect();
                let largest = sizes.iter().copied().max().unwrap_or(0);
                (sizes, self.between(-60, 60) - largest)
            }
            // Here components differ by at most a factor 2^40, and ε‖x‖ is not far from 1.
            2 => {
                let binade = self.between(-limit, limit);
                ((0..n).map(|_| binade + self.between(-20, 20)).collect(), self.between(-30, 30) - binade)
            }
            _ => {
                let sizes = (0..n).map(|_| self.between(-limit, limit)).collect();
                (sizes, self.between(-T::EPS_BINADES, T::EPS_BINADES))
            }
        };
        let inputs = self.draw_inputs(Regime::MixedMagnitudes, &sizes, eps);
        if self.is_odd && self.random.below(2) == 0 { self.with_size(inputs, -60, 10) } else { inputs }
    }

    /// Draws a point, and changes one variable so that the point lies near a (removable) pole.
    fn near_pole(&mut self, is_removable: bool, regime: Regime) -> Inputs<T> {
        const ATTEMPTS: usize = 12;
        for _ in 0..ATTEMPTS {
            let mut inputs = if self.random.below(2) == 0 { self.ordinary() } else { self.mixed() };
            let Some(point) = inputs.exact() else { break };
            let Some(zeros) = self.judge.zeros(is_removable, &point, &mut self.random) else { continue };
            let PolePolynomial { variable, coefficients } = zeros;
            let Some(zero) = root(&coefficients, T::BITS, &mut self.random) else { continue };
            let is_eps = variable == self.judge.equation().epsilon();
            let limit = if is_eps { T::EPS_BINADES } else { T::STATE_BINADES };
            if zero.binade().is_none_or(|binade| binade.abs() > limit) {
                continue;
            }
            // The relative distance 2^−k from the root `zero` may be below the rounding error.
            let k = self.between(0, T::BITS + 6);
            let offset = zero.clone().scaled(-k);
            let moved = if self.random.below(2) == 0 { &zero + &offset } else { &zero - &offset };
            inputs.set(variable, T::near(&moved));
            return Inputs { regime, ..inputs };
        }
        self.mixed()
    }

    /// Draws an ordinary point, and lets `value` draw one or two of its numbers anew.
    fn inputs_in_regime(&mut self, regime: Regime, mut value: impl FnMut(&mut Self) -> T) -> Inputs<T> {
        let mut inputs = Inputs { regime, ..self.ordinary() };
        let (n, epsilon) = (self.judge.equation().dimension(), self.judge.equation().epsilon());
        let drawn = (n..epsilon).filter(|variable| self.fixed[variable - n].is_none());
        let choices: Vec<usize> = (0..n).chain([epsilon]).chain(drawn).collect();
        for _ in 0..=self.random.below(2) {
            let chosen = choices[self.random.below(choices.len() as u64) as usize];
            let replacement = value(self);
            inputs.set(chosen, replacement);
        }
        inputs
    }

    fn draw_inputs(&mut self, regime: Regime, sizes: &[i64], eps: i64) -> Inputs<T> {
        let state = |points: &mut Self, binade: i64| {
            let binade = binade.clamp(-T::STATE_BINADES, T::STATE_BINADES);
            if points.random.below(16) == 0 { T::zero() } else { points.float(binade) }
        };
        let x = sizes.iter().map(|&binade| state(self, binade)).collect();
        let eps = self.float(eps.clamp(-T::EPS_BINADES, T::EPS_BINADES));
        Inputs { parameters: self.parameters(regime), x, eps, regime }
    }

    fn parameters(&mut self, regime: Regime) -> Vec<T> {
        let fixed = self.fixed;
        if self.is_odd {
            return self.odd_parameters();
        }
        let is_any = !fixed.is_empty() && regime == Regime::MixedMagnitudes && self.random.below(8) == 0;
        let (least, most) = if is_any { (-T::STATE_BINADES, T::STATE_BINADES) } else { (-3, 1) };
        let parameter = |given: &Option<T>| {
            given.unwrap_or_else(|| {
                let binade = self.between(least, most);
                self.float(binade)
            })
        };
        fixed.iter().map(parameter).collect()
    }

    /// Draws parameters. Each has any size, has ordinary size, or is close to the one before it.
    fn odd_parameters(&mut self) -> Vec<T> {
        let mut drawn: Vec<T> = Vec::new();
        for given in self.fixed {
            let parameter = given.unwrap_or_else(|| match (self.random.below(4), drawn.last()) {
                (0, Some(before)) => {
                    let k = self.between(T::BITS / 4, T::BITS);
                    let before = before.exact().unwrap_or_else(Dyadic::zero);
                    T::near(&(&before + &before.clone().scaled(-k)))
                }
                (0 | 1, _) => {
                    let binade = self.between(-3, 1);
                    self.float(binade)
                }
                _ => {
                    let binade = self
                        .between(T::FORMAT.least_binade - 48.min(T::BITS - 2), T::FORMAT.greatest_binade - 3);
                    self.float(binade)
                }
            });
            drawn.push(parameter);
        }
        drawn
    }

    fn float(&mut self, binade: i64) -> T {
        let few = self.random.below(4) == 0;
        let bits = if few { 1 + self.random.below(6) as i64 } else { T::BITS };
        let drawn = (u128::from(self.random.next_u64()) << 64) | u128::from(self.random.next_u64());
        let significand = (drawn | 1 << 127) >> (128 - bits);
        let size = Dyadic::new(significand, binade + 1 - bits);
        T::near(&if self.random.below(2) == 0 { size } else { &Dyadic::zero() - &size })
    }

    fn between(&mut self, low: i64, high: i64) -> i64 {
        low + self.random.below((high - low + 1) as u64) as i64
    }
}
