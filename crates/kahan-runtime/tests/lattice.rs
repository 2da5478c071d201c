//! Compares families read at run time with compiled families, for chains of any length.

use allocation_counter::measure;
use kahan_core::observe::first_crossing;
use kahan_core::prelude::*;
use kahan_core::{LatticeMap, Level, Step, Workspace};
use kahan_runtime::{Field, FieldText, Lattice, LatticeError, ParameterError};

macro_rules! family {
    ($text:ident, $($block:tt)*) => {
        kahan! { $($block)* }
        const $text: &str = stringify!($($block)*);
    };
}

family! { RING,
    pub struct Ring;
    for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }
    integral S = sum(x[i]);
}

family! { TODA,
    pub struct Toda;
    for i in open {
        a[i]dot = a[i]*(b[i+1] - b[i]);
        b[i]dot = 2*(a[i]^2 - a[i-1]^2);
    }
}

family! { KDV,
    pub struct Kdv { h }
    for i in periodic {
        u[i]dot = -3*(u[i+1]^2 - u[i-1]^2)/(2*h) - (u[i+2] - 2*u[i+1] + 2*u[i-1] - u[i-2])/(2*h^3);
    }
    integral mass = sum(u[i]);
    hamiltonian H = sum((u[i+1] - u[i])^2/(2*h^2) - u[i]^3);
}

family! { SHORE,
    pub struct Shore { mu, r, s }
    for i in open { n[i]dot = n[i]*(r[i] + s[i]*n[i] - mu*(n[i-1] + n[i+1])); }
}

family! { SPRINGS,
    pub struct Springs { alpha }
    for i in periodic {
        q[i]dot = p[i];
        p[i]dot = q[i-1] - 2*q[i] + q[i+1] + alpha*((q[i+1] - q[i])^2 - (q[i] - q[i-1])^2);
    }
}

family! { RIVALS,
    pub struct Rivals { d }
    for i in open {
        u[i]dot = d*(u[i-1] - 2*u[i] + u[i+1]) + u[i]*(1 - u[i] - v[i]);
        v[i]dot = (v[i-1] - 2*v[i] + v[i+1])/4 + v[i]*(1 - v[i] - u[i]/2);
    }
}

family! { FAR,
    pub struct Far;
    for i in periodic { x[i]dot = x[i]*(x[i+7] - x[i-5]); }
}

fn lattice(text: &str) -> Lattice {
    let family = FieldText::new(text.to_owned(), "family".to_owned()).family().unwrap();
    Lattice::of(&family.expect("a family"))
}

fn start(len: usize) -> Vec<f64> {
    (0..len).map(|k| 1.0 + 0.5 * (0.7 * k as f64).sin()).collect()
}

/// Steps a run-time chain and a compiled chain at each instruction-set level, and returns the
/// largest difference.
fn apart<M: LatticeMap<f64>>(text: &str, map: &M, eps: f64, sites: usize, values: &[(&str, &[f64])]) -> f64 {
    let lattice = lattice(text);
    let mut worst = 0.0_f64;
    for level in [Level::Baseline, Level::Avx2, Level::Avx512, Level::Neon]
        .into_iter()
        .filter(|level| level.is_available())
    {
        let chain = lattice.at(eps, sites, values.iter().copied()).unwrap();
        let mut chain = chain.at_level(level).unwrap();
        let mut state = start(chain.unknowns());
        let mut expected = state.clone();
        let mut compiled = map.at(eps, sites).unwrap().at_level(level).unwrap();
        for _ in 0..4 {
            chain.step(&mut state).unwrap();
            compiled.step(&mut expected);
            let differences = state.iter().zip(&expected).map(|(a, b)| (a - b).abs());
            worst = differences.fold(worst, f64::max);
            assert!(state.iter().all(|x| x.is_finite()));
        }
    }
    worst
}

