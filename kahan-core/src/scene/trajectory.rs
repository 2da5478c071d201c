//! The cheapest setting that follows a trajectory.
//!
//! In: a map, a first point, a scene. Out: of all settings that were seen to serve, over the whole horizon, the one with the least
//! price. The solution itself is computed once ([`Flow`]), each setting that comes into question is run and compared with it, and
//! one that is ten times as accurate as asked vouches for the solution. First all of it in `f64`; where roundings cover what
//! matters, in [`Dd`].

use nalgebra::SVector;

use crate::flow::{Flow, FlowScalar, NoFlow};
use crate::{Dd, Lift, PreparedStep, QuadraticField};

use super::search::{Search, Trials, VOUCHING, Verdict};
use super::setting::{Kind, Mode};
use super::{NoSetting, Scene, Setting, price};

/// The most steps of the map that a choice may cost, all of its trials together.
pub(super) const MOST_WORK: f64 = 1e6;
/// Below this tolerance the roundings of `f64` are felt so soon that it is not begun with.
const FINE: f64 = 1e-12;
/// The part of the work that the solution may take, and the part of what is left that one trial may.
const SHARE: f64 = 0.4;
/// Trials end where they are so far off, relative to the trajectory's size, or a few tolerances: there they say nothing more.
const LOST: f64 = 0.1;

pub(super) fn choose<M, const N: usize>(
    scene: &Scene,
    map: &M,
    x0: &SVector<f64, N>,
) -> Result<Setting, NoSetting>
where
    M: Lift<f64, N>,
{
    let mut work = MOST_WORK;
    if scene.tolerance >= FINE {
        match attempt::<f64, _, _, N>(scene, map, map, x0, &Mode::ALL[..2], &mut work) {
            Err(NoSetting::OutOfReach { .. } | NoSetting::Lost { .. }) => {}
            answer => return answer,
        }
    }
    let wide = map.lift::<Dd>(|parameter| Dd::from(*parameter));
    attempt::<Dd, _, _, N>(scene, map, &wide, x0, &Mode::ALL, &mut work)
}

/// The choice by the solution in T, whose field is the map's over T.
fn attempt<T, M, F, const N: usize>(
    scene: &Scene,
    map: &M,
    field: &F,
    x0: &SVector<f64, N>,
    modes: &'static [Mode],
    work: &mut f64,
) -> Result<Setting, NoSetting>
where
    T: FlowScalar,
    M: Lift<f64, N>,
    F: QuadraticField<T, N>,
{
    let piece = work_of_piece::<T>();
    let most = (SHARE * *work / piece) as usize;
    let flow = Flow::<T>::through(field, x0.map(T::from), scene.horizon, 0.0, &mut |pieces| {
        *work -= piece;
        pieces < most
    });
    let flow = flow.map_err(|why| match why {
        NoFlow::Escapes { time } => NoSetting::Lost { time },
        NoFlow::Stopped { reached } => NoSetting::TooLong { time: reached },
    })?;
    // ε times the rate, on an average, is 4 to begin with: as coarse as compositions, whose stages are shorter, may be.
    let coarsest = (flow.turning() / 8.0).ceil().clamp(1.0, MOST_WORK) as u64;
    let runs = Runs { scene, map, x0, flow: &flow, work, agreed_until: 0.0, is_short_of_work: false };
    let mut search = Search::new(runs, scene.tolerance, modes);
    let verdict = search.run(coarsest);
    let runs = search.trials();
    match verdict {
        Verdict::Choice { kind, steps, error } => {
            Ok(Setting { error, ..Setting::over(map, scene, kind, steps as f64) })
        }
        Verdict::None { least_error } if least_error < LOST => {
            // As much again, as roundings differ from one ε to the next.
            Err(NoSetting::OutOfReach { best: (2.0 * VOUCHING * least_error).log2().ceil().exp2() })
        }
        Verdict::None { .. } if runs.is_short_of_work => Err(NoSetting::TooLong { time: runs.agreed_until }),
        Verdict::None { .. } => Err(NoSetting::Lost { time: runs.agreed_until }),
    }
}

/// What a piece of a flow costs, in steps of the map: a bilinear form takes about a third of one.
fn work_of_piece<T: FlowScalar>() -> f64 {
    (T::TERMS * T::TERMS) as f64 / 12.0
}

/// Orbits of one scene, compared with the flow while there is work left.
struct Runs<'a, T, M, const N: usize> {
    scene: &'a Scene,
    map: &'a M,
    x0: &'a SVector<f64, N>,
    flow: &'a Flow<T>,
    /// The steps of the map that may still be taken.
    work: &'a mut f64,
    /// The time until which some orbit stayed near the flow.
    agreed_until: f64,
    is_short_of_work: bool,
}

impl<T, M, const N: usize> Trials for Runs<'_, T, M, N>
where
    T: FlowScalar,
    M: Lift<f64, N>,
{
    fn error(&mut self, kind: Kind, steps: u64) -> Option<f64> {
        // A comparison counts as a step.
        let work_of_step = kind.composition.stages() as f64 + 1.0;
        if steps as f64 * work_of_step > SHARE * *self.work {
            self.is_short_of_work = true;
            return None;
        }
        let setting = Setting::over(self.map, self.scene, kind, steps as f64);
        let lost = LOST.max(4.0 * self.scene.tolerance);
        let dt = Dd::from(2.0 * setting.eps);
        let mut along = self.flow.along::<N>();
        let (mut worst, mut last) = (0.0_f64, 0);
        setting.follow(self.map, *self.x0, |n, x| {
            last = n;
            worst = worst.max(along.distance(dt * Dd::from(n as f64), x));
            worst <= lost
        });
        *self.work -= last as f64 * work_of_step;
        self.agreed_until = self.agreed_until.max(f64::from(dt) * last as f64);
        Some(if worst <= lost { worst } else { f64::INFINITY })
    }

    fn price(&self, kind: Kind) -> f64 {
        price::of_step(<M::Prepared as PreparedStep<f64, N>>::COST, kind)
    }
}
