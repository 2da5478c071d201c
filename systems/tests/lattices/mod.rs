//! Tests families: rings of three and four sites equal systems of the catalog, and sums are
//! conserved.

use std::ops::Range;

use kahan_algebra::diagnostics::Kind;
use kahan_algebra::lexer::lex;
use kahan_algebra::read;
use kahan_core::prelude::*;
use kahan_systems::entry::block_range;
use kahan_systems::lattices::{ALL, Entry, Kdv, Species, Toda, VolterraChain, VolterraRing};
use kahan_systems::{VolterraFour, VolterraLattice};

fn rational(p: i64, q: i64) -> BigRational {
    BigRational::new(p.into(), q.into())
}

fn start(count: usize) -> Vec<BigRational> {
    (0..count).map(|k| rational(k as i64 % 5 + 1, 7)).collect()
}

#[test]
fn rings_of_three_and_four_sites_are_those_of_the_catalog() {
    let eps = rational(1, 10);
    let mut three = start(3);
    VolterraRing.at(eps.clone(), 3).unwrap().advance(&mut three, 3);
    let plain = VolterraLattice.orbit(SVector::from_iterator(start(3)), eps.clone()).nth(3).unwrap();
    assert_eq!(three, plain.as_slice());

    let mut four = start(4);
    VolterraRing.at(eps.clone(), 4).unwrap().advance(&mut four, 3);
    let plain = VolterraFour.orbit(SVector::from_iterator(start(4)), eps).nth(3).unwrap();
    assert_eq!(four, plain.as_slice());
}

fn is_exact<M: LatticeMap<BigRational>>(map: impl Fn(usize) -> M, sites: Range<usize>) {
    for sites in sites {
        let mut at = map(sites).at(rational(1, 9), sites).unwrap();
        let start = start(sites * <M as LatticeMap<BigRational>>::BLOCK);
        let mut state = start.clone();
        at.step(&mut state);
        assert_eq!(at.residual(&start, &state), rational(0, 1), "{sites} sites");
        at.step_back(&mut state);
        assert_eq!(state, start, "{sites} sites");
    }
}

#[test]
fn exact_steps_satisfy_the_defining_equation_at_every_number_of_sites() {
    is_exact(|_| VolterraRing, 1..9);
    is_exact(|_| VolterraChain, 1..9);
    is_exact(|_| Toda, 1..7);
    is_exact(|_| Kdv { h: rational(1, 2) }, 1..9);
    is_exact(|sites| Species { mu: rational(1, 3), r: start(sites) }, 1..9);
}

#[test]
fn sums_and_modified_energies_are_kept_exactly() {
    for sites in 1..7 {
        let mut at = Kdv { h: rational(1, 2) }.at(rational(1, 50), sites).unwrap();
        let mut state = start(sites);
        let kept = (at.integrals(&state), at.modified_energy(&state));
        at.advance(&mut state, 2);
        assert_eq!((at.integrals(&state), at.modified_energy(&state)), kept, "{sites} sites");
        assert_eq!(at.integral_names(), ["mass"]);
    }
    for sites in 1..7 {
        let ring = VolterraRing.at(rational(1, 10), sites).unwrap();
        let chain = VolterraChain.at(rational(1, 10), sites).unwrap();
        let (mut closed, mut open) = (start(sites), start(sites));
        let sum = ring.integrals(&closed);
        ring.advance(&mut closed, 2);
        chain.advance(&mut open, 2);
        assert_eq!((ring.integrals(&closed), chain.integrals(&open)), (sum.clone(), sum));
    }
}

#[test]
fn every_name_stands_for_the_family_of_its_file() {
    let types = ALL.map(|Entry { command: name, text, .. }| {
        assert_eq!(text.matches("kahan! {").count(), 1, "{name}: its text holds one block");
        let block = &text[block_range(text).expect("a block")];
        let reading = read(&lex(block).tokens);
        let family = reading.family().unwrap_or_else(|mistakes| panic!("{name}: {mistakes:?}"));
        family.expect("a family").name().to_owned()
    });
    assert_eq!(types, ["VolterraRing", "VolterraChain", "Toda", "Species", "Kdv"]);
}

#[test]
fn no_constant_stencil_makes_the_energy_of_toda_its_hamiltonian() {
    let toda = "for i in periodic { a[i]dot = a[i]*(b[i+1] - b[i]); b[i]dot = 2*(a[i]^2 - a[i-1]^2); }";
    for energy in ["b[i]^2 + 2*a[i]^2", "b[i]^3/3 + a[i]^2*(b[i] + b[i+1])"] {
        let reading = read(&lex(&format!("{toda} hamiltonian H = sum({energy});")).tokens);
        let kinds: Vec<Kind> = reading.diagnostics().iter().map(|mistake| mistake.kind).collect();
        assert_eq!(kinds, [Kind::FalseClaim], "{energy}");
    }
}
