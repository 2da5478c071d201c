//! Gives each monomial a number, and stores products and derivatives of monomials.

use std::rc::Rc;

use rustc_hash::FxHashMap;

use crate::laurent::{Laurent, Monomial};
use crate::ring::Ring;

pub(crate) type MonomialId = u32;

#[derive(Clone, Debug)]
struct MonomialEntry {
    monomial: Monomial,
    /// The monomials that the normal form of `monomial` contains; `None` if it is already normal.
    rewritten: Option<Rc<[MonomialId]>>,
    derivative: Option<Rc<[MonomialId]>>,
}

#[derive(Debug)]
pub(crate) struct MonomialTable<'a> {
    ring: &'a Ring,
    entries: Vec<MonomialEntry>,
    ids: FxHashMap<Monomial, MonomialId>,
    products: FxHashMap<(MonomialId, MonomialId), MonomialId>,
}

impl<'a> MonomialTable<'a> {
    pub(crate) const ONE: MonomialId = 0;

    pub(crate) fn new(ring: &'a Ring) -> Self {
        let mut table = MonomialTable {
            ring,
            entries: Vec::new(),
            ids: FxHashMap::default(),
            products: FxHashMap::default(),
        };
        table.id(&Monomial::one());
        table
    }

    /// Returns the number of a monomial. A new monomial gets the next number.
    pub(crate) fn id(&mut self, monomial: &Monomial) -> MonomialId {
        if let Some(&id) = self.ids.get(monomial) {
            return id;
        }
        let id = MonomialId::try_from(self.entries.len()).expect("a search meets fewer monomials");
        self.ids.insert(monomial.clone(), id);
        self.entries.push(MonomialEntry { monomial: monomial.clone(), rewritten: None, derivative: None });
        if !self.ring.is_normal(monomial) {
            self.entries[id as usize].rewritten = Some(self.support(&self.ring.normal_form(monomial)));
        }
        id
    }

    pub(crate) fn support(&mut self, polynomial: &Laurent) -> Rc<[MonomialId]> {
        polynomial.terms().map(|(monomial, _)| self.id(monomial)).collect()
    }

    pub(crate) fn monomial(&self, id: MonomialId) -> &Monomial {
        &self.entries[id as usize].monomial
    }

    pub(crate) fn rewritten(&self, id: MonomialId) -> Option<&Rc<[MonomialId]>> {
        self.entries[id as usize].rewritten.as_ref()
    }

    pub(crate) fn product(&mut self, left: MonomialId, right: MonomialId) -> MonomialId {
        let key = (left.min(right), left.max(right));
        if let Some(&known) = self.products.get(&key) {
            return known;
        }
        let product = self.monomial(left).times(self.monomial(right));
        let id = self.id(&product);
        self.products.insert(key, id);
        id
    }

    pub(crate) fn derivative(&mut self, id: MonomialId) -> Rc<[MonomialId]> {
        if let Some(known) = &self.entries[id as usize].derivative {
            return Rc::clone(known);
        }
        let derivative = self.ring.derivative_of(&self.entries[id as usize].monomial);
        let support = self.support(&derivative);
        self.entries[id as usize].derivative = Some(Rc::clone(&support));
        support
    }
}
