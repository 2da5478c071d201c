//! An orbit by the interpreter, for what has no code: the same operations in the same order.

use kahan_core::{Dd, FloatScalar};

use crate::Map;
use crate::engine::{Scratch, Stage, integral_constants};
use crate::machine::StepKind;

use super::{Asked, Running};

/// An orbit by the interpreter, of which more can be asked.
pub(super) trait Interpreting: Running {
    /// Goes to a point, without what is carried beside it.
    fn put(&mut self, point: &[Dd]);

    /// The integrals at the point.
    fn integrals(&mut self) -> Vec<Dd>;

    /// Takes a step, and tells whether it divides by a number that is exactly 0.
    fn divides_by_zero(&mut self) -> bool;
}

/// A state, what it lacks where that is carried, and the stages that differ.
#[derive(Clone, Debug)]
pub(super) struct Walk<V> {
    map: Map,
    kind: StepKind,
    /// What integrals take.
    constants: Vec<V>,
    stages: Vec<Stage<V>>,
    state: Vec<V>,
    carry: Vec<V>,
    scratch: Scratch<V>,
    /// A coordinate of a point, as a number of the state.
    narrow: fn(Dd) -> V,
}

impl<V: FloatScalar + Send + Sync> Walk<V>
where
    Dd: From<V>,
{
    /// The orbit of a scheme whose ε and points are a `G`, and whose step is computed in a `V`.
    pub(super) fn begin<G: FloatScalar>(
        asked: &Asked<'_>,
        widen: fn(G) -> V,
        narrow: fn(Dd) -> V,
    ) -> Box<dyn Interpreting> {
        let (map, scheme) = (asked.map.clone(), asked.scheme);
        let mut scratch = Scratch::default();
        let stages =
            asked.stages(widen).iter().map(|own| map.field().engine.stage(own, &mut scratch)).collect();
        let constants = integral_constants(&asked.constants::<G>(), scheme.composition);
        let constants = constants.into_iter().map(widen).collect();
        let state: Vec<V> = asked.start(widen).collect();
        let carry = if scheme.compensated { vec![V::zero(); state.len()] } else { Vec::new() };
        let kind = StepKind::of_scheme(scheme);
        Box::new(Walk { constants, map, kind, stages, state, carry, scratch, narrow })
    }
}

impl<V: FloatScalar + Send + Sync> Running for Walk<V>
where
    Dd: From<V>,
{
    fn advance(&mut self, steps: u64) -> bool {
        let Walk { map, stages, state, carry, scratch, narrow, .. } = self;
        map.field().engine.run(stages, steps, scratch, |step, rounds_increments, registers, workspace| {
            let kind = StepKind { rounds_increments, ..self.kind };
            step.advance_as(kind, [state, carry], registers, workspace, |x| narrow(Dd::from(x)));
        });
        true
    }

    fn point(&self, point: &mut [Dd]) {
        point.iter_mut().zip(&self.state).for_each(|(x, entry)| *x = Dd::from(*entry));
    }

    fn boxed(&self) -> Box<dyn Running> {
        Box::new(self.clone())
    }
}

impl<V: FloatScalar + Send + Sync> Interpreting for Walk<V>
where
    Dd: From<V>,
{
    fn put(&mut self, point: &[Dd]) {
        self.state.iter_mut().zip(point).for_each(|(entry, x)| *entry = (self.narrow)(*x));
        self.carry.fill(V::zero());
    }

    fn integrals(&mut self) -> Vec<Dd> {
        let Walk { map, constants, state, scratch, .. } = self;
        map.field().engine.integrals(constants, state, scratch).map(Dd::from).collect()
    }

    fn divides_by_zero(&mut self) -> bool {
        let Walk { map, stages, state, scratch, .. } = self;
        let mut divides = false;
        map.field().engine.run(stages, 1, scratch, |step, rounds, registers, workspace| {
            step.advance(rounds, [state, &mut []], registers, workspace);
            divides |= step.has_divided_by_zero(registers, workspace);
        });
        divides
    }
}
