//! Refutes misprinted formulas at a given point or by a measured orbit. A misprinted `!=` is
//! refuted if both sides are one function.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use kahan_algebra::rational::Rational;

use super::claim::{Claim, Misprint, Outcome};
use super::formula::{Definition, Item, Relation, parse};
use super::identity::Evidence;
use super::registry::{Paper, outcome};

impl Claim {
    /// Returns a misprinted item and its correction; items are relations or definitions.
    #[must_use]
    pub fn correction(&self) -> Option<(String, String)> {
        let (printed, right) = (items(self.printed()?), items(&self.statement));
        let only_printed = printed.iter().filter(|item| !right.contains(item));
        let only_right: Vec<&String> = right.iter().filter(|item| !printed.contains(item)).collect();
        let pairs = only_printed.flat_map(|item| only_right.iter().map(move |right| (item, *right)));
        let (printed, right) = pairs.min_by_key(|(printed, right)| Reverse(common_words(printed, right)))?;
        Some((printed.clone(), right.clone()))
    }
}

fn items(statement: &str) -> Vec<String> {
    statement.split(';').map(|item| item.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

/// Counts the common words at the beginnings and at the ends of two items.
fn common_words(a: &str, b: &str) -> usize {
    let pairs = a.split(' ').zip(b.split(' '));
    let reversed = a.rsplit(' ').zip(b.rsplit(' '));
    pairs.take_while(|(a, b)| a == b).count() + reversed.take_while(|(a, b)| a == b).count()
}

impl Paper {
    /// Refutes a misprint at its counterexample, whose stated values are checked, too.
    pub(super) fn misprint(
        &self,
        claim: &Claim,
        misprint: &Misprint,
        corrected: &Evidence,
    ) -> (Outcome, String) {
        match self.refute(claim, misprint) {
            Ok(shown) => (
                Outcome::Misprint,
                format!("{shown}; the corrected form is {}", outcome(corrected).0.words()),
            ),
            Err(why) => (Outcome::Failed, format!("the printed form is not refuted: {why}")),
        }
    }

    fn refute(&self, claim: &Claim, misprint: &Misprint) -> Result<String, String> {
        let mut point: BTreeMap<String, Rational> = BTreeMap::new();
        let (mut others, mut witnesses) = (Vec::new(), Vec::new());
        for item in parse(&misprint.counterexample)?.items {
            match item {
                Item::Definition(definition) => match definition.body.as_number() {
                    Some(value) => {
                        point.insert(definition.name, value);
                    }
                    // Rational values go to `point`. Others, such as log 3, stay formulas.
                    None => others.push(definition),
                },
                witness @ Item::Relation { .. } => witnesses.push(witness),
            }
        }
        let (mut definitions, _) = self.definitions(claim, &claim.statement)?;
        definitions.retain(|name, _| !point.contains_key(name));
        definitions.extend(others.into_iter().map(|definition| (definition.name.clone(), definition)));
        for witness in &witnesses {
            let (left, right, equal) = self.at_point(claim, witness, &definitions, &point)?;
            if !equal {
                return Err(format!("at the counterexample a value is {left}, not {right}"));
            }
        }
        let mut shown: Vec<String> = point.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        for item in parse(&misprint.printed)?.items {
            match item {
                Item::Definition(definition) => {
                    definitions.insert(definition.name.clone(), definition);
                }
                relation @ Item::Relation { .. } => {
                    let (left, right, equal) = self.at_point(claim, &relation, &definitions, &point)?;
                    if equal {
                        return Err(format!("at the counterexample both sides are {left}"));
                    }
                    shown.push(format!("{left} on the left, {right} on the right"));
                }
            }
        }
        Ok(if point.is_empty() { shown.join(", ") } else { format!("at {}", shown.join(", ")) })
    }

    /// Evaluates both sides of a relation, and returns whether the relation holds at a point.
    fn at_point(
        &self,
        claim: &Claim,
        item: &Item,
        definitions: &BTreeMap<String, Definition>,
        point: &BTreeMap<String, Rational>,
    ) -> Result<(String, String, bool), String> {
        let Item::Relation { left, right, relation, digit } = item else {
            return Err("no relation".to_owned());
        };
        let [left, right] = self.sides(claim, left, right, definitions)?;
        let identity = self.identity(claim, [&left, &right], *relation, digit.as_ref())?;
        if *relation == Relation::Different {
            // `left != right` says that two functions differ. One point cannot refute this.
            let differ = identity.establish().is_ok();
            return Ok(("one function".to_owned(), "the same function".to_owned(), differ));
        }
        identity.at_point(point)
    }
}
