//! Counts the cost of choosing a setting.

use std::cell::Cell;

use kahan_core::nalgebra::SMatrix;
use kahan_core::prelude::*;
use kahan_core::{ExtendScalars, NoLanes, PreparedStep, QuadraticField, Quotients, StepCost};
use kahan_dynamics::{NoSetting, Scene};

use crate::systems::{Burst, E6, Lorenz, LotkaVolterra, Relaxation};

thread_local! {
    static STEPS: Cell<u64> = const { Cell::new(0) };
    static FORMS: Cell<u64> = const { Cell::new(0) };
}

/// A map that counts its steps and the evaluations of its bilinear form.
#[derive(Clone, Debug)]
struct Counted<M>(M);

impl<T: Scalar, M: QuadraticField<T, N>, const N: usize> QuadraticField<T, N> for Counted<M> {
    fn field(&self, x: &SVector<T, N>) -> SVector<T, N> {
        self.0.field(x)
    }

    fn field_jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        self.0.field_jacobian(x)
    }

    fn bilinear(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N> {
        FORMS.set(FORMS.get() + 1);
        self.0.bilinear(x, y)
    }

    fn polarized(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N> {
        self.0.polarized(x, y)
    }
}

impl<T: Scalar, M: KahanMap<T, N>, const N: usize> KahanMap<T, N> for Counted<M> {
    type Prepared = Counted<M::Prepared>;

    fn prepare(&self, eps: &T) -> Self::Prepared {
        Counted(self.0.prepare(eps))
    }
}

impl<T: Scalar, P: PreparedStep<T, N>, const N: usize> PreparedStep<T, N> for Counted<P> {
    const COST: StepCost = P::COST;

    type Wide<L: Scalar> = NoLanes;

    fn quotients(&self, x: &SVector<T, N>) -> Option<Quotients<T, N>> {
        STEPS.set(STEPS.get() + 1);
        self.0.quotients(x)
    }
}

impl<T: Scalar, M: ExtendScalars<T, N>, const N: usize> ExtendScalars<T, N> for Counted<M> {
    type Extended<U: Scalar> = Counted<M::Extended<U>>;

    fn extend_scalars<U: Scalar>(&self, convert: impl Fn(&T) -> U) -> Self::Extended<U> {
        Counted(self.0.extend_scalars(convert))
    }
}

/// Chooses a setting and returns the cost. A bilinear form costs a third of a step.
fn work<M, const N: usize>(
    map: M,
    x0: [f64; N],
    horizon: f64,
    tolerance: f64,
) -> (Result<kahan_dynamics::Setting, NoSetting>, u64)
where
    M: ExtendScalars<f64, N>,
{
    STEPS.set(0);
    FORMS.set(0);
    let answer = Scene::trajectory(horizon, tolerance).choose(&Counted(map), &SVector::from(x0));
    (answer, STEPS.get() + FORMS.get() / 3)
}

#[test]
fn a_choice_costs_at_most_a_million_steps_whatever_is_asked() {
    let check = |name: &str, (answer, work): (Result<_, NoSetting>, u64)| {
        println!("{name}: {work} steps, {answer:?}");
        assert!(work > 0 && work <= 1_000_000, "{name}: {work}");
    };
    check("a long orbit", work(LotkaVolterra, [1.5, 1.0], 500.0, 1e-9));
    check("one that is too long", work(LotkaVolterra, [1.5, 1.0], 1e6, 1e-3));
    check("chaos", work(Lorenz, [1.0, 1.0, 20.0], 20.0, 1e-6));
    check("too much chaos", work(Lorenz, [1.0, 1.0, 20.0], 1000.0, 1e-9));
    check("relaxation", work(Relaxation, [1.0, 2.0, 1.0], 40.0, 1e-6));
    check("too accurate", work(E6, [0.25, -0.5, 1.0], 10.0, 1e-33));
    check("a pole", work(Burst, [1.0], 2.0, 1e-6));
}

#[test]
fn an_easy_choice_costs_little() {
    let (answer, work) = work(E6, [0.25, -0.5, 1.0], 10.0, 1e-6);
    assert!(answer.is_ok() && work < 30_000, "{work}");
}
