//! The eight systems, each with all contenders.

use kahan_bench_fields::{self as fields, EPS, start};
use kahan_core::prelude::*;
use nalgebra::{Const, DimMin};

use crate::by_hand::{clebsch, e1, e3, e5, e6, euler_top, lorenz, lotka_volterra};
use crate::contender::{Contender, Role};
use crate::journey::{Journey, journeys};
use crate::rivals::{lu, midpoint, runge_kutta};

/// The name of the contender that solves Kahan's equations by LU, whose latency has a limit.
pub(crate) const STATIC_LU: &str = "Kahan by SMatrix LU";

pub(crate) struct System {
    pub(crate) name: &'static str,
    pub(crate) dimension: usize,
    /// The contenders for one step. The first contender, the generated step, is the reference.
    pub(crate) steps: Vec<Contender>,
    pub(crate) journeys: Vec<Journey>,
}

pub(crate) fn all() -> Vec<System> {
    let (top, lorenz_map, clebsch_map) = (fields::euler_top(), fields::lorenz(), fields::clebsch());
    vec![
        system("LotkaVolterra", fields::LotkaVolterra, start::LOTKA_VOLTERRA, lotka_volterra::contenders),
        system("EulerTop", top, start::SPACE, |start, eps| euler_top::contenders(top, start, eps)),
        system("E1", fields::E1, start::SPACE, e1::contenders),
        system("E3", fields::E3, start::SPACE, e3::contenders),
        system("E5", fields::E5, start::SPACE, e5::contenders),
        system("E6", fields::E6, start::SPACE, e6::contenders),
        system("Lorenz", lorenz_map, start::LORENZ, |start, eps| lorenz::contenders(lorenz_map, start, eps)),
        system("Clebsch", clebsch_map, start::CLEBSCH, |start, eps| {
            clebsch::contenders(clebsch_map, start, eps)
        }),
    ]
}

fn system<M, const N: usize>(
    name: &'static str,
    map: M,
    start: [f64; N],
    by_hand: impl Fn([f64; N], f64) -> Vec<Contender>,
) -> System
where
    M: KahanMap<f64, N> + Copy + 'static,
    M::Prepared: 'static,
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let at = map.at(EPS);
    let mut steps = vec![
        Contender::new("generated, prepared", Role::Baseline, start, move |x| {
            at.step(&SVector::from(x)).into()
        }),
        Contender::new("generated, step(&x, eps)", Role::Generated, start, move |x| {
            map.step(&SVector::from(x), EPS).into()
        }),
        Contender::of_orbit("generated, orbit", Role::Generated, start, move |x, steps| {
            map.orbit(SVector::from(x), EPS).nth(steps).expect("an orbit over floats goes on").into()
        }),
    ];
    steps.extend(by_hand(start, EPS));
    steps.extend([
        Contender::new(STATIC_LU, Role::Rival, start, lu::of_static_size(map, EPS)),
        Contender::new("Kahan by DMatrix LU", Role::Rival, start, lu::of_dynamic_size(map, EPS)),
        Contender::new(midpoint::NAME, Role::Rival, start, midpoint::step(map, EPS)),
        Contender::new("Runge-Kutta 4", Role::Rival, start, runge_kutta::step(map, EPS)),
    ]);
    System { name, dimension: N, steps, journeys: journeys(map, start) }
}
