//! The atlas: well formed, self-contained, complete, computed, and written whole or not at all.
//!
//! The page is made here from short orbits and from outcomes that are given, so that it takes seconds without optimisation.

use std::collections::BTreeSet;
use std::time::Duration;

use kahan_systems::atlas::{Checked, Found, Making, Orbits, page};
use kahan_systems::paper::figures::{Figure, Measurement};
use kahan_systems::paper::{Claim, Established, Outcome, Paper};
use quick_xml::Reader;
use quick_xml::events::Event;

/// The first iterates of every orbit.
fn short_orbits() -> Vec<(&'static str, Measurement)> {
    let short = |figure: &'static Figure| {
        let steps = if matches!(figure.system, "lv" | "e9") { 5 } else { 12 };
        let Figure { name, system, parameters, eps, start, caption, .. } = figure;
        Figure { name, system, parameters, eps: *eps, start, steps, caption }
    };
    Figure::all().map(|figure| (figure.name, short(figure).measure())).collect()
}

fn making() -> Making {
    Making { date: "2026-01-31".to_owned(), seconds: 1.25 }
}

/// The page with these outcomes and short orbits.
fn page_with(paper: &Paper, outcome: impl Fn(&Claim) -> Outcome) -> String {
    let measured = short_orbits();
    let orbits: Orbits<'_> = measured.iter().map(|(name, measurement)| (*name, measurement)).collect();
    let established = |claim: &Claim| Established {
        outcome: outcome(claim),
        detail: "as < given".to_owned(),
        elapsed: Duration::ZERO,
    };
    let claims = paper.claims().iter().map(|claim| Checked { claim, established: established(claim) });
    page(&Found { paper, claims: claims.collect(), orbits }, &making())
}

/// Every claim taken for proved, misprints for corrected.
fn good(claim: &Claim) -> Outcome {
    if claim.misprint().is_some() { Outcome::Misprint } else { Outcome::Proved }
}

/// The attributes with this name, wherever they stand.
fn attributes<'a>(page: &'a str, name: &str) -> Vec<&'a str> {
    let opening = format!(" {name}=\"");
    page.split(&opening).skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

#[test]
fn the_page_is_well_formed_and_its_links_lead_somewhere() {
    let page = page_with(&Paper::new(), good);
    // The only elements without an end are those of the head; XML wants one.
    let xml: String = page
        .split_inclusive('>')
        .map(|piece| if piece.contains("<meta") { piece.replace('>', "/>") } else { piece.to_owned() })
        .collect();
    let mut reader = Reader::from_str(&xml);
    reader.config_mut().check_end_names = true;
    let mut depth = 0_i32;
    let mut elements = 0;
    loop {
        match reader.read_event() {
            Ok(Event::Eof) => break,
            Ok(Event::Start(start)) => {
                depth += 1;
                elements += 1;
                for attribute in start.attributes() {
                    attribute.unwrap_or_else(|wrong| panic!("{wrong} in {start:?}"));
                }
            }
            Ok(Event::End(_)) => depth -= 1,
            Ok(_) => {}
            Err(wrong) => {
                let at = usize::try_from(reader.error_position()).unwrap_or(0);
                panic!("{wrong} before {}", &xml[at..].chars().take(200).collect::<String>());
            }
        }
    }
    assert_eq!(depth, 0);
    assert!(elements > 10_000, "{elements} elements");

    let ids = attributes(&page, "id");
    let unique: BTreeSet<&str> = ids.iter().copied().collect();
    assert_eq!(unique.len(), ids.len(), "an anchor stands twice");
    for link in attributes(&page, "href") {
        let anchor = link.strip_prefix('#').unwrap_or_else(|| panic!("{link} leads away from the page"));
        assert!(unique.contains(anchor), "{link} leads nowhere");
    }
}

#[test]
fn the_page_needs_nothing_but_itself() {
    let page = page_with(&Paper::new(), good);
    for foreign in
        ["http:", "https:", "//www", "<script", "<link", "<img", "<iframe", " src=", "url(", "@import"]
    {
        assert!(
            !page.contains(foreign),
            "{foreign} in {:?}",
            page.split(foreign).nth(1).map(|s| &s[..40.min(s.len())])
        );
    }
    assert!(page.contains("default-src 'none'"), "the browser is not told to fetch nothing");
    assert!(page.len() < 3_000_000, "{} bytes", page.len());
}

