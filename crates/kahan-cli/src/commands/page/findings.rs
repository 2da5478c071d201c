//! What `kahan discover` found, for a page, and the field that goes on with it.

use kahan_algebra::rational::Rational;
use kahan_algebra::render::macro_block;
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::System;
use kahan_discover::hilbert::default_degree;
use kahan_study::{Answer, Discover, Discovered, Question, Systems};
use maud::Markup;

use super::figures::{Asked, Field, Subject};

/// The share of the time that the search has.
const SHARE: f64 = 0.35;

/// What the search for what the map preserves found.
pub(super) struct Search(Asked);

impl Search {
    pub(super) fn of(subject: &Subject<'_>, dimension: usize) -> Self {
        // With a degree the search ends where that is looked at, and every page says the same.
        let asked = Discover {
            degree: Some(default_degree(dimension)),
            seconds: subject.share(SHARE),
            ..Discover::default()
        };
        Search(Asked::of(subject.generic, Question::Discover(asked)))
    }

    /// What the map preserves, found from the equations alone.
    pub(super) fn chapter(&self) -> Markup {
        self.0.html()
    }

    fn found(&self) -> Option<&Discovered> {
        match &self.0.answer {
            Ok(Answer::Discover(found)) => Some(found),
            _ => None,
        }
    }

    /// The field with the integrals that were found, at these values of its parameters; `None` where there are none, or too long ones for a line that one reads.
    pub(super) fn with_integrals(&self, values: &[(String, Rational)]) -> Option<Field> {
        /// Longer lines are no reading.
        const LONGEST: usize = 800;

        let claimed = &self.found()?.readable().ok()?;
        let claims = claimed.claims.iter().filter(|claim| claim.kind == ClaimKind::Integral);
        let claimed = System { claims: claims.cloned().collect(), ..claimed.clone() };
        let names = claimed.field.symbols.parameters.iter().enumerate();
        let values = names.filter_map(|(k, name)| {
            let (_, value) = values.iter().find(|(known, _)| known == name)?;
            Some((k, value.clone()))
        });
        let at_values = claimed.specialise(&values.collect::<Vec<_>>())?;
        let block = macro_block(&at_values);
        let body = block.strip_prefix("kahan! {").and_then(|block| block.strip_suffix('}'))?;
        let words: Vec<&str> = body.split_whitespace().collect();
        let text = words.join(" ");
        let has_integrals = at_values.accessors(ClaimKind::Integral).next().is_some();
        if !has_integrals || text.len() > LONGEST {
            return None;
        }
        let study = kahan_study::Subject::text(&text).study(&Systems).ok()?;
        Some(Field { words: vec!["--field".to_owned(), text], study })
    }
}
