//! An orbit by machine code.

use kahan_core::{Dd, FloatScalar, Precision, Scalar};

use crate::engine::{CodedStages, Scratches};
use crate::machine::StepKind;

use super::{Asked, Running};

/// Code, and what it runs on.
#[derive(Clone, Debug)]
pub(super) struct Coding<T> {
    stages: CodedStages<T>,
    numbers: Vec<T>,
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
    pub(super) fn begin<G: FloatScalar, C: Scalar + Copy, const N: usize>(
        asked: &Asked<'_>,
        widen: fn(G) -> C,
        numbers: fn(C) -> [T; N],
    ) -> Option<Box<dyn Running>> {
        let kind = StepKind::of_scheme(asked.scheme);
        if kind.precision == Precision::DoubleDouble && kind.compensated {
            return None;
        }
        let stages = asked.map.field().engine.coded_stages(kind, &asked.stages(widen), numbers)?;
        let mut state: Vec<T> = asked.start(widen).flat_map(numbers).collect();
        state.resize(kind.numbers(asked.start.len()), T::zero());
        Some(Box::new(Coding { stages, numbers: state }))
    }

    fn is_wide(&self) -> bool {
        self.stages.kind().precision == Precision::DoubleDouble
    }
}

impl<T: Scratches> Running for Coding<T>
where
    Dd: From<T>,
    f64: From<T>,
{
    fn advance(&mut self, steps: u64) -> bool {
        if !self.is_wide() {
            self.stages.advance(&mut self.numbers, steps);
            return true;
        }
        let before = self.numbers.clone();
        let mut left = steps;
        while left > 0 {
            let now = left.min(GUARDED);
            self.stages.advance(&mut self.numbers, now);
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
        if self.is_wide() {
            let pairs = self.numbers.chunks_exact(2);
            let wide = |pair: &[T]| Dd::new(pair[0].into(), pair[1].into());
            point.iter_mut().zip(pairs).for_each(|(x, pair)| *x = wide(pair));
        } else {
            point.iter_mut().zip(&self.numbers).for_each(|(x, number)| *x = Dd::from(*number));
        }
    }

    fn boxed(&self) -> Box<dyn Running> {
        Box::new(self.clone())
    }
}
