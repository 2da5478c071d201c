//! Steps with two prepared forms: a general form, and a form that is faster in some cases.

use nalgebra::SVector;

use crate::Scalar;
use crate::scalar::tuning;

use super::{PreparedStep, Quotients, StepCost, StraightStep};

/// A step with two forms. One form divides by ε, and is used for floats if ε is neither tiny nor
/// huge. The other form, `general`, suits every scalar and every ε.
///
/// With h = 1/(2ε) prepared, a denominator 1 + 2εx becomes h + x, which saves a multiplication. The
/// form that divides overflows sooner, and cannot run in lanes.
#[derive(Clone, Copy, Debug)]
pub struct OverEps<S, G> {
    /// The form that divides by ε, `None` if ε or the scalar does not allow it.
    over_eps: Option<S>,
    general: G,
}

/// A step with kernel S (C constants), which divides by ε, and a general kernel G (D constants).
pub type StepOverEps<S, G, T, const C: usize, const D: usize> =
    OverEps<StraightStep<S, T, C>, StraightStep<G, T, D>>;

impl<S, G, T: Scalar, const C: usize, const D: usize> StepOverEps<S, G, T, C, D> {
    /// Creates the step at `eps`. `over_eps` is called only if ε and the scalar allow the form that
    /// divides by ε.
    #[inline(always)]
    pub fn new(eps: &T, over_eps: impl FnOnce() -> [T; C], general: impl FnOnce() -> [T; D]) -> Self {
        let general = StraightStep::new(general());
        let over_eps = tuning::may_divide_by(eps).then(|| StraightStep::new(over_eps()));
        Self { over_eps, general }
    }
}

impl<S, G, T, const N: usize> PreparedStep<T, N> for OverEps<S, G>
where
    S: PreparedStep<T, N>,
    G: PreparedStep<T, N>,
    T: Scalar,
{
    const COST: StepCost = S::COST;
    const HAS_LANES: bool = S::HAS_LANES;

    type Wide<L: Scalar> = G::Wide<L>;

    #[inline(always)]
    fn quotients(&self, x: &SVector<T, N>) -> Option<Quotients<T, N>> {
        if !tuning::divides_by_eps::<T>() {
            return self.general.quotients(x);
        }
        match &self.over_eps {
            Some(over_eps) => over_eps.quotients(x),
            None => out_of_line(self.general.clone(), x.clone()),
        }
    }

    #[inline(always)]
    fn finish<R>(&self, x: &SVector<T, N>, finish: impl FnOnce(Quotients<T, N>) -> R) -> Option<R> {
        if !tuning::divides_by_eps::<T>() {
            return self.general.finish(x, finish);
        }
        match &self.over_eps {
            Some(over_eps) => over_eps.finish(x, finish),
            None => out_of_line(self.general.clone(), x.clone()).map(finish),
        }
    }

    #[inline(always)]
    fn widen<L: Scalar>(&self, spread: impl Fn(&T) -> L) -> G::Wide<L> {
        self.general.widen(spread)
    }

    #[inline(always)]
    fn gather<L: Scalar, const W: usize>(each: [&Self; W], pack: impl Fn([&T; W]) -> L) -> G::Wide<L> {
        G::gather(each.map(|step| &step.general), pack)
    }
}

/// Evaluates the form that does not divide by ε. The call gets a copy of the state, so that a loop
/// can keep the state in registers.
#[cold]
#[inline(never)]
fn out_of_line<G, T, const N: usize>(general: G, x: SVector<T, N>) -> Option<Quotients<T, N>>
where
    G: PreparedStep<T, N>,
    T: Scalar,
{
    let quotients = general.quotients(&x)?;
    // The increment of floats is returned, because it takes half as much memory.
    Some(if tuning::is_float::<T>() {
        Quotients::whole(quotients.increment().data.0[0].clone())
    } else {
        quotients
    })
}

/// A step with one form for lanes and another for orbits. The form for orbits has a second
/// division, which shortens the critical path.
#[derive(Clone, Copy, Debug)]
pub struct OneOrbit<S, G> {
    step: S,
    of_lanes: G,
}

/// A step with kernel S (C constants) for orbits, and kernel G (D constants) for lanes.
pub type StepOfOneOrbit<S, G, T, const C: usize, const D: usize> =
    OneOrbit<StraightStep<S, T, C>, StraightStep<G, T, D>>;

impl<S, G, T: Scalar, const C: usize, const D: usize> StepOfOneOrbit<S, G, T, C, D> {
    /// Creates the step from the constants of both forms.
    #[inline(always)]
    pub fn new(step: impl FnOnce() -> [T; C], of_lanes: impl FnOnce() -> [T; D]) -> Self {
        Self { step: StraightStep::new(step()), of_lanes: StraightStep::new(of_lanes()) }
    }
}

impl<S, G, T, const N: usize> PreparedStep<T, N> for OneOrbit<S, G>
where
    S: PreparedStep<T, N>,
    G: PreparedStep<T, N>,
    T: Scalar,
{
    const COST: StepCost = S::COST;
    const HAS_LANES: bool = S::HAS_LANES;

    type Wide<L: Scalar> = G::Wide<L>;

    #[inline(always)]
    fn quotients(&self, x: &SVector<T, N>) -> Option<Quotients<T, N>> {
        self.step.quotients(x)
    }

    #[inline(always)]
    fn widen<L: Scalar>(&self, spread: impl Fn(&T) -> L) -> G::Wide<L> {
        self.of_lanes.widen(spread)
    }

    #[inline(always)]
    fn gather<L: Scalar, const W: usize>(each: [&Self; W], pack: impl Fn([&T; W]) -> L) -> G::Wide<L> {
        G::gather(each.map(|step| &step.of_lanes), pack)
    }
}
