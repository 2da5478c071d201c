//! Stores a monomial as a list of pairs (variable, exponent). Short lists need no allocation. In a
//! macro built without optimisation, allocation took a tenth of the time.

use super::Variable;

const INLINE_CAPACITY: usize = 4;

pub(super) type Power = (Variable, u32);

#[derive(Clone, Debug)]
pub(super) enum Powers {
    /// The length of the list, and an array that begins with the entries.
    Few(usize, [Power; INLINE_CAPACITY]),
    Many(Vec<Power>),
}

impl Powers {
    pub(super) const NONE: Self = Powers::Few(0, [(Variable(0), 0); INLINE_CAPACITY]);

    pub(super) fn as_slice(&self) -> &[Power] {
        match self {
            Powers::Few(count, powers) => &powers[..*count],
            Powers::Many(powers) => powers,
        }
    }

    pub(super) fn as_mut_slice(&mut self) -> &mut [Power] {
        match self {
            Powers::Few(count, powers) => &mut powers[..*count],
            Powers::Many(powers) => powers,
        }
    }

    pub(super) fn push(&mut self, power: Power) {
        match self {
            Powers::Few(count, powers) if *count < INLINE_CAPACITY => {
                powers[*count] = power;
                *count += 1;
            }
            Powers::Few(_, powers) => {
                let mut many = Vec::with_capacity(2 * INLINE_CAPACITY);
                many.extend_from_slice(powers);
                many.push(power);
                *self = Powers::Many(many);
            }
            Powers::Many(powers) => powers.push(power),
        }
    }

    pub(super) fn insert(&mut self, place: usize, power: Power) {
        self.push(power);
        let powers = self.as_mut_slice();
        let mut last = powers.len() - 1;
        while last > place {
            powers[last] = powers[last - 1];
            last -= 1;
        }
        powers[place] = power;
    }

    pub(super) fn remove(&mut self, place: usize) {
        let powers = self.as_mut_slice();
        let last = powers.len() - 1;
        let mut index = place;
        while index < last {
            powers[index] = powers[index + 1];
            index += 1;
        }
        match self {
            Powers::Few(count, _) => *count = last,
            Powers::Many(powers) => powers.truncate(last),
        }
    }
}
