//! The catalog of `kahan-systems` as one of studies.

use kahan_systems::{lattices, registry, volterra};

use crate::subject::{Catalog, Named, Subject};

/// The systems and families of `kahan-systems`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Systems;

impl Systems {
    /// The systems whose steps at the extremes are judged where no other is named: the paper's, and
    /// the lattice of three sites, whose det A cancels in long steps.
    pub fn at_the_extremes() -> impl Iterator<Item = Subject> {
        let entries = registry::SYSTEMS.iter().chain([&volterra::ENTRY]);
        entries.map(|entry| Subject::named(entry.command))
    }
}

impl Catalog for Systems {
    fn names(&self) -> Vec<[&'static str; 2]> {
        let systems = registry::all().map(|entry| [entry.command, entry.type_name]);
        systems.chain(lattices::ALL.map(|family| [family.command; 2])).collect()
    }

    fn find(&self, name: &str) -> Option<Named> {
        let system = registry::find(name).map(|entry| Named {
            name: entry.command,
            type_name: Some(entry.type_name),
            title: entry.title,
            text: entry.text(),
            sources: entry.sources,
        });
        system.or_else(|| {
            let family = lattices::find(name)?;
            let body = kahan_systems::entry::block_range(family.text)?;
            Some(Named {
                name: family.command,
                type_name: None,
                title: family.title,
                text: &family.text[body],
                sources: &[],
            })
        })
    }
}
