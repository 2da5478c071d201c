//! Measures errors and prices of settings for a compiled field, a start and a time span.

use std::hint::black_box;
use std::time::Instant;

use kahan_core::prelude::*;
use kahan_core::{Composition, Dd, ExtendScalars, FloatScalar, ThroughF64};
use kahan_dynamics::{Need, Precision, Scheme};
use kahan_runtime::interpreted::round;
use kahan_study::reference::Reference;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Setting {
    pub(crate) scheme: Scheme,
    pub(crate) eps: f64,
}

impl std::fmt::Display for Setting {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}, eps = {:?}", self.scheme, self.eps)
    }
}

pub(crate) fn to<T: Scalar>(value: &BigRational) -> T {
    round(&value.clone().into())
}

pub(crate) struct Scene<M, const N: usize> {
    pub(crate) map: M,
    pub(crate) start: SVector<BigRational, N>,
    pub(crate) horizon: f64,
    pub(crate) reference: Reference,
}

/// Evaluates `$body`, in which `$begin()` starts an orbit with the method of `$setting`.
macro_rules! with_orbit {
    ($map:expr, $start:expr, $eps:expr, $setting:expr, |$begin:ident| $body:expr) => {
        match (
            Some($setting.scheme.composition).filter(|method| *method != Composition::KAHAN),
            $setting.scheme.compensated,
        ) {
            (None, false) => {
                let $begin = || $map.orbit($start, $eps);
                $body
            }
            (None, true) => {
                let $begin = || $map.orbit($start, $eps).compensated();
                $body
            }
            (Some(composition), false) => {
                let $begin = || $map.orbit($start, $eps).composed(composition);
                $body
            }
            (Some(composition), true) => {
                let $begin = || $map.orbit($start, $eps).composed(composition).compensated();
                $body
            }
        }
    };
}

macro_rules! with_scalar {
    ($scene:expr, $setting:expr, |$map:ident, $start:ident, $eps:ident| $body:expr) => {
        match $setting.scheme.precision {
            Precision::Single => {
                let ($map, $start, $eps) = $scene.parts::<f32>($setting.eps);
                $body
            }
            Precision::SingleThroughDouble => {
                let (map, $start, $eps) = $scene.parts::<f32>($setting.eps);
                let $map = ThroughF64(map);
                $body
            }
            Precision::Double => {
                let ($map, $start, $eps) = $scene.parts::<f64>($setting.eps);
                $body
            }
            Precision::DoubleDouble => {
                let ($map, $start, $eps) = $scene.parts::<Dd>($setting.eps);
                $body
            }
        }
    };
}

impl<M: ExtendScalars<BigRational, N>, const N: usize> Scene<M, N> {
    fn parts<T: FloatScalar>(&self, eps: f64) -> (M::Extended<T>, SVector<T, N>, T) {
        let eps = BigRational::from_float(eps).expect("finite");
        (self.map.extend_scalars(to), SVector::from_fn(|i, _| to(&self.start[i])), to(&eps))
    }

    /// Returns the largest distance of orbit and reference, or the first distance above `enough`.
    pub(crate) fn error(&self, setting: &Setting, enough: f64) -> f64 {
        let steps = (self.horizon / (2.0 * setting.eps)).round() as usize;
        let dt = Dd::from(2.0 * setting.eps);
        let mut worst = 0.0_f64;
        with_scalar!(self, setting, |map, start, eps| with_orbit!(map, start, eps, setting, |begin| {
            for (n, x) in begin().take(steps + 1).enumerate() {
                let x = x.map(Dd::from);
                worst = worst.max(self.reference.distance(dt * Dd::from(n as f64), x.as_slice()));
                if n == steps {
                    worst = worst.max(self.reference.distance(Dd::from(self.horizon), x.as_slice()));
                }
                if worst > enough {
                    break;
                }
            }
        }));
        worst
    }

    pub(crate) fn price(&self, setting: &Setting) -> f64 {
        /// The approximate number of timed steps. An orbit with fewer steps is repeated.
        const STEPS: usize = 400;
        /// The least number of steps of one timed orbit, since starting an orbit takes time.
        const PIECE: usize = 64;
        // The timed orbit ends at the horizon, because later states may be slow subnormal numbers.
        let steps = ((self.horizon / (2.0 * setting.eps)).round() as usize).clamp(PIECE, STEPS);
        let repeats = STEPS.div_ceil(steps);
        /// Times one kind of orbit. A function for each kind is optimised better than one for all.
        #[inline(never)]
        fn seconds<O: Iterator>(begin: impl Fn() -> O, steps: usize, repeats: usize) -> f64 {
            let clock = Instant::now();
            for _ in 0..repeats {
                black_box(begin().nth(black_box(steps)));
            }
            clock.elapsed().as_secs_f64()
        }
        let seconds = with_scalar!(self, setting, |map, start, eps| {
            with_orbit!(map, black_box(start), black_box(eps), setting, |begin| {
                seconds(begin, steps, repeats)
            })
        });
        1e9 * seconds / ((steps * repeats) as f64 * 2.0 * setting.eps)
    }

    /// Returns, for each scheme (scalar type, order, compensated or not), the setting with the
    /// largest tried ε whose error is within `tolerance`. Settings whose price exceeds
    /// `dearest` are not tried.
    pub(crate) fn sweep(&self, tolerance: f64, dearest: f64) -> Vec<Setting> {
        let mut found = Vec::new();
        for scheme in Scheme::all() {
            let at = |steps: f64| {
                let eps = self.horizon / (2.0 * steps);
                Setting { scheme, eps: scheme.precision.eps_near(eps, Need::Trajectory) }
            };
            let unit = at(1e4 * self.horizon);
            let price = (0..10).map(|_| self.price(&unit)).fold(f64::INFINITY, f64::min);
            let most = self.horizon * dearest / (price * 2.0 * unit.eps);
            let mut steps = 1.0;
            while steps < most {
                let setting = at(steps);
                if self.error(&setting, tolerance) <= tolerance {
                    found.push(setting);
                    break;
                }
                steps = (1.1_f64 * steps).ceil();
            }
        }
        found
    }
}
