//! What was found at the extremes, as a table or as an object.

use std::collections::BTreeMap;

use kahan_study::extremes::{Broken, Cell, Place, Subject, Tally};
use kahan_study::random_fields::{RandomField, odd};
use serde_json::{Value, json};

use crate::printing::layout::{labelled, table};

/// The columns of the labels below the table.
const LABELS: usize = 15;

/// What was tried, and what came of it.
pub(super) struct Report<'a> {
    pub(super) subjects: &'a [Subject],
    pub(super) fields: &'a [RandomField],
    /// How many fields of odd tempers there are.
    pub(super) odd_fields: usize,
    pub(super) tally: &'a Tally,
    pub(super) trials: u64,
    pub(super) seed: u64,
    pub(super) seconds: f64,
}

impl Report<'_> {
    pub(super) fn object(&self) -> Value {
        let cells = self.tally.cells.iter().map(|((regime, tier, scalar), cell)| {
            json!({
                "regime": regime.name(),
                "tier": tier,
                "scalar": scalar,
                "trials": cell.trials,
                // JSON has no infinity.
                "max_error_u": cell.max_error_u.map(|error| error.min(f64::MAX)),
                "flagged": cell.flagged,
                "unjustified_flags": cell.unjustified,
                "silently_wrong": cell.silently_wrong,
            })
        });
        json!({
            "system": if let [subject] = self.subjects { subject.name() } else { "catalog" },
            "systems": self.subjects.iter().map(Subject::name).collect::<Value>(),
            "random_fields": self.fields.iter().map(|field| json!([field.name, field.equations()])).collect::<Value>(),
            "odd_fields": self.odd_fields,
            "trials": self.trials,
            "seed": self.seed,
            "seconds": self.seconds,
            "cells": cells.collect::<Value>(),
            "broken": self.broken().into_iter().map(|(name, text, broken)| json!({
                "name": name,
                "text": text,
                "silently_wrong": broken.silently_wrong,
                "unjustified_flags": broken.unjustified,
                "first": broken.first.text,
            })).collect::<Value>(),
            "failures": self.tally.failures.iter().map(|failure| failure.text.as_str()).collect::<Value>(),
        })
    }

    pub(super) fn text(&self) -> String {
        const HEADER: [&str; 8] = [
            "regime",
            "tier",
            "scalar",
            "trials",
            "largest error",
            "flagged",
            "without right",
            "silently wrong",
        ];
        let mut rows = vec![HEADER.map(str::to_owned).to_vec()];
        rows.extend(self.tally.cells.iter().map(row));
        let mut lines = table(&rows, 3);
        lines.push(String::new());
        let names = |has: fn(&Subject) -> bool| {
            let names: Vec<&str> = self.subjects.iter().filter(|s| has(s)).map(Subject::name).collect();
            names.join(", ")
        };
        lines.extend(labelled("systems", &names(|_| true), LABELS));
        let removable = names(Subject::has_removable_poles);
        let removable =
            if removable.is_empty() { "none; their quarter went to the poles" } else { &removable };
        lines.extend(labelled("removable poles", removable, LABELS));
        lines.extend(self.fields.iter().map(|field| format!("{}: {}", field.name, field.equations())));
        if self.odd_fields > 0 {
            lines.push(format!(
                "besides {} random fields of odd tempers, all of them judged",
                self.odd_fields
            ));
        }
        for (name, text, broken) in self.broken() {
            let (wrong, flags) = (broken.silently_wrong, broken.unjustified);
            lines.push(format!("{name}, {wrong} silently wrong, {flags} flagged without right: {text}"));
            lines.push(format!("  {}", broken.first.text));
        }
        lines.push(format!("seed {}, {:.1} seconds", self.seed, self.seconds));
        lines.join("\n") + "\n"
    }

    /// The systems that broke the promise, with their equations where they were drawn.
    fn broken(&self) -> Vec<(&str, String, &Broken)> {
        let odd: BTreeMap<String, String> = (0..self.odd_fields)
            .map(|number| odd(self.seed, number))
            .map(|field| (field.name, field.equations))
            .collect();
        let text = |name: &str| {
            let ordinary = || self.fields.iter().find(|field| field.name == name).map(RandomField::equations);
            odd.get(name).cloned().or_else(ordinary).unwrap_or_default()
        };
        self.tally.broken.iter().map(|(name, broken)| (name.as_str(), text(name), broken)).collect()
    }

    /// What the stable tier did against its promise.
    pub(super) fn complaint(&self) -> Option<String> {
        let count = |of: fn(&Cell) -> u64| {
            let stable = self.tally.cells.iter().filter(|((_, tier, _), _)| *tier == "stable");
            stable.map(|(_, cell)| of(cell)).sum::<u64>()
        };
        let (wrong, flags) = (count(|cell| cell.silently_wrong), count(|cell| cell.unjustified));
        if wrong + flags == 0 {
            return None;
        }
        let examples: Vec<&str> = self.tally.failures.iter().map(|failure| failure.text.as_str()).collect();
        Some(format!(
            "the stable tier breaks its promise: {wrong} silently wrong, {flags} flagged without right. The first of each: {}",
            examples.join("; ")
        ))
    }
}

fn row((place, cell): (&Place, &Cell)) -> Vec<String> {
    let (regime, tier, scalar) = place;
    let error = match cell.max_error_u {
        None => "-".to_owned(),
        Some(error) if error < 1000.0 => format!("{error:.2} u"),
        Some(error) => format!("{error:.1e} u"),
    };
    let rate = 100.0 * cell.flagged as f64 / cell.trials as f64;
    let without_right = if *tier == "stable" { cell.unjustified.to_string() } else { "-".to_owned() };
    vec![
        regime.name().to_owned(),
        (*tier).to_owned(),
        (*scalar).to_owned(),
        cell.trials.to_string(),
        error,
        format!("{rate:.2} %"),
        without_right,
        silently_wrong(cell),
    ]
}

/// The count; none among n trials bounds the rate by 3/n with a confidence of 95 %, as (1 − 3/n)ⁿ
/// is about 1/20.
fn silently_wrong(cell: &Cell) -> String {
    match cell.silently_wrong {
        0 => format!("0, < 3/{} at 95 %", cell.trials),
        wrong => format!("{wrong}, {:.2} %", 100.0 * wrong as f64 / cell.trials as f64),
    }
}
