//! Implements [`Catalog`] for the systems and families of `kahan-systems`.

use kahan_systems::{lattices, registry};

use crate::subject::{Catalog, Named};

/// The systems and families of `kahan-systems`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Systems;

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
