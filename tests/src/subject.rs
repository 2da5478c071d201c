//! The systems of the test suites, each as generated code and in the interpreter.

use std::sync::LazyLock;

use kahan_algebra::lexer::lex;
use kahan_algebra::system::System;
use kahan_systems::entry::Entry;
use kahan_systems::registry::{FURTHER, SYSTEMS, all};

use crate::back_end::{BackEnd, Generated, Interpreted, Read};
use crate::exact::{Q, Rationals, Vector, q, shown};
use crate::expression::read_unproved;
use crate::maps;
use crate::random_fields::{in_order, parameter_values};

/// A system with parameters, in both back ends.
#[allow(missing_debug_implementations)]
pub struct Subject {
    /// The system's name.
    pub name: &'static str,
    /// The system as read by the front end.
    pub system: &'static System,
    /// The parameters' values.
    pub parameters: Vector,
    /// The system's code written by the macro.
    pub generated: Box<dyn BackEnd>,
    /// The system in the run-time interpreter.
    pub interpreted: Interpreted,
}

impl Subject {
    fn new(read: &'static Read, parameters: Vector, generated: Generated) -> Self {
        let interpreted = Interpreted::new(read, &parameters);
        let (system, generated) = (&read.system, Box::new(generated));
        Self { name: system.name(), system, parameters, generated, interpreted }
    }

    /// Returns the number of states.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.interpreted.dimension()
    }

    /// Returns the two implementations of the system: the generated code and the interpreter.
    #[must_use]
    pub fn back_ends(&self) -> [&dyn BackEnd; 2] {
        [self.generated.as_ref(), &self.interpreted]
    }
}

fn read(text: &str) -> Read {
    let reading = kahan_algebra::read(&lex(text).tokens);
    assert!(reading.diagnostics().is_empty(), "{text}\n{:?}", reading.diagnostics());
    Read::new(reading.system().expect("a system"))
}

static CATALOG: LazyLock<Vec<Read>> = LazyLock::new(|| all().map(|entry| read(entry.text())).collect());

static RANDOM: LazyLock<Vec<Read>> =
    LazyLock::new(|| in_order().iter().map(|field| Read::new(read_unproved(&field.block()))).collect());

/// Returns a catalog system. Panics for an unknown system or a wrong number of parameters.
#[must_use]
pub fn catalog(command: &str, parameters: &[Q]) -> Subject {
    let place = all().position(|entry| entry.command == command);
    let place = place.unwrap_or_else(|| panic!("no system {command}"));
    let entry = all().nth(place).expect("the place is in the catalog");
    Subject::new(&CATALOG[place], parameters.to_vec(), Generated::of_catalog(entry, parameters))
}

fn at_its_parameters(entry: &Entry) -> Subject {
    catalog(entry.command, &maps::parameters::<Q>(entry))
}

/// Returns the paper's systems, at the parameters of their catalog entries.
#[must_use]
pub fn paper() -> Vec<Subject> {
    SYSTEMS.iter().map(at_its_parameters).collect()
}

/// Returns the catalog's further systems, at the parameters of their entries.
#[must_use]
pub fn further() -> Vec<Subject> {
    FURTHER.iter().map(at_its_parameters).collect()
}

/// Returns the random fields at their parameters, first those that are compiled over floats.
#[must_use]
pub fn random() -> Vec<Subject> {
    let (fields, maps) = (in_order(), maps::random());
    assert_eq!(fields.len(), maps.len(), "the written file is of another set of fields");
    let fields = RANDOM.iter().zip(&fields).zip(maps);
    let subjects = fields.map(|((read, field), map)| {
        Subject::new(read, parameter_values(field), Generated::new(read.system.name(), map))
    });
    subjects.collect()
}

/// Checks a law for one system, at seeded points where det A ≠ 0.
fn at_points(subject: &Subject, seed: u64, law: &impl Fn(&Subject, &[Q], &Q, &mut Rationals)) {
    const POINTS: usize = 3;
    let mut rationals = Rationals::seeded(seed);
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
            return;
        }
    }
    panic!("{} has too few points off det A = 0", subject.name);
}

/// Checks a law on every catalog system and random field, at seeded points with det A ≠ 0. Panics
/// if too few points remain.
pub fn on_every_subject(seed: u64, law: impl Fn(&Subject, &[Q], &Q, &mut Rationals)) {
    let subjects = [paper(), random(), further()].into_iter().flatten();
    for (index, subject) in (seed * 1000..).zip(subjects) {
        at_points(&subject, index, &law);
    }
}

/// Checks a law as [`on_every_subject`] does, once for each back end.
pub fn on_every_back_end(seed: u64, law: impl Fn(&dyn BackEnd, &[Q], &Q, &mut Rationals)) {
    on_every_subject(seed, |subject, x, eps, rationals| {
        for back_end in subject.back_ends() {
            eprintln!("  {}", back_end.label());
            law(back_end, x, eps, rationals);
        }
    });
}
