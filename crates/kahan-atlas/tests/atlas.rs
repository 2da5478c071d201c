//! Tests that the page is well formed, self-contained and complete, and shows measured numbers.

#[path = "../../kahan-cli/tests/command/painting.rs"]
mod painting;

use std::collections::BTreeSet;

use kahan_algebra::lexer::lex;
use kahan_algebra::plan::variables;
use kahan_algebra::syntax::{ClaimBody, ClaimKind};
use kahan_atlas::{AtlasContent, CheckedClaim, Orbits, PageCreation, page};
use kahan_paper::figures::{Figure, Measurement};
use kahan_paper::{Claim, Established, Outcome, Paper};
use kahan_systems::registry;
use quick_xml::Reader;
use quick_xml::events::Event;

fn short_orbits() -> Vec<(&'static str, Measurement)> {
    let short = |figure: &'static Figure| {
        let steps = if matches!(figure.system, "lv" | "e9") { 5 } else { 12 };
        let Figure { name, system, parameters, eps, start, caption, .. } = figure;
        Figure { name, system, parameters, eps: *eps, start, steps, caption }
    };
    Figure::all().map(|figure| (figure.name, short(figure).measure())).collect()
}

fn making() -> PageCreation {
    PageCreation { date: "2026-01-31".to_owned(), seconds: 1.25 }
}

/// Writes the page from given outcomes and short orbits.
fn page_with(paper: &Paper, outcome: impl Fn(&Claim) -> Outcome) -> String {
    let measured = short_orbits();
    let orbits: Orbits<'_> = measured.iter().map(|(name, measurement)| (*name, measurement)).collect();
    let established =
        |claim: &Claim| Established { outcome: outcome(claim), detail: "as < given".to_owned() };
    let claims = paper.claims().iter().map(|claim| CheckedClaim { claim, established: established(claim) });
    page(&AtlasContent { paper, claims: claims.collect(), orbits }, &making())
}

fn good(claim: &Claim) -> Outcome {
    if claim.printed().is_some() { Outcome::Misprint } else { Outcome::Proved }
}

fn attributes<'a>(page: &'a str, name: &str) -> Vec<&'a str> {
    let opening = format!(" {name}=\"");
    page.split(&opening).skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

#[test]
fn the_page_is_well_formed_and_its_links_lead_somewhere() {
    let page = page_with(&Paper::new(), good);
    // Closes each `<meta>`, because XML requires it and HTML does not.
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
        for drawing in painting::drawings(drawn) {
            assert!(painting::painted(drawing) > 15, "{figure}");
        }
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
    let bad =
        |claim: &Claim| if claim.id.to_string() == "table2.e1.limit" { Outcome::Failed } else { good(claim) };
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

fn sheet<'a>(page: &'a str, command: &str) -> &'a str {
    let (_, after) =
        page.split_once(&format!(" id=\"system-{command}\"")).unwrap_or_else(|| panic!("{command}"));
    after.split("</details>").next().unwrap_or_default()
}

fn text_of(markup: &str) -> String {
    markup.split('<').filter_map(|piece| piece.split_once('>')).map(|(_, text)| text).collect()
}

#[test]
fn b_is_shown_where_it_is_not_x() {
    let page = page_with(&Paper::new(), good);
    for (system, has_b) in [("euler", false), ("lagrange", true), ("lv", true)] {
        assert_eq!(sheet(&page, system).contains("<mi>b</mi><mo"), has_b, "{system}");
    }
}