/// Tests chains of up to about thirty sites, which are eliminated as a whole, and longer ones.
#[test]
fn chains_have_the_bits_of_the_macro() {
    for sites in [1, 2, 3, 4, 5, 8, 13, 40, 300, 4500] {
        let r: Vec<f64> = (0..sites).map(|i| 1.0 + 0.1 * (i % 13) as f64).collect();
        let s: Vec<f64> = (0..sites).map(|i| -1.0 - 0.01 * (i % 13) as f64).collect();
        let shore = Shore { mu: 0.3, r: r.clone(), s: s.clone() };
        let values: [(&str, &[f64]); 3] = [("s", &s), ("mu", &[0.3]), ("r", &r)];
        assert_eq!(apart(RING, &Ring, 0.05, sites, &[]), 0.0, "{sites}");
        assert_eq!(apart(TODA, &Toda, 0.05, sites, &[]), 0.0, "{sites}");
        assert_eq!(apart(KDV, &Kdv { h: 0.5 }, 0.01, sites, &[("h", &[0.5])]), 0.0, "{sites}");
        assert_eq!(apart(SHORE, &shore, 0.05, sites, &values), 0.0, "{sites}");
        assert_eq!(
            apart(SPRINGS, &Springs { alpha: 0.25 }, 0.05, sites, &[("alpha", &[0.25])]),
            0.0,
            "{sites}"
        );
        assert_eq!(apart(RIVALS, &Rivals { d: 0.5 }, 0.02, sites, &[("d", &[0.5])]), 0.0, "{sites}");
    }
}

#[test]
fn a_singular_part_sends_the_step_to_the_whole() {
    let (sites, eps) = (300, 0.125);
    let mut state = start(sites);
    (state[0], state[2]) = (-1.0 / eps, 0.0);
    let mut expected = state.clone();
    let mut compiled = LatticeMap::at(&Ring, eps, sites).unwrap();
    compiled.step(&mut expected);
    assert_eq!(compiled.whole_eliminations(), 1);
    lattice(RING).at(eps, sites, NOTHING).unwrap().step(&mut state).unwrap();
    assert_eq!(state, expected);
}

#[test]
fn long_chains_of_rare_shapes_are_those_of_the_macro() {
    for sites in [300, 3000] {
        assert!(apart(FAR, &Far, 0.05, sites, &[]) < 1e-13, "{sites}");
    }
}

#[test]
fn what_is_kept_is_what_the_macro_says_is_kept() {
    for sites in [1, 5, 64, 1000] {
        let lattice = lattice(KDV);
        assert_eq!((lattice.integrals(), lattice.hamiltonian()), (vec!["mass"], Some("H")));
        let mut chain = lattice.at(0.01, sites, [("h", [0.5])]).unwrap();
        let mut compiled = LatticeMap::at(&Kdv { h: 0.5 }, 0.01, sites).unwrap();
        let mut state = start(sites);
        assert_eq!(chain.integrals(&state).unwrap(), compiled.integrals(&state));
        assert_eq!(chain.hamiltonian(&state).unwrap(), Some(compiled.hamiltonian(&state)));
        let before = chain.modified_energy(&state).unwrap().unwrap();
        let bound = 1e-14 * sites as f64;
        assert!((before - compiled.modified_energy(&state)).abs() <= bound);
        for _ in 0..20 {
            chain.step(&mut state).unwrap();
        }
        let after = chain.modified_energy(&state).unwrap().unwrap();
        assert!((after - before).abs() <= 20.0 * bound, "{sites}: {}", after - before);
    }
    let mut ring = lattice(RING).at::<&str, [f64; 1]>(0.1, 4, []).unwrap();
    assert_eq!(ring.hamiltonian(&start(4)).unwrap(), None);
    assert_eq!(ring.modified_energy(&start(4)).unwrap(), None);
}

#[test]
fn one_number_serves_all_sites() {
    let shore = lattice(SHORE);
    let step = |r: &[f64]| {
        let mut state = start(5);
        shore.at(0.05, 5, [("mu", &[0.3][..]), ("r", r), ("s", &[-1.0])]).unwrap().step(&mut state).unwrap();
        state
    };
    assert_eq!(step(&[1.5]), step(&[1.5; 5]));
    assert_ne!(step(&[1.5]), step(&[1.5, 1.5, 1.5, 1.5, 1.6]));
}

#[test]
fn steps_allocate_nothing() {
    let mut chain = lattice(KDV).at(0.01, 200, [("h", [0.5])]).unwrap();
    let mut state = start(200);
    let counted = measure(|| (0..10).for_each(|_| chain.step(&mut state).unwrap()));
    assert_eq!(counted.count_total, 0);
    let counted = measure(|| drop(chain.modified_energy(&state)));
    assert!(counted.count_total > 0, "nothing is counted");
}

