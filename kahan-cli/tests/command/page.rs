//! The page of one field: well formed, self-contained, and every figure made again by the command
//! below it.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use quick_xml::Reader;
use quick_xml::escape::unescape;
use quick_xml::events::Event;

#[cfg(unix)]
use crate::running::examples_run;
use crate::running::{answer, refusal, text};

/// The page with these arguments, which begin after `page`.
fn page(folder: &Path, arguments: &[&str]) -> String {
    answer(&[&["page"], arguments, &["--out", folder.to_str().expect("UTF-8")]].concat());
    fs::read_to_string(folder.join("index.html")).expect("the page")
}

/// The commands on a page, as one copies them.
fn commands(page: &str) -> Vec<String> {
    let parts = page.split("<pre class=\"command\"").skip(1);
    let code = |part: &str| {
        let text =
            part.split_once("<code>").and_then(|(_, rest)| rest.split_once("</code>")).expect("code").0;
        unescape(text).expect("text").into_owned()
    };
    parts.map(code).collect()
}

#[cfg(unix)]
fn shell(line: &str, folder: &Path) -> Output {
    let arguments = line.strip_prefix("kahan ").expect("a command");
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("\"$KAHAN\" {arguments}")]);
    shell.env("KAHAN", env!("CARGO_BIN_EXE_kahan")).current_dir(folder).output().expect("a shell")
}

/// The drawing in the figure of this name.
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
    let lines = commands(&page);
    let names: Vec<&str> = lines.iter().filter_map(|line| line.split(' ').nth(1)).collect();
    let of_figures =
        ["show", "discover", "poles", "picture", "picture", "picture", "picture", "dynamics", "map", "trade"];
    assert_eq!(names, [&["page"], &of_figures[..]].concat());
    for line in &lines[1..] {
        let output = shell(line, folder.path());
        let said = text(&output.stderr);
        // Whether there was time for a reference trajectory is not known here.
        let is_short = line.starts_with("kahan trade") && said.contains("give more time");
        assert!(output.status.code() == Some(0) || is_short, "{line}: {said}");
    }
    // Heights depend on how much time there was.
    for id in ["portrait", "time", "section", "map"] {
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

#[test]
fn what_cannot_be_made_is_left_out_and_said() {
    let folder = tempfile::tempdir().expect("a folder");
    let grows = page(folder.path(), &["--field", "xdot = x; ydot = x + y;", "--seconds", "0.5"]);
    assert!(grows.contains("This orbit does not stay"));
    // The solution is a tangent, so that there is no trajectory to follow for long.
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
