//! Tests that `kahan page` writes a self-contained page with commands that reproduce its figures.

use std::fs;
use std::path::Path;

use quick_xml::Reader;
use quick_xml::escape::unescape;
use quick_xml::events::Event;

use crate::painting::{drawings, painted};
use crate::running::{answer, kahan, refusal, text};
#[cfg(unix)]
use crate::running::{examples_run, shell};

fn page(folder: &Path, arguments: &[&str]) -> String {
    answer(&[&["page"], arguments, &["--out", folder.to_str().expect("UTF-8")]].concat());
    fs::read_to_string(folder.join("index.html")).expect("the page")
}

fn commands(page: &str) -> Vec<String> {
    let parts = page.split("<pre class=\"command\"").skip(1);
    let code = |part: &str| {
        let text =
            part.split_once("<code>").and_then(|(_, rest)| rest.split_once("</code>")).expect("code").0;
        unescape(text).expect("text").into_owned()
    };
    parts.map(code).collect()
}

fn drawing<'a>(page: &'a str, id: &str) -> &'a str {
    let figure = page.split_once(&format!("id=\"{id}\"")).expect("the figure").1;
    let svg = figure.split_once("<svg").expect("a drawing").1;
    svg.split_once('>').and_then(|(_, rest)| rest.split_once("</svg>")).expect("its end").0
}

#[cfg(unix)]
#[test]
fn every_command_on_a_page_makes_what_stands_above_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let field = "xdot = y; ydot = a*x - x^2; zdot = y*(x - z);";
    let page = page(folder.path(), &["--field", field, "--param", "a=-1", "--seconds", "1"]);
    let drawings = drawings(&page);
    assert!(drawings.len() >= 5, "{}", drawings.len());
    for drawing in drawings {
        assert!(painted(drawing) > 15, "{drawing}");
    }
    let lines = commands(&page);
    let names: Vec<&str> = lines.iter().filter_map(|line| line.split(' ').nth(1)).collect();
    let of_figures = [
        "show", "discover", "poles", "picture", "picture", "picture", "picture", "dynamics", "chart", "trade",
    ];
    assert_eq!(names, [&["page"], &of_figures[..]].concat());
    for line in &lines[1..] {
        let output = shell(line, folder.path());
        let said = text(&output.stderr);
        // The time may be too short for `kahan trade`.
        let is_short = line.starts_with("kahan trade") && said.contains("more --seconds");
        assert!(output.status.code() == Some(0) || is_short, "{line}: {said}");
    }
    // Figures that depend on the available time, such as heights, are not compared.
    for id in ["portrait", "time", "section", "chart"] {
        let file = fs::read_to_string(folder.path().join(format!("{id}.svg"))).expect("the file");
        assert!(file.contains(drawing(&page, id)), "{id}");
    }
}

#[cfg(unix)]
#[test]
fn the_examples_of_the_help_run() {
    let folder = tempfile::tempdir().expect("a folder");
    assert!(examples_run("page", folder.path()) > 0);
}

#[test]
fn formulas_have_the_values_that_the_command_below_them_has() {
    let folder = tempfile::tempdir().expect("a folder");
    let field = ["--field", "xdot = a*y; ydot = -x^2;", "--param", "a=3", "--seconds", "0.5"];
    let page = page(folder.path(), &field);
    let formulas = page.split_once("<section id=\"formulas\">").expect("formulas").1;
    let (formulas, _) = formulas.split_once("</section>").expect("its end");
    assert!(formulas.contains("<mn>3</mn><mi>y</mi>") && !formulas.contains("<mi>a</mi>"), "{formulas}");
}

#[test]
fn a_page_is_well_formed_and_fetches_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let page = page(folder.path(), &["--field", "xdot = 1/4 - x^2;", "--seconds", "0.5"]);
    let xml = page.replace("<!DOCTYPE html>", "");
    let xml = xml.split("<meta").enumerate().map(|(index, part)| match index {
        0 => part.to_owned(),
        _ => format!("<meta{}", part.replacen('>', "/>", 1)),
    });
    let xml = xml.collect::<String>();
    let mut reader = Reader::from_str(&xml);
    while reader.read_event().expect("well-formed XML") != Event::Eof {}
    for word in ["<script", "http://", "https://", "<link", "url(", "class=\"unset\""] {
        let found = page.replace("http://www.w3.org/", "");
        assert!(!found.contains(word), "{word}");
    }
}

fn caption<'a>(page: &'a str, id: &str) -> &'a str {
    let figure = page.split_once(&format!("id=\"{id}\"")).expect("the figure").1;
    figure.split_once("<figcaption>").and_then(|(_, rest)| rest.split_once("</figcaption>")).expect("words").0
}

