//! What the suites run over: a system with parameter values, in both back ends.
//!
//! In: the catalog with parameters from a test, and the random fields with their own. Out: [`Subject`]s, and
//! [`on_every_back_end`], which calls a law at seeded points of all of them.

use std::sync::LazyLock;

use kahan_algebra::lexer::lex;
use kahan_algebra::system::System;
use kahan_core::Constant;
use kahan_core::prelude::*;
use kahan_systems::registry::{FURTHER, SYSTEMS};
use kahan_systems::{E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, LotkaVolterra};
use kahan_systems::{
    HenonHeiles, LagrangeTop, Lorenz, VolterraFour, VolterraLattice, Weierstrass, ZhukovskyVolterra,
};

use crate::back_end::{BackEnd, Claims, Generated, Interpreted};
use crate::exact::{Q, Rationals, Vector, q, shown};
use crate::{float_maps, random_fields};

/// One system with its parameters, in both back ends.
#[allow(missing_debug_implementations)]
pub struct Subject {
    /// The system's name.
    pub name: &'static str,
    /// What the front end reads in its text.
    pub system: &'static System,
    /// The parameters' values.
    pub parameters: Vector,
    /// The code that the macro wrote.
    pub generated: Box<dyn BackEnd>,
    /// The interpreter.
    pub interpreted: Interpreted,
}

impl Subject {
    fn new(system: &'static System, parameters: Vector, generated: Box<dyn BackEnd>) -> Self {
        let interpreted = Interpreted::new(system, &parameters);
        Self { name: system.name(), system, parameters, generated, interpreted }
    }

    /// The number of states.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.system.field.dimension()
    }

    /// Both back ends.
    #[must_use]
    pub fn back_ends(&self) -> [&dyn BackEnd; 2] {
        [self.generated.as_ref(), &self.interpreted]
    }
}

/// Accessors of a catalog type as [`Claims`].
macro_rules! claims {
    ($(impl$(<$scalar:ident>)? $type:ty: $n:literal $($integrals:ident)? { $($name:literal $bracket:ident),* })*) => { $(
        impl Claims<$n> for $type {
            $(fn integral_values(&self, x: &SVector<Q, $n>, eps: Q) -> Vector {
                self.$integrals(x, eps).iter().cloned().collect()
            })?
            fn density_value(&self, x: &SVector<Q, $n>, eps: Q) -> Option<Q> {
                Some(self.density(x, eps))
            }
            fn bracket_value(&self, name: &str, _x: &SVector<Q, $n>, _eps: Q) -> Option<SMatrix<Q, $n, $n>> {
                match name {
                    $($name => Some(self.$bracket(_x, _eps)),)*
                    _ => None,
                }
            }
        }
    )* };
}

claims! {
    impl EulerTop<Q>: 3 integrals { "P" bracket_P, "Q" bracket_Q }
    impl LotkaVolterra: 2 { "P" bracket_P }
    impl E1: 3 integrals { "P" bracket_P, "Q" bracket_Q }
    impl E2: 3 integrals { "P" bracket_P, "Q" bracket_Q }
    impl E3: 3 integrals { "P" bracket_P, "Q" bracket_Q }
    impl E4: 3 integrals { "P" bracket_P, "Q" bracket_Q }
    impl E5: 3 integrals { "P" bracket_P, "Q" bracket_Q }
    impl E6: 3 integrals { "P" bracket_P, "Q" bracket_Q }
    impl E7<Q>: 3 {}
    impl E8: 3 {}
    impl E9<Q>: 3 {}
    impl Weierstrass<Q>: 2 integrals {}
    impl VolterraLattice: 3 integrals {}
    impl VolterraFour: 4 integrals {}
    impl LagrangeTop<Q>: 6 integrals {}
    impl HenonHeiles<Q>: 4 integrals {}
}

// What these two claim is claimed `when`, or nothing.
impl Claims<3> for ZhukovskyVolterra<Q> {}
impl Claims<3> for Lorenz<Q> {}

fn read(text: &str) -> System {
    let reading = kahan_algebra::read(&lex(text).tokens);
    assert!(reading.diagnostics.is_empty(), "{text}\n{:?}", reading.diagnostics);
    reading.system
}

static CATALOG: LazyLock<Vec<System>> =
    LazyLock::new(|| SYSTEMS.iter().map(|entry| read(entry.text())).collect());

static OTHERS: LazyLock<Vec<System>> =
    LazyLock::new(|| FURTHER.iter().map(|entry| read(entry.text())).collect());

static RANDOM: LazyLock<Vec<System>> = LazyLock::new(|| {
    random_fields::every_field()
        .iter()
        .map(|field| crate::expression::read_unproved(&field.block()))
        .collect()
});

/// A system of the catalog by its command name, at these parameters.
///
/// # Panics
/// If there is no such system, or it has another number of parameters.
#[must_use]
pub fn catalog(command: &str, parameters: &[Q]) -> Subject {
    let place = SYSTEMS.iter().position(|entry| entry.command == command);
    let system = &CATALOG[place.unwrap_or_else(|| panic!("no system {command}"))];
    let p = |k: usize| parameters[k].clone();
    let generated: Box<dyn BackEnd> = match command {
        "euler" => Box::new(Generated::new(command, EulerTop { a1: p(0), a2: p(1), a3: p(2) })),
        "lv" => Box::new(Generated::new(command, LotkaVolterra)),
        "e1" => Box::new(Generated::new(command, E1)),
        "e2" => Box::new(Generated::new(command, E2)),
        "e3" => Box::new(Generated::new(command, E3)),
        "e4" => Box::new(Generated::new(command, E4)),
        "e5" => Box::new(Generated::new(command, E5)),
        "e6" => Box::new(Generated::new(command, E6)),
        "e7" => Box::new(Generated::new(command, E7 { xi: p(0) })),
        "e8" => Box::new(Generated::new(command, E8)),
        "e9" => Box::new(Generated::new(command, E9 { xi: p(0) })),
        other => panic!("the system {other} has no line here"),
    };
    Subject::new(system, parameters.to_vec(), generated)
}

