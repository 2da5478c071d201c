//! An orbit by machine code.

use std::sync::Arc;

use kahan_core::{Dd, FloatScalar, Precision, Scalar};

use crate::engine::{Scratch, Scratches};
use crate::machine::{OrbitCode, StepKind};

use super::{Asked, Running};

/// Code, and what it runs on.
#[derive(Debug)]
pub(super) struct Coding<T> {
    code: Arc<OrbitCode<T>>,
    /// The constants of the stages that differ, the middle one last.
    stages: Arc<[Vec<T>]>,
    numbers: Vec<T>,
    /// How the numbers are a state.
    kind: StepKind,
}

/// Steps between two looks at a guard.
const GUARDED: u64 = 256;

impl<T: Scratches> Coding<T>
where
    Dd: From<T>,
    f64: From<T>,
{
    /// The orbit of a scheme whose ε and points are a `G`, and whose step is computed in a `C`,
    /// which is the `numbers` that the code takes; `None` where there is no code for it.
    pub(super) fn begin<G: FloatScalar, C: Scalar + Copy>(
        asked: &Asked<'_>,
        widen: fn(G) -> C,
        numbers: fn(C) -> Vec<T>,
    ) -> Option<Box<dyn Running>> {
        let engine = &asked.map.field().engine;
        let own = asked.stages(widen);
        let kind = engine.kind_at(StepKind::of_scheme(asked.scheme), own.iter().copied())?;
        if kind.precision == Precision::DoubleDouble && kind.compensated {
            return None;
        }
        let code = engine.codes.orbit(engine, kind, own.len() > 1)?;
        let mut scratch = Scratch::default();
        let prepared = |eps: &C| {
            let constants: Vec<C> = asked.parameters(widen).chain([*eps]).collect();
            engine.prepared(kind, &constants, &mut scratch).into_iter().flat_map(numbers).collect()
        };
        let stages = own.iter().map(prepared).collect();
        let mut state: Vec<T> = asked.start(widen).flat_map(numbers).collect();
        state.resize(kind.numbers(asked.start.len()), T::zero());
        Some(Box::new(Coding { code, stages, numbers: state, kind }))
    }

    fn run(&mut self, steps: u64) {
        self.code.advance(&mut self.numbers, &self.stages, steps);
    }
}

impl<T: Scratches> Running for Coding<T>
where
    Dd: From<T>,
    f64: From<T>,
{
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
            if self.numbers.last() != Some(&T::zero()) {
                // Not a number is no zero.
                self.numbers = before;
                return false;
            }
            left -= now;
        }
        true
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

    fn boxed(&self) -> Box<dyn Running> {
        let Coding { code, stages, numbers, kind } = self;
        Box::new(Coding { code: code.clone(), stages: stages.clone(), numbers: numbers.clone(), kind: *kind })
    }
}
