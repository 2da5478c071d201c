//! An orbit by the interpreter, for what has no code: the same operations in the same order.

use kahan_algebra::rational::Rational;
use kahan_core::{Dd, FloatScalar, Precision, Scheme};

use crate::Map;
use crate::engine::{Scratch, Stage};
use crate::interpreted::round;

use super::stages;

/// An orbit by the interpreter, in the numbers that it runs in.
#[derive(Clone, Debug)]
pub(super) enum Interpreting {
    Single(Walk<f32>),
    /// The numbers are those of single precision.
    SingleThroughDouble(Walk<f64>),
    Double(Walk<f64>),
    DoubleDouble(Walk<Dd>),
}

/// A state, what it lacks where that is carried, and the stages that differ.
#[derive(Clone, Debug)]
pub(super) struct Walk<V> {
    map: Map,
    /// The parameters, and ε of the whole step.
    constants: Vec<V>,
    stages: Vec<Stage<V>>,
    state: Vec<V>,
    carry: Vec<V>,
    scratch: Scratch<V>,
}

impl Interpreting {
    /// The orbit at its first point.
    pub(super) fn begin(map: &Map, scheme: Scheme, eps: &Rational, start: &[Rational]) -> Self {
        match scheme.precision {
            Precision::Single => Self::Single(Walk::begin(map, scheme, eps, start, |x: f32| x)),
            Precision::SingleThroughDouble => {
                Self::SingleThroughDouble(Walk::begin(map, scheme, eps, start, |x: f32| f64::from(x)))
            }
            Precision::Double => Self::Double(Walk::begin(map, scheme, eps, start, |x: f64| x)),
            Precision::DoubleDouble => Self::DoubleDouble(Walk::begin(map, scheme, eps, start, |x: Dd| x)),
        }
    }

    /// Goes to a point, without what is carried beside it.
    pub(super) fn put(&mut self, point: &[Dd]) {
        match self {
            Self::Single(walk) => walk.put(point, |x| x.high() as f32),
            Self::SingleThroughDouble(walk) | Self::Double(walk) => walk.put(point, Dd::high),
            Self::DoubleDouble(walk) => walk.put(point, |x| x),
        }
    }

    /// The integrals at the point.
    pub(super) fn integrals(&mut self) -> Vec<Dd> {
        match self {
            Self::Single(walk) => walk.integrals(),
            Self::SingleThroughDouble(walk) | Self::Double(walk) => walk.integrals(),
            Self::DoubleDouble(walk) => walk.integrals(),
        }
    }

    /// Takes a step, and tells whether it divides by a number that is exactly 0.
    pub(super) fn divides_by_zero(&mut self) -> bool {
        match self {
            Self::Single(walk) => walk.divides_by_zero(),
            Self::SingleThroughDouble(walk) | Self::Double(walk) => walk.divides_by_zero(),
            Self::DoubleDouble(walk) => walk.divides_by_zero(),
        }
    }

    /// So many steps further.
    pub(super) fn advance(&mut self, steps: u64) {
        match self {
            Self::Single(walk) => walk.advance(steps),
            Self::SingleThroughDouble(walk) => walk.advance_through(steps),
            Self::Double(walk) => walk.advance(steps),
            Self::DoubleDouble(walk) => walk.advance(steps),
        }
    }

    /// The coordinates of the point.
    pub(super) fn point(&self, point: &mut [Dd]) {
        match self {
            Self::Single(walk) => walk.point(point),
            Self::SingleThroughDouble(walk) | Self::Double(walk) => walk.point(point),
            Self::DoubleDouble(walk) => walk.point(point),
        }
    }
}

impl<V: FloatScalar> Walk<V>
where
    Dd: From<V>,
{
    /// The orbit of a scheme whose ε and points are a `G`, and whose step is computed in a `V`.
    fn begin<G: FloatScalar>(
        map: &Map,
        scheme: Scheme,
        eps: &Rational,
        start: &[Rational],
        widen: impl Fn(G) -> V,
    ) -> Self {
        let mut scratch = Scratch::default();
        let exact = |value: &Rational| widen(round(value));
        let mut constants: Vec<V> = map.parameters().iter().map(exact).collect();
        constants.push(V::zero());
        let stage = |eps: G| {
            if let Some(last) = constants.last_mut() {
                *last = widen(eps);
            }
            map.field().engine.stage(&constants, &mut scratch)
        };
        let stages = stages(scheme.composition, round(eps)).into_iter().map(stage).collect();
        if let Some(last) = constants.last_mut() {
            *last = exact(eps);
        }
        let state: Vec<V> = start.iter().map(exact).collect();
        let carry = if scheme.compensated { vec![V::zero(); state.len()] } else { Vec::new() };
        Walk { map: map.clone(), constants, stages, state, carry, scratch }
    }

    fn advance(&mut self, steps: u64) {
        let Walk { map, stages, state, carry, scratch, .. } = self;
        map.field().engine.run(stages, steps, scratch, |step, rounds, registers, room| {
            if carry.is_empty() {
                step.advance(rounds, state, registers, room);
            } else {
                step.advance_with_carry(rounds, [state, carry], registers, room);
            }
        });
    }

    fn put(&mut self, point: &[Dd], narrow: impl Fn(Dd) -> V) {
        self.state.iter_mut().zip(point).for_each(|(entry, x)| *entry = narrow(*x));
        self.carry.fill(V::zero());
    }

    fn integrals(&mut self) -> Vec<Dd> {
        let Walk { map, constants, state, scratch, .. } = self;
        map.field().engine.integrals(constants, state, scratch).map(Dd::from).collect()
    }

    fn divides_by_zero(&mut self) -> bool {
        let Walk { map, stages, state, scratch, .. } = self;
        let mut divides = false;
        map.field().engine.run(stages, 1, scratch, |step, rounds, registers, room| {
            step.advance(rounds, state, registers, room);
            divides |= step.has_divided_by_zero(registers, room);
        });
        divides
    }

    fn point(&self, point: &mut [Dd]) {
        point.iter_mut().zip(&self.state).for_each(|(x, entry)| *x = Dd::from(*entry));
    }
}

impl Walk<f64> {
    /// Steps of a state in single precision, each rounded once.
    fn advance_through(&mut self, steps: u64) {
        let single = |x: f64| f64::from(x as f32);
        let Walk { map, stages, state, carry, scratch, .. } = self;
        let mut next = state.clone();
        map.field().engine.run(stages, steps, scratch, |step, rounds, registers, room| {
            next.copy_from_slice(state);
            next.iter_mut().zip(carry.iter()).for_each(|(base, carry)| *base += *carry);
            step.add_increment(rounds, [state, &mut next], registers, room);
            for (x, next) in state.iter_mut().zip(&next) {
                *x = single(*next);
            }
            for (carry, (x, next)) in carry.iter_mut().zip(state.iter().zip(&next)) {
                *carry = single(*next - *x);
            }
        });
    }
}
