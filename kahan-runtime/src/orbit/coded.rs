//! An orbit by machine code.

use std::sync::Arc;

use kahan_algebra::rational::Rational;
use kahan_core::{Dd, FloatScalar, Precision, Scalar, Scheme};

use crate::engine::Scratch;
use crate::interpreted::round;
use crate::machine::{Coded, OrbitCode, StepKind};

use crate::Map;

use super::stages;

/// An orbit by machine code, in the numbers that it runs in.
#[derive(Clone, Debug)]
pub(super) enum Coding {
    Single(Running<f32>),
    Double(Running<f64>),
}

/// Code, and what it runs on.
#[derive(Clone, Debug)]
pub(super) struct Running<T> {
    code: Arc<OrbitCode<T>>,
    /// The constants of the stages that differ, the middle one last.
    stages: Arc<[Vec<T>]>,
    numbers: Vec<T>,
    /// How the numbers are a state.
    kind: StepKind,
}

/// Steps between two looks at a guard.
const GUARDED: u64 = 256;

/// Whether multiply-adds are fused: as everything else in this program has them.
const FUSES: bool = cfg!(target_feature = "fma");

impl Coding {
    /// The orbit at its first point; `None` where there is no code for it.
    pub(super) fn begin(map: &Map, scheme: Scheme, eps: &Rational, start: &[Rational]) -> Option<Self> {
        match scheme.precision {
            Precision::Single => {
                Running::begin(map, scheme, eps, start, |x: f32| x, |x| vec![x]).map(Coding::Single)
            }
            Precision::SingleThroughDouble => {
                let widen = |x: f32| f64::from(x);
                Running::begin(map, scheme, eps, start, widen, |x| vec![x]).map(Coding::Double)
            }
            Precision::Double => {
                Running::begin(map, scheme, eps, start, |x: f64| x, |x| vec![x]).map(Coding::Double)
            }
            Precision::DoubleDouble if scheme.compensated => None,
            Precision::DoubleDouble => {
                let parts = |x: Dd| vec![x.high(), x.low()];
                Running::begin(map, scheme, eps, start, |x: Dd| x, parts).map(Coding::Double)
            }
        }
    }

    /// So many steps further; `false` where the code cannot tell, and the state is as before.
    pub(super) fn advance(&mut self, steps: u64) -> bool {
        match self {
            Coding::Single(running) => running.advance(steps),
            Coding::Double(running) => running.advance(steps),
        }
    }

    /// The coordinates of the point.
    pub(super) fn point(&self, point: &mut [Dd]) {
        match self {
            Coding::Single(running) => running.point(point),
            Coding::Double(running) => running.point(point),
        }
    }
}

impl<T: Coded + Default + PartialEq> Running<T>
where
    Dd: From<T>,
    f64: From<T>,
{
    /// The orbit of a scheme whose ε and points are a `G`, and whose step is computed in a `C`,
    /// which is the `numbers` that the code takes.
    fn begin<G: FloatScalar, C: Scalar + Copy>(
        map: &Map,
        scheme: Scheme,
        eps: &Rational,
        start: &[Rational],
        widen: impl Fn(G) -> C,
        numbers: impl Fn(C) -> Vec<T>,
    ) -> Option<Self> {
        let engine = &map.field().engine;
        let own: Vec<G> = stages(scheme.composition, round(eps));
        let own: Vec<C> = own.into_iter().map(&widen).collect();
        let (form, rounds_increments) = engine.form(own.iter().copied())?;
        let Scheme { precision, compensated, .. } = scheme;
        let kind = StepKind { precision, compensated, rounds_increments, fuses: FUSES };
        let code = engine.codes.orbit(&engine.derived, kind, form, own.len() > 1)?;
        let parameters = map.parameters().iter().map(|value| widen(round(value)));
        let mut constants: Vec<C> = parameters.collect();
        let mut scratch = Scratch::default();
        let mut prepared = |eps: &C| {
            constants.truncate(map.parameters().len());
            constants.push(*eps);
            engine.prepared(form, &constants, &mut scratch).into_iter().flat_map(&numbers).collect()
        };
        let mut state: Vec<T> = start.iter().flat_map(|x| numbers(widen(round(x)))).collect();
        state.resize(kind.numbers(start.len()), T::default());
        Some(Running { code, stages: own.iter().map(&mut prepared).collect(), numbers: state, kind })
    }

    fn advance(&mut self, steps: u64) -> bool {
        if self.kind.precision != Precision::DoubleDouble {
            self.run(steps);
            return true;
        }
        let before = self.numbers.clone();
        let mut left = steps;
        while left > 0 {
            let now = left.min(GUARDED);
            self.run(now);
            if self.numbers.last() != Some(&T::default()) {
                // Not a number is no zero.
                self.numbers = before;
                return false;
            }
            left -= now;
        }
        true
    }

    fn run(&mut self, steps: u64) {
        self.code.advance(&mut self.numbers, &self.stages, steps);
    }

    fn point(&self, point: &mut [Dd]) {
        if self.kind.precision == Precision::DoubleDouble {
            let pairs = self.numbers.chunks_exact(2);
            let wide = |pair: &[T]| Dd::new(pair[0].into(), pair[1].into());
            point.iter_mut().zip(pairs).for_each(|(x, pair)| *x = wide(pair));
        } else {
            point.iter_mut().zip(&self.numbers).for_each(|(x, number)| *x = Dd::from(*number));
        }
    }
}