#[test]
fn an_opened_system_shows_everything_that_is_claimed_of_it() {
    let paper = Paper::new();
    let page = page_with(&paper, good);
    for entry in registry::all() {
        let system = kahan_algebra::read(&lex(entry.text()).tokens).system().expect("a system");
        let sheet = sheet(&page, entry.command);
        let shown: Vec<&str> = sheet.split("<div class=\"preserved\">").skip(1).collect();
        assert_eq!(shown.len(), system.claims.len(), "{}", entry.command);
        for claim in &system.claims {
            let id = format!("{}.{}", entry.command, claim.name.text);
            let block = shown.iter().find(|block| block.contains(&format!("href=\"#claim-{id}\"")));
            let block = block.unwrap_or_else(|| panic!("{id} is not shown"));
            let kind = match claim.kind {
                ClaimKind::Integral => "<p class=\"source\">Integral",
                ClaimKind::Density => "<p class=\"source\">Invariant density",
                ClaimKind::Bracket => "<p class=\"source\">Invariant Poisson bracket",
                ClaimKind::Drift => "<p class=\"source\">Drift",
            };
            assert!(block.contains(kind), "{id}");
            assert_eq!(block.contains(", when "), !claim.conditions.is_empty(), "{id}");
            let formulas = block.matches("<div class=\"formula\"").count();
            match &claim.body {
                ClaimBody::Tensor(entries) => {
                    let n = system.field.symbols.states.len();
                    assert_eq!(formulas, entries.len(), "{id}");
                    assert_eq!(block.contains("every other pair"), formulas < n * (n - 1) / 2, "{id}");
                }
                ClaimBody::Function(_) => assert_eq!(formulas, 1, "{id}"),
                ClaimBody::Recurrence { .. } => assert_eq!(formulas, 2, "{id}"),
            }
            let words = text_of(block);
            let symbols = &system.field.symbols;
            for (i, state) in symbols.states.iter().enumerate().filter(|(_, state)| state.len() == 1) {
                if variables(&claim.plan).contains(&symbols.state(i)) {
                    assert!(words.contains(state.as_str()), "{id} shows no {state}: {words}");
                }
            }
        }
    }
}

fn formulas(page: &str) -> impl Iterator<Item = &str> {
    page.split("<math ").skip(1).filter_map(|rest| rest.split("</math>").next())
}

#[test]
fn parentheses_stretch_around_what_is_tall() {
    let page = page_with(&Paper::new(), good);
    let mut stretched = 0;
    for formula in formulas(&page) {
        let mut open: Vec<(usize, bool)> = Vec::new();
        let mut at = 0;
        for piece in formula.split_inclusive('<') {
            let (tag, text) = piece.trim_end_matches('<').split_once('>').unwrap_or_default();
            let stretches = tag.contains("stretchy=\"true\"");
            match (tag.starts_with("mo"), text) {
                (true, "(" | "[" | "{") => open.push((at, stretches)),
                (true, ")" | "]" | "}") => {
                    if let Some((start, begins)) = open.pop() {
                        let inside = &formula[start..at];
                        let is_tall =
                            ["<mfrac", "<mtable", "<munderover"].iter().any(|tall| inside.contains(tall));
                        assert!(!is_tall || stretches && begins, "{}", text_of(formula));
                        stretched += usize::from(is_tall);
                    }
                }
                _ => {}
            }
            at += piece.len();
        }
    }
    assert!(stretched > 100, "{stretched}");
}

/// Returns a formula's width in characters. A fraction or table is as wide as its widest part.
fn width(formula: &str) -> usize {
    let xml = format!("<math {formula}</math>");
    let mut reader = Reader::from_str(&xml);
    let mut open: Vec<(String, Vec<usize>)> = vec![(String::new(), Vec::new())];
    loop {
        match reader.read_event().expect("well formed") {
            Event::Eof => return open[0].1.iter().sum(),
            Event::Start(start) => open.push((start.name().as_ref().to_owned(), Vec::new())),
            Event::Text(text) => {
                let characters = text.trim().chars().count();
                open.last_mut().expect("an element").1.push(characters);
            }
            Event::End(_) => {
                let (name, children) = open.pop().expect("an element");
                let width = match name.as_str() {
                    "mfrac" | "mtable" | "munderover" => children.iter().copied().max().unwrap_or(0),
                    "mover" => children.first().copied().unwrap_or(0),
                    _ => children.iter().sum(),
                };
                open.last_mut().expect("the formula around it").1.push(width);
            }
            _ => {}
        }
    }
}

#[test]
fn no_formula_is_wider_than_its_place() {
    let page = page_with(&Paper::new(), good);
    let (systems, rest) = page.split_once("<section id=\"tables\"").expect("the tables");
    for formula in formulas(systems) {
        assert!(width(formula) <= 90, "{} characters: {}", width(formula), text_of(formula));
    }
    for formula in formulas(rest) {
        assert!(width(formula) <= 64, "{} characters: {}", width(formula), text_of(formula));
    }
    let lagrange = sheet(&page, "lagrange");
    assert!(
        lagrange.contains("<mfrac><mrow><mtable class=\"menv-alignlike"),
        "a long numerator is in one line"
    );
}