#[test]
fn every_formula_is_set() {
    let page = page_with(&Paper::new(), good);
    assert!(page.matches("<math").count() > 1500);
    for mark in ["class=\"unset\"", "merror", "not checked", "not measured"] {
        let before = page.split(mark).next().unwrap_or_default();
        assert!(!page.contains(mark), "{mark} after {}", &before[before.len().saturating_sub(300)..]);
    }
}

#[test]
fn every_part_stands_on_the_page_and_in_order() {
    let paper = Paper::new();
    let page = page_with(&paper, good);
    let sections = ["systems", "tables", "solutions", "figures", "verification", "errata", "open"];
    let places: Vec<Option<usize>> =
        sections.iter().map(|id| page.find(&format!("<section id=\"{id}\""))).collect();
    assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{places:?}");
    for table in ["table1", "table2", "table3", "table4", "table5", "theorem3"] {
        assert!(page.contains(&format!("<table class=\"formulas\" id=\"{table}\"")), "{table}");
    }
    for (figure, drawings) in [
        ("overview", 1),
        ("lv", 1),
        ("de3", 2),
        ("de4", 2),
        ("de7", 2),
        ("de9", 1),
        ("curve", 4),
        ("portrait", 2),
    ] {
        let (_, after) =
            page.split_once(&format!("id=\"figure-{figure}\"")).unwrap_or_else(|| panic!("{figure}"));
        let drawn = after.split("</figure>").next().unwrap_or_default();
        assert_eq!(drawn.matches("<svg").count(), drawings, "{figure}");
        assert_eq!(drawn.matches("role=\"img\" aria-label=").count(), drawings, "{figure}");
        assert!(drawn.contains("class=\"data\"") && drawn.contains("<path"), "{figure}");
    }
    for claim in paper.claims() {
        assert!(page.contains(&format!("<tr id=\"claim-{}\"", claim.id)), "{} has no row", claim.id);
    }
    for erratum in (1..=10).map(|i| format!("A{i}")).chain((1..=12).map(|i| format!("B{i}"))) {
        assert!(page.contains(&format!("<span class=\"number\">{erratum}</span>")), "{erratum}");
    }
    let row = page.split_once("id=\"table4\"").and_then(|(_, table)| table.split_once("dE3</th>"));
    let row = row.and_then(|(_, row)| row.split("</tr>").next()).unwrap_or_default();
    assert!(row.contains("corrected"), "row 3 of Table 4 is not marked: {row}");
}

#[test]
fn what_is_shown_is_what_was_measured() {
    let measured = short_orbits();
    let heights = |name: &str, variable: &str| {
        let (_, orbit) = measured.iter().find(|(known, _)| *known == name).expect(name);
        orbit.log_heights(variable).expect(variable)
    };
    let page = page_with(&Paper::new(), good);
    let lv = heights("LV", "x");
    let shown = format!("<sub>{}</sub>) = {:.2}", lv.len() - 1, lv[lv.len() - 1]);
    assert!(page.contains(&shown), "{shown}");
    let de3 = heights("DE3", "x");
    let shown = format!("<sub>{}</sub>) = {:.1}", de3.len() - 1, de3[de3.len() - 1]);
    assert!(page.contains(&shown), "{shown}");
    assert!(page.contains("2026-01-31") && page.contains("1.2 seconds"));
}

#[test]
fn a_claim_that_failed_is_told_at_the_top_and_shown_open() {
    let paper = Paper::new();
    let bad = |claim: &Claim| if claim.id == "table2.e1.limit" { Outcome::Failed } else { good(claim) };
    let page = page_with(&paper, bad);
    assert!(page.contains("<b>1 of the claims failed.</b>"));
    let (before, row) = page.split_once("<tr id=\"claim-table2.e1.limit\"").expect("its row");
    assert!(
        row.split("</tr>").next().is_some_and(|row| row.contains("FAILED") && row.contains("as &lt; given"))
    );
    let group = before.rsplit("<details").next().unwrap_or_default();
    assert!(group.contains(" open>"), "its group is closed: {}", &group[..60.min(group.len())]);
    assert!(page_with(&paper, good).contains("no claim failed."));
}