#[test]
fn mistakes_are_values() {
    let shore = lattice(SHORE);
    let at = |sites, values: &[(&str, &[f64])]| shore.at(0.1, sites, values.iter().copied()).unwrap_err();
    let one: &[f64] = &[1.0];
    assert_eq!(at(0, &[("mu", one), ("r", one), ("s", one)]), LatticeError::NoSites);
    assert_eq!(
        at(3, &[("mu", one), ("r", &[1.0, 2.0]), ("s", one)]).to_string(),
        "the parameter `r` has 2 numbers; give one, or 3, one a site"
    );
    assert_eq!(
        at(3, &[("mu", &[1.0, 2.0, 3.0]), ("r", one), ("s", one)]).to_string(),
        "the parameter `mu` has 3 numbers; give one, as the chain has it once"
    );
    let missing = ParameterError::Missing(vec!["mu".to_owned(), "s".to_owned()]);
    assert_eq!(at(3, &[("r", one)]), LatticeError::Parameter(missing));
    let twice = ParameterError::Twice("r".to_owned());
    assert_eq!(at(3, &[("r", one), ("mu", one), ("r", one)]), LatticeError::Parameter(twice));
    let infinite = ParameterError::NotFinite("r".to_owned());
    assert_eq!(at(2, &[("mu", one), ("r", &[1.0, f64::NAN]), ("s", one)]), LatticeError::Parameter(infinite));
    assert!(at(3, &[("nu", one)]).to_string().contains("no parameter `nu`"));
    assert!(
        lattice(KDV).at(0.1, 9, [("h", [0.0])]).unwrap_err().to_string().contains("divides by zero at h = 0")
    );
    let mut chain = lattice(RING).at::<&str, [f64; 1]>(0.1, 4, []).unwrap();
    assert_eq!(chain.step(&mut [1.0; 3]).unwrap_err().expected(), 4);
    assert!(chain.integrals(&[1.0; 5]).is_err() && chain.modified_energy(&[1.0; 5]).is_err());
    let mut state = [1.0, f64::NAN, 1.0, 1.0];
    chain.step(&mut state).unwrap();
    assert!(state.iter().any(|x| x.is_nan()));
}

const NOTHING: [(&str, [f64; 1]); 0] = [];

/// Returns the time at which the first entry of a state crosses zero.
fn zero(map: &dyn Step<Scalar = f64>, start: &[f64]) -> Option<f64> {
    first_crossing(map, start.to_vec(), 10_000, |x| x[0]).map(|crossing| crossing.time)
}

#[test]
fn one_function_takes_every_map() {
    kahan! {
        struct Turn;
        xdot = y;
        ydot = -x;
    }
    const SPRINGS: &str = "for i in periodic { q[i]dot = p[i]; p[i]dot = q[i-1] - 2*q[i] + q[i+1] - q[i]; }";
    kahan! {
        struct Springs;
        for i in periodic { q[i]dot = p[i]; p[i]dot = q[i-1] - 2*q[i] + q[i+1] - q[i]; }
    }
    let eps = 0.01;
    let text = Field::parse("xdot = y; ydot = -x;").unwrap().map().unwrap().at(eps);
    let maps: [Box<dyn Step<Scalar = f64>>; 4] = [
        Box::new(KahanMap::at(&Turn, eps)),
        Box::new(text),
        Box::new(LatticeMap::at(&Springs, eps, 5).unwrap()),
        Box::new(lattice(SPRINGS).at(eps, 5, NOTHING).unwrap()),
    ];
    let starts = [[1.0, 0.0].to_vec(), [1.0, 0.0].repeat(5)];
    for (k, map) in maps.iter().enumerate() {
        let time = zero(&**map, &starts[k / 2]).unwrap();
        let quarter = std::f64::consts::FRAC_PI_2;
        assert!((time - quarter).abs() < eps * eps * quarter, "{k}: {time}");
    }
}

#[test]
fn a_room_serves_chains_in_turn() {
    let mut workspace = Workspace::new();
    let values = [("h", &[0.5][..])];
    let mut chains = [
        lattice(RING).at(0.02, 40, NOTHING).unwrap(),
        lattice(TODA).at(0.03, 40, NOTHING).unwrap(),
        lattice(KDV).at(0.02, 40, values).unwrap(),
        lattice(KDV).at(0.01, 40, values).unwrap(),
    ];
    for _ in 0..2 {
        for chain in &mut chains {
            let begin = start(chain.unknowns());
            let (mut x, mut part, mut expected) = (begin.clone(), begin.clone(), begin);
            Step::advance(chain, &mut x, 7, &mut workspace).unwrap();
            let eps = *Step::eps(chain);
            Step::part(chain, &eps, &mut part, &mut workspace).unwrap();
            chain.step(&mut expected).unwrap();
            assert_eq!(part, expected);
            (1..7).for_each(|_| chain.step(&mut expected).unwrap());
            assert_eq!(x, expected);
        }
    }
}