/// The whole catalog, at the parameters of [`float_maps`].
#[must_use]
pub fn whole_catalog() -> Vec<Subject> {
    let parameters = |command: &str| match command {
        "euler" => float_maps::EULER_PARAMETERS.map(|(p, d)| q(p, d)).to_vec(),
        "e7" | "e9" => vec![q(float_maps::XI.0, float_maps::XI.1)],
        _ => Vec::new(),
    };
    SYSTEMS.iter().map(|entry| catalog(entry.command, &parameters(entry.command))).collect()
}

/// The catalog's further systems, at the parameters of [`float_maps::further`].
///
/// # Panics
/// If the registry has one that has no line here.
#[must_use]
pub fn further() -> Vec<Subject> {
    let subject = |system: &'static System| {
        let parameters = float_maps::parameters(system.name());
        let p: Vector = parameters.iter().map(|&(p, d)| q(p, d)).collect();
        let v = |k: usize| p[k].clone();
        let name = system.name();
        let generated: Box<dyn BackEnd> = match name {
            "Weierstrass" => Box::new(Generated::new(name, Weierstrass { a: v(0) })),
            "VolterraLattice" => Box::new(Generated::new(name, VolterraLattice)),
            "VolterraFour" => Box::new(Generated::new(name, VolterraFour)),
            "LagrangeTop" => Box::new(Generated::new(name, LagrangeTop { al: v(0), g: v(1) })),
            "HenonHeiles" => Box::new(Generated::new(name, HenonHeiles { a: v(0), b: v(1), c: v(2) })),
            "ZhukovskyVolterra" => {
                let [a1, a2, a3, b1, b2, b3] = [0, 1, 2, 3, 4, 5].map(v);
                Box::new(Generated::new(name, ZhukovskyVolterra { a1, a2, a3, b1, b2, b3 }))
            }
            "Lorenz" => Box::new(Generated::new(name, Lorenz { s: v(0), r: v(1), b: v(2) })),
            other => panic!("the system {other} has no line here"),
        };
        Subject::new(system, p, generated)
    };
    OTHERS.iter().map(subject).collect()
}

macro_rules! generated_random_fields {
    ($($name:ident: $n:literal { $($parameter:ident = $p:literal / $d:literal),* }),* $(,)?) => {
        $(impl Claims<$n> for random_type!($name $($parameter)*) {})*

        fn generated_random_fields() -> Vec<Box<dyn BackEnd>> {
            vec![$(Box::new(Generated::new(
                stringify!($name),
                crate::random_systems::$name { $($parameter: Q::constant(&Constant::ratio($p, $d))),* },
            ))),*]
        }
    };
}

macro_rules! random_type {
    ($name:ident) => { crate::random_systems::$name };
    ($name:ident $($parameter:ident)+) => { crate::random_systems::$name<Q> };
}

crate::with_random_systems!(generated_random_fields);

/// The random fields, each at its parameters.
#[must_use]
pub fn random() -> Vec<Subject> {
    let fields = random_fields::every_field();
    let generated = generated_random_fields();
    assert_eq!(fields.len(), generated.len(), "the written file is of another set of fields");
    let subject = |((system, field), generated): ((&'static System, &random_fields::RandomField), _)| {
        Subject::new(system, field.parameter_values(), generated)
    };
    RANDOM.iter().zip(&fields).zip(generated).map(subject).collect()
}

/// Calls a law on every system, catalog and random, at seeded points that are not on det A = 0; the law gets the point, ε,
/// and the source of more numbers.
///
/// # Panics
/// If too few points are left. Whatever the law panics with stands below a line that names the point.
pub fn on_every_subject(seed: u64, law: impl Fn(&Subject, &[Q], &Q, &mut Rationals)) {
    const POINTS: usize = 3;
    for (index, subject) in whole_catalog().iter().chain(&random()).enumerate() {
        let mut rationals = Rationals::seeded(seed * 1000 + index as u64);
        let mut tested = 0;
        for _ in 0..4 * POINTS {
            let (x, eps) = (rationals.point(subject.dimension()), rationals.nonzero());
            if subject.interpreted.det_matrix(&x, &eps) == q(0, 1) {
                continue;
            }
            eprintln!("{}: seed {seed}, x = ({}), eps = {eps}", subject.name, shown(&x));
            law(subject, &x, &eps, &mut rationals);
            tested += 1;
            if tested == POINTS {
                break;
            }
        }
        assert_eq!(tested, POINTS, "{} has too few points off det A = 0", subject.name);
    }
}

/// [`on_every_subject`], once for each back end.
pub fn on_every_back_end(seed: u64, law: impl Fn(&dyn BackEnd, &[Q], &Q, &mut Rationals)) {
    on_every_subject(seed, |subject, x, eps, rationals| {
        for back_end in subject.back_ends() {
            eprintln!("  {}", back_end.label());
            law(back_end, x, eps, rationals);
        }
    });
}
