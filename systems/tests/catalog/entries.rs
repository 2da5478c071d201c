//! Tests that every block of the catalog is valid and proved, and that every claim has a source.

use kahan_algebra::lexer::lex;
use kahan_algebra::read;
use kahan_algebra::render::report;
use kahan_algebra::system::System;
use kahan_systems::entry::{Entry, block_range};
use kahan_systems::registry::{all, find};

fn reading(entry: &Entry) -> System {
    let text = entry.text();
    let lexed = lex(text);
    let reading = read(&lexed.tokens);
    let reports: Vec<String> = reading
        .diagnostics()
        .iter()
        .map(|diagnostic| report(diagnostic, text, &lexed.ranges, entry.command))
        .collect();
    assert!(reports.is_empty(), "{}", reports.join("\n"));
    reading.system().expect("a system")
}

#[test]
fn every_claim_of_every_block_is_proved() {
    for entry in all() {
        let reading = reading(entry);
        assert_eq!(reading.name(), entry.type_name);
        // Only the Lorenz system has no claims.
        assert_eq!(reading.claims.is_empty(), entry.command == "lorenz", "{}", entry.command);
    }
}

#[test]
fn every_claim_has_a_source_and_every_source_a_claim() {
    for entry in all() {
        let claims: Vec<String> = reading(entry).claims.iter().map(|claim| claim.name.text.clone()).collect();
        for claim in &claims {
            assert!(
                entry.source(claim).is_some_and(|source| !source.is_empty()),
                "{}.{claim} has no source",
                entry.command
            );
        }
        for (name, _) in entry.sources {
            assert!(claims.iter().any(|claim| claim == name), "{} has no claim {name}", entry.command);
        }
        assert_eq!(claims.len(), entry.sources.len(), "{}", entry.command);
    }
}

#[test]
fn the_integrable_systems_claim_two_integrals_a_density_and_two_brackets() {
    for name in ["euler", "e1", "e2", "e3", "e4", "e5", "e6"] {
        let entry = find(name).expect("a system of the catalog");
        let names: Vec<String> = reading(entry).claims.iter().map(|claim| claim.name.text.clone()).collect();
        assert_eq!(names, ["H", "K", "rho", "P", "Q"], "{name}");
    }
}

#[test]
fn a_system_is_found_by_command_and_by_type_in_any_case() {
    for entry in all() {
        for name in [entry.command.to_owned(), entry.type_name.to_owned(), entry.command.to_uppercase()] {
            assert_eq!(find(&name).map(|found| found.command), Some(entry.command));
        }
    }
    assert!(find("e10").is_none() && find("").is_none());
}

#[test]
fn a_block_ends_at_its_own_brace() {
    let file = "//! kahan! { not this }\nkahan! {\n /* } */ bracket P { {x,y} = x; }\n}\nfn f() {}\n";
    let range = block_range(file).expect("a block");
    assert_eq!(&file[range], "\n /* } */ bracket P { {x,y} = x; }\n");
    assert_eq!(block_range("kahan! { xdot = 1;"), None);
    assert_eq!(block_range("xdot = 1;"), None);
}
