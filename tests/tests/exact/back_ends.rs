//! Compares the interpreter with generated code over ℚ, for the catalog and random fields.

use kahan_tests::back_end::BackEnd;
use kahan_tests::exact::{Rationals, q};
use kahan_tests::random_fields::{RandomField, in_order, value_of, written_file};
use kahan_tests::subject::{on_every_subject, random};

#[test]
fn the_written_random_systems_are_those_of_the_generator() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/src/random_systems.rs");
    if std::env::var("KAHAN_GOLDEN").is_ok_and(|mode| mode == "overwrite") {
        std::fs::write(path, written_file()).expect("the file can be written");
        return;
    }
    let written = std::fs::read_to_string(path).expect("the file is there");
    assert!(written == written_file(), "write the file anew with KAHAN_GOLDEN=overwrite");
}

#[test]
fn both_back_ends_agree_on_the_field() {
    on_every_subject(101, |subject, x, _, rationals| {
        let [generated, interpreted] = subject.back_ends();
        let y = rationals.point(subject.dimension());
        assert_eq!(generated.field(x), interpreted.field(x));
        assert_eq!(generated.field_jacobian(x), interpreted.field_jacobian(x));
        assert_eq!(generated.bilinear(x, &y), interpreted.bilinear(x, &y));
        assert_eq!(generated.polarized(x, &y), interpreted.polarized(x, &y));
    });
}

#[test]
fn both_back_ends_agree_on_the_linear_system() {
    on_every_subject(102, |subject, x, eps, _| {
        let [generated, interpreted] = subject.back_ends();
        assert_eq!(generated.matrix(x, eps), interpreted.matrix(x, eps));
        assert_eq!(generated.rhs(x, eps), interpreted.rhs(x, eps));
        assert_eq!(generated.det_matrix(x, eps), interpreted.det_matrix(x, eps));
        assert_eq!(generated.rational_map(x, eps), interpreted.rational_map(x, eps));
    });
}

#[test]
fn both_back_ends_agree_on_the_map() {
    on_every_subject(103, |subject, x, eps, _| {
        let [generated, interpreted] = subject.back_ends();
        assert_eq!(generated.step(x, eps), interpreted.step(x, eps));
        assert_eq!(generated.jacobian(x, eps), interpreted.jacobian(x, eps));
        assert_eq!(generated.det_jacobian(x, eps), interpreted.det_jacobian(x, eps));
        assert_eq!(generated.orbit(x, eps, 2), interpreted.orbit(x, eps, 2));
    });
}

#[test]
fn both_back_ends_agree_on_the_claims() {
    on_every_subject(104, |subject, x, eps, _| {
        let [generated, interpreted] = subject.back_ends();
        assert_eq!(generated.integrals(x, eps), interpreted.integrals(x, eps));
        assert_eq!(generated.density(x, eps), interpreted.density(x, eps));
        for name in ["P", "Q"] {
            assert_eq!(generated.bracket(name, x, eps), interpreted.bracket(name, x, eps));
        }
    });
}

fn means_what_its_tree_says(field: &RandomField, back_end: &dyn BackEnd, rationals: &mut Rationals) {
    for _ in 0..3 {
        let x = rationals.point(field.states.len());
        assert_eq!(
            back_end.field(&x),
            value_of(field, &x),
            "{} at {x:?}\n{}",
            back_end.label(),
            field.block()
        );
    }
}

#[test]
fn a_random_field_means_what_its_tree_says() {
    let mut rationals = Rationals::seeded(105);
    for (field, subject) in in_order().iter().zip(random()) {
        for back_end in subject.back_ends() {
            means_what_its_tree_says(field, back_end, &mut rationals);
        }
    }
}

#[test]
fn the_random_fields_reach_both_kinds_of_step() {
    use kahan_algebra::kahan::RationalMap;
    let reduced = |name: &str| {
        let subject = random().into_iter().find(|subject| subject.name == name).expect("a random field");
        RationalMap::of(&subject.system.field).is_some()
    };
    assert!(reduced("Dense2") && reduced("Scaled2") && reduced("Sparse6"));
    assert!(!reduced("Dense6"), "a dense field of dimension 6 is beyond the budget of the closed form");
}

#[test]
fn the_random_fields_are_not_trivial() {
    let mut rationals = Rationals::seeded(106);
    for (field, subject) in in_order().iter().zip(random()) {
        let zero = vec![q(0, 1); subject.dimension()];
        let x: Vec<_> = zero.iter().map(|_| rationals.nonzero()).collect();
        let is_quadratic = subject.generated.bilinear(&x, &x) != zero;
        assert!(is_quadratic, "{} has no quadratic part\n{}", field.name, field.block());
    }
}
