//! The contents of a catalog.

use kahan_runtime::FieldText;
use serde::Serialize;

use crate::error::StudyError;
use crate::subject::Catalog;

/// The systems and the families of a catalog.
#[derive(Clone, Debug, Serialize)]
pub struct Listed {
    /// The systems: catalog entries whose equations are written out.
    pub systems: Vec<SystemListed>,
    /// The families: catalog entries for any number of sites.
    pub families: Vec<FamilyListed>,
}

/// A system of a catalog.
#[derive(Clone, Debug, Serialize)]
pub struct SystemListed {
    /// The name of the system in the catalog.
    pub name: &'static str,
    /// The name of its type in Rust.
    #[serde(rename = "type")]
    pub type_name: &'static str,
    /// A description of one line.
    pub title: &'static str,
    /// The state variables.
    pub variables: Vec<String>,
    /// The parameters.
    pub parameters: Vec<String>,
    /// The names of the system's claims.
    pub claims: Vec<String>,
}

/// A family of a catalog.
#[derive(Clone, Debug, Serialize)]
pub struct FamilyListed {
    /// The name of the family in the catalog.
    pub name: &'static str,
    /// The name of its type in Rust.
    #[serde(rename = "type")]
    pub type_name: String,
    /// A description of one line.
    pub title: &'static str,
    /// The variables of each site, without an index.
    pub arrays: Vec<String>,
    /// The parameters. A parameter of each site is written `r[i]`.
    pub parameters: Vec<String>,
    /// The names of the family's claims.
    pub claims: Vec<String>,
}

/// Lists a catalog, which takes milliseconds for each entry. Fails if an entry's text has mistakes.
pub fn list(catalog: &dyn Catalog) -> Result<Listed, StudyError> {
    let mut listed = Listed { systems: Vec::new(), families: Vec::new() };
    for named in catalog.names().into_iter().filter_map(|[name, _]| catalog.find(name)) {
        let text = FieldText::new(named.text.to_owned(), named.name.to_owned());
        let (name, title) = (named.name, named.title);
        if let Some(type_name) = named.type_name {
            let system = text.unproved_system().map_err(StudyError::Field)?;
            listed.systems.push(SystemListed {
                name,
                type_name,
                title,
                claims: system.claims.iter().map(|claim| claim.name.text.clone()).collect(),
                variables: system.field.symbols.states.clone(),
                parameters: system.field.symbols.parameters.clone(),
            });
            continue;
        }
        let family = text.family().map_err(StudyError::Field)?.ok_or(StudyError::NoFamily)?;
        let of_sites = family.site_parameters.iter().map(|name| format!("{name}[i]"));
        let sums = family.integrals.iter().chain(&family.hamiltonian);
        listed.families.push(FamilyListed {
            name,
            type_name: family.name().to_owned(),
            title,
            arrays: family.arrays.clone(),
            parameters: family.parameters.iter().cloned().chain(of_sites).collect(),
            claims: sums.map(|sum| sum.name.text.clone()).collect(),
        });
    }
    Ok(listed)
}