#[test]
fn what_is_found_is_followed_and_a_section_says_what_is_seen() {
    let folder = tempfile::tempdir().expect("a folder");
    // The two fields listed below have two unclaimed integrals each, so their orbits are curves.
    let field = "xdot = h*y - nu*x + y*z; ydot = h*x - nu*y - x*z; zdot = -nu*z + x*y;";
    for arguments in [
        &["--field", "xdot = y*z; ydot = -x*z; zdot = x*y;"][..],
        &["--field", field, "--param", "h=1", "--param", "nu=0"],
    ] {
        let page = page(folder.path(), &[arguments, &["--seconds", "4"]].concat());
        assert!(caption(&page, "section").contains("come back to the same place"), "{page}");
        assert!(page.contains("Drift of the integrals"), "{page}");
        for line in commands(&page).iter().filter(|line| {
            ["dynamics", "trade"].iter().any(|name| line.starts_with(&format!("kahan {name}")))
        }) {
            assert!(
                line.contains("integral H1") && line.contains("integral H2") && !line.contains("when"),
                "{line}"
            );
        }
    }
    let rossler = ["--field", "xdot = -y - z; ydot = x + y/5; zdot = 1/5 + z*(x - 57/10);", "--seconds", "4"];
    let chaotic = page(folder.path(), &rossler);
    assert!(caption(&chaotic, "section").contains("orbits cross at many places"), "{chaotic}");
    let falls = page(folder.path(), &["--field", "xdot = y; ydot = -x; zdot = -z;", "--seconds", "1"]);
    assert!(falls.contains("Left out: there is nothing to be seen"), "{falls}");
}

#[test]
fn a_page_says_once_what_is_taken_as_a_parameter() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let known = ["page", "--field", "xdot = a*y; ydot = -x;", "--seconds", "1", "--out", out];
    let output = kahan(&[&known[..], &["--param", "a=1"]].concat());
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
    assert!(!refusal(&known).contains("note"));
}

#[test]
fn what_cannot_be_made_is_left_out_and_said() {
    let folder = tempfile::tempdir().expect("a folder");
    let grows = page(folder.path(), &["--field", "xdot = x; ydot = x + y;", "--seconds", "0.5"]);
    assert!(grows.contains("This orbit does not stay"));
    // The solution is tan t, whose pole ends the reference trajectory.
    let escapes = page(folder.path(), &["--field", "xdot = x^2 + 1;", "--seconds", "0.5"]);
    assert!(escapes.contains("Left out: "));
    let there = folder.path().join("index.html");
    let before = fs::read_to_string(&there).expect("the page");
    let out = folder.path().to_str().expect("UTF-8");
    let said = refusal(&["page", "--field", "xdot = a*x^2;", "--out", out]);
    assert!(said.contains("--param a=VALUE"), "{said}");
    refusal(&["page", "e6", "--at", "1,2", "--out", out]);
    assert_eq!(fs::read_to_string(&there).expect("the page"), before);
}

/// A pendulum in the notation of a textbook. One of its two parameters has a value.
const PENDULUM: &str = "x'' = -g*sin(x) - k*x', g = 2";

#[cfg(unix)]
#[test]
fn the_page_of_a_lifted_field_shows_the_lift_and_its_commands_choose_the_same() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = ["page", "--field", PENDULUM, "--param", "k=0", "--lift", "--seconds", "1", "--out"];
    let output = kahan(&[&arguments[..], &[folder.path().to_str().expect("UTF-8")]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let page = fs::read_to_string(folder.path().join("index.html")).expect("the page");
    let lift =
        page.split_once("<section id=\"lift\">").expect("the lift").1.split_once("</section>").unwrap().0;
    assert!(lift.contains("x'' = -g*sin(x) - k*x', g = 2"), "{lift}");
    for part in
        ["sin_x = sin(x)", "cos_x = cos(x)", "<td>bounded</td>", "kept exactly: ", "the orbit from (1, 1/2)"]
    {
        assert!(lift.contains(part), "{part}: {lift}");
    }
    assert!(painted(drawing(&page, "relations")) > 15);
    assert!(page.contains("With 2 new variables this differential equation is quadratic"));
    let lines = commands(&page);
    assert!(lines[1].starts_with("kahan lift") && lines[1].contains("x(0) = 1; v(0) = 1/2;"), "{}", lines[1]);
    for line in lines[1..].iter().filter(|line| !line.starts_with("kahan trade")) {
        let output = shell(line, folder.path());
        assert_eq!(output.status.code(), Some(0), "{line}: {}", text(&output.stderr));
    }
    for id in ["relations", "portrait", "time"] {
        let file = fs::read_to_string(folder.path().join(format!("{id}.svg"))).expect("the file");
        assert!(file.contains(drawing(&page, id)), "{id}");
    }
}

#[test]
fn the_lift_of_a_page_is_chosen_along_an_orbit() {
    let folder = tempfile::tempdir().expect("a folder");
    let neuron = "v' = v - v^3/3 - w + 1/2, w' = (v + 0.7 - 0.8*w)*0.08";
    let shown = page(folder.path(), &["--field", neuron, "--lift", "--seconds", "0.5"]);
    assert!(shown.contains("decays at the rate -1."), "{shown}");
    let given = page(folder.path(), &["--field", neuron, "--lift", "--at", "2,1/2", "--seconds", "0.5"]);
    assert!(given.contains("the orbit from (2, 1/2)") && given.contains("v(0) = 2; w(0) = 1/2;"), "{given}");
    let plain = page(folder.path(), &["--field", "xdot = 1/4 - x^2;", "--lift", "--seconds", "0.5"]);
    assert!(!plain.contains("id=\"lift\"") && plain.contains("turns this quadratic differential equation"));
}
