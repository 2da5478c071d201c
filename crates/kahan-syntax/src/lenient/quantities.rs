//! Reads values of parameters, initial values of states, and auxiliary quantities.

use std::collections::HashSet;
use std::ops::Range;

use crate::rational::Rational;
use crate::spelling::fresh;

use super::items::TextItem;
use super::left_side::LeftSide;
use super::xpp::Function;
use super::{PlacedToken, Reader, mistake};

const MAX_DEPTH: usize = 256;

impl Reader<'_> {
    /// Records the states, and chooses names for the derivatives that become new states.
    pub(super) fn name_derivatives(&mut self, items: &[TextItem]) {
        let equations = || items.iter().filter_map(|item| item.left.as_ref()).filter(|left| !left.is_value());
        for left in equations() {
            self.states.entry(left.of.name.clone()).or_default();
        }
        for LeftSide { of, .. } in equations() {
            if self.states.get(&of.name).is_some_and(|known| known.len() + 1 >= of.order) {
                continue;
            }
            let mut chain: Vec<String> = Vec::new();
            for order in 1..of.order {
                let [first, second, third] = if order == 1 { ["v", "u", "p"] } else { ["a", "b", "c"] };
                let is_taken = |name: &str| self.mentions(name) || self.is_state(name);
                let name = fresh(&[first, second, third, &format!("{first}_{}", of.name)], is_taken);
                self.states.insert(name.clone(), Vec::new());
                chain.push(name);
            }
            let (state, primes, first, new) = (&of.name, "'".repeat(of.order), &chain[0], chain.join("`, `"));
            self.has_derivatives = true;
            self.note(&format!(
                "`{state}{primes}` is read with `{state}dot = {first}`: `{new}` is a new state"
            ));
            self.states.insert(of.name.clone(), chain);
        }
    }

    /// Removes values and auxiliary quantities from the text. Returns for each item the tokens that
    /// replace it; `None` if the item stays.
    pub(super) fn read_quantities(&mut self, items: &[TextItem]) -> Vec<Option<Vec<PlacedToken>>> {
        let mut instead = vec![None; items.len()];
        let is_value = |item: &TextItem| item.left.as_ref().is_some_and(LeftSide::is_value);
        if !items.iter().any(is_value) {
            return instead;
        }
        let right = |item: &TextItem| {
            item.left.as_ref().map_or(item.tokens.start, |left| left.right)..item.tokens.end
        };
        let used = items.iter().flat_map(|item| self.names_in(right(item)));
        let used: HashSet<String> = used.map(str::to_owned).collect();
        let mut quantities: Vec<(usize, &str, Range<usize>)> = Vec::new();
        let mut known = HashSet::new();
        for (place, item) in items.iter().enumerate() {
            let Some(left) = item.left.as_ref().filter(|left| left.is_value()) else { continue };
            let (name, right) = (left.of.name.as_str(), right(item));
            if !left.arguments.is_empty() {
                instead[place] = known.insert(name.to_owned()).then(Vec::new);
                let function = Function { arguments: left.arguments.clone(), right };
                self.functions.entry(name.to_owned()).or_insert(function);
                continue;
            }
            let has_name = |state: &&String| state.to_lowercase() == name.to_lowercase();
            let other = if self.is_state(name) { None } else { self.states.keys().filter(has_name).min() };
            let is_lost = self.at(item.tokens.start) == "init" && other.is_some() && !used.contains(name);
            let is_start = left.is_first || self.is_state(name) || is_lost;
            let is_number = self.names_in(right.clone()).next().is_none();
            match (is_start, used.contains(name)) {
                (false, true) if !is_number => {
                    // If a name is repeated, its item stays in the text, and the parser reports it.
                    quantities.extend(known.insert(name.to_owned()).then_some((place, name, right)));
                    continue;
                }
                (false, false) if matches!(self.at(item.tokens.start), "aux" | "!") => {
                    self.note(&format!("`{name}` is not read: no equation needs it"));
                    instead[place] = Some(Vec::new());
                    continue;
                }
                (false, false) if !left.is_declared => continue,
                _ => {}
            }
            let target = match left.of.order {
                0 => Some(name).filter(|_| !is_start || self.is_state(name)),
                order => self.states.get(name).and_then(|own| own.get(order - 1)).map(String::as_str),
            };
            let number = Rational::parse(&right.map(|place| self.at(place)).collect::<String>());
            let shown = &self.text[self.bytes(item.tokens.start..left.right)];
            let number_wanted = || format!("`{shown}` gives a value, which is one number");
            let (before, behind) = shown.rsplit_once(name).unwrap_or(("", " ="));
            let (message, help) = match (target, other) {
                (Some(_), _) => (number_wanted(), format!("write `{shown} 1/2`, once, or leave it out")),
                (None, Some(other)) => (
                    format!("there is no `{name}`, but there is `{other}`: names differ by case"),
                    format!("write `{before}{other}{behind}`"),
                ),
                _ => {
                    let help = "no equation needs it: leave it out, or write the equation";
                    (number_wanted(), help.to_owned())
                }
            };
            let value = target.map(str::to_owned).filter(|target| known.insert(target.clone())).zip(number);
            let mistake = || mistake(&self.bytes(item.tokens.clone()), message, help);
            instead[place] = Some(Vec::from_iter(value.is_none().then(mistake)));
            let values = if is_start { &mut self.read.start } else { &mut self.read.parameters };
            values.extend(value.filter(|_| is_start || used.contains(name)));
        }
        let mut put_in = Vec::new();
        // Each round expands the quantities that refer only to expanded ones. The parser reports
        // cyclic references.
        for _ in 0..MAX_DEPTH {
            let names: HashSet<&str> = quantities.iter().map(|(_, name, _)| *name).collect();
            let waits = |right: &Range<usize>| self.used_names(right).iter().any(|name| names.contains(name));
            let (waiting, ready): (Vec<_>, Vec<_>) =
                quantities.into_iter().partition(|(_, _, right)| waits(right));
            quantities = waiting;
            for (place, name, right) in ready {
                let written = self.written(right, true);
                self.quantities.insert(name.to_owned(), written);
                put_in.push(format!("`{name}`"));
                instead[place] = Some(Vec::new());
            }
        }
        if !put_in.is_empty() {
            self.note(&format!(
                "no states, but formulas that are put in where they stand: {}",
                put_in.join(", ")
            ));
        }
        instead
    }
}
