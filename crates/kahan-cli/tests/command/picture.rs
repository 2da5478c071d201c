//! Tests the contents of the files that `kahan picture` draws, and its refusals.

use std::fs;
use std::path::Path;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use serde_json::Value;

use crate::painting::painted;
#[cfg(unix)]
use crate::running::examples_run;
use crate::running::{answer, kahan, object, refusal, text};

fn drawn(arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("picture.svg");
    let file = file.to_str().expect("UTF-8");
    answer(&[&["picture"], arguments, &["--out", file]].concat());
    fs::read_to_string(file).expect("the picture")
}

fn described(arguments: &[&str]) -> Value {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("picture.svg");
    object(&[&["picture"], arguments, &["--json", "--out", file.to_str().expect("UTF-8")]].concat())
}

/// Returns the elements of an SVG; panics if the SVG is not well formed.
fn elements(svg: &str) -> Vec<BytesStart<'static>> {
    let mut reader = Reader::from_str(svg);
    let mut found = Vec::new();
    loop {
        match reader.read_event().expect("well-formed XML") {
            Event::Start(element) | Event::Empty(element) => found.push(element.into_owned()),
            Event::Eof => return found,
            _ => {}
        }
    }
}

fn words(svg: &str) -> Vec<String> {
    let shown = |part: &str| {
        let (_, inner) = part.split_once('>').expect("the end of a tag");
        let inner = inner.split("</text>").next().expect("words");
        inner.split('<').filter_map(|part| part.rsplit('>').next()).collect()
    };
    svg.split("<text").skip(1).map(shown).collect()
}

/// An orbit diagram may show the crossings of a plane, or the maxima of a variable.
#[test]
fn a_diagram_shows_crossings_over_a_parameter() {
    let rossler = "xdot = -y - z; ydot = x + y/5; zdot = 1/5 + z*(x - c);";
    let orbit =
        ["--field", rossler, "--eps", "1/40", "--at", "1,1,0", "--over", "c=2:4:9", "--crossings", "5"];
    for own in [&["--plane", "y"][..], &["--maxima", "x"], &["--maxima", "x", "--carry", "--transient", "0"]]
    {
        let found = described(&[&orbit[..], own].concat());
        assert_eq!((&found["kind"], &found["points"]), (&"orbits-over".into(), &45.into()), "{found}");
        assert!(
            found["shows"].as_str().expect("words").starts_with("x of field over c from 2 to 4"),
            "{found}"
        );
    }
    let usual = [&orbit[..orbit.len() - 4], &["--over", "c=2:4:2", "--maxima", "x"]].concat();
    assert_eq!(described(&usual)["points"], 200);
}

#[test]
fn a_section_has_the_crossings_of_its_orbits() {
    let orbit = ["volterra", "--eps", "1/50", "--steps", "3000", "--plane", "x - y"];
    let crossings = |at: &str| {
        let found = object(&[&["section"], &orbit[..], &["--at", at, "--json"]].concat());
        found["points"].as_array().expect("points").len()
    };
    let section = described(&[&orbit[..], &["--at", "1,2,3", "--at", "1,1,2"]].concat());
    assert_eq!(section["kind"], "section");
    assert_eq!(section["points"], crossings("1,2,3") + crossings("1,1,2"));
    let counted = [&orbit[..3], &["--at", "1,2,3", "--at", "1,1,2", "--crossings", "5"]].concat();
    assert_eq!(described(&[&counted[..], &["--plane", "x - y"]].concat())["points"], 10);
    assert_eq!(described(&[&counted[..], &["--maxima", "x"]].concat())["points"], 10);
    // The picture leaves out y, the last variable in the formula x - y.
    assert!(section["shows"].as_str().expect("words").contains("x and z"), "{section}");
    for (arguments, word) in [
        (&["--kind", "section"][..], "what vanishes there"),
        (&["--plane", "x - y", "--kind", "portrait"], "make a section"),
        (&["--crossings", "5"], "add --plane EXPR or --maxima X"),
        (&["--plane", "x - y", "--over", "eps=0:1:+1/5", "--kind", "portrait"], "orbit diagram"),
        (&["--plane", "1"], "one number everywhere"),
    ] {
        let lv = ["picture", "lv", "--eps", "1/50", "--at", "1,2", "--steps", "9", "--out", "no.svg"];
        let said = refusal(&[&lv[..], arguments].concat());
        assert!(said.contains(word), "{said}");
    }
}

#[cfg(unix)]
#[test]
fn the_examples_of_the_help_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = examples_run("picture", folder.path());
    assert!(run >= 1, "{run} examples");
    let files: Vec<_> = fs::read_dir(folder.path()).expect("the folder").flatten().collect();
    assert_eq!(files.len(), run);
    for file in files {
        let svg = fs::read_to_string(file.path()).expect("a picture");
        let elements = elements(&svg);
        assert!(elements.len() > 20 && svg.len() < 1_000_000, "{file:?}: {}", elements.len());
        let attribute = |name: &str| elements[0].try_get_attribute(name).expect("attributes");
        assert!(attribute("aria-label").is_some_and(|label| label.value.len() > 20), "{file:?}");
        assert!(svg.contains("prefers-color-scheme:dark"), "{file:?}");
        assert!(painted(&svg) > 15, "{file:?}");
    }
}

#[test]
fn the_points_of_a_portrait_are_those_of_the_orbit() {
    let arguments = ["lv", "--eps", "1/10", "--at", "1/2,5/3", "--steps", "3"];
    let window = ["--window", "x=0:4", "--window", "y=0:4", "--size", "480x466"];
    let svg = drawn(&[&arguments[..], &window].concat());
    // In the drawing, the axes are 425.32 and 412 units long. They meet at (40.68, 424).
    let table = answer(&[&["orbit"], &arguments[..]].concat());
    let place = |row: &str| {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().expect("a number")).collect();
        (40.68 + 425.32 / 4.0 * cells[2], 424.0 - 103.0 * cells[3])
    };
    let (_, path) = svg.split_once("class=\"dots\" d=\"").expect("dots");
    let path = path.split('"').next().expect("its end");
    let dots: Vec<(f64, f64)> = path
        .split('M')
        .skip(1)
        .map(|dot| {
            let (x, y) = dot.trim_end_matches("h0").split_once(' ').expect("two numbers");
            (x.parse().expect("a number"), y.parse().expect("a number"))
        })
        .collect();
    let rows: Vec<(f64, f64)> = table.lines().skip(1).map(place).collect();
    assert_eq!(dots.len(), rows.len());
    for (dot, row) in dots.iter().zip(&rows) {
        // Coordinates in the drawing are rounded to tenths.
        assert!((dot.0 - row.0).abs() <= 0.0501 && (dot.1 - row.1).abs() <= 0.0501, "{dot:?}, {row:?}");
    }
}

#[test]
fn three_variables_are_drawn_in_space_and_time_has_its_unit() {
    let arguments = ["e6", "--eps", "1/20", "--at", "1,2,3", "--steps", "500"];
    let svg = drawn(&arguments);
    for name in ["x", "y", "z"] {
        assert!(words(&svg).iter().any(|words| words == name), "{:?}", words(&svg));
    }
    assert!(svg.matches("class=\"dots\"").count() > 5, "layers of depth");
    let svg = drawn(&[&arguments[..], &["--axes", "t,z", "--lines"]].concat());
    assert!(words(&svg).iter().any(|words| words == "t"), "{:?}", words(&svg));
    assert!(svg.contains("class=\"line\"") && !svg.contains("class=\"dots"));
}

#[test]
fn starts_lie_on_a_line_or_around_a_point_and_follow_the_seed() {
    let on_a_line = ["lv", "--eps", "1/10", "--at", "1/4,1..1,1", "--starts", "4", "--steps", "0"];
    let window = ["--window", "x=0:2", "--window", "y=0:2", "--size", "480x466"];
    let svg = drawn(&[&on_a_line[..], &window].concat());
    for dot in ["M104.9 218h", "M156.4 218h", "M208 218h", "M259.6 218h"] {
        assert!(svg.contains(dot), "{dot}: {svg}");
    }
    let random = |seed| {
        let around = ["lv", "--eps", "1/10", "--at", "1,1", "--starts", "50", "--radius", "1/2"];
        drawn(&[&around[..], &["--steps", "0", "--seed", seed], &window].concat())
    };
    assert_eq!(random("1"), random("1"));
    assert_ne!(random("1"), random("2"));
    let dots: usize = ["h0", "h.01"].map(|dot| random("1").matches(dot).count()).iter().sum();
    assert_eq!(dots, 50);
}

#[test]
fn an_orbit_diagram_shows_what_is_left_after_the_transient() {
    // The field has a sink for every value of the parameter.
    let field = "xdot = a - x;";
    let over = ["--field", field, "--over", "a=0:4:+1/2", "--eps", "1/10", "--at", "7", "--steps", "5"];
    let svg = drawn(&[&over[..], &["--window", "x=-1:5", "--transient", "400"]].concat());
    // The diagram has one point for each value of a.
    assert_eq!(svg.matches("h0").count(), 9, "{svg}");
    let early = drawn(&[&over[..], &["--transient", "0"]].concat());
    assert!(early.matches("h0").count() > 40, "{early}");
    let over = ["lv", "--over", "eps=1/10:1/5:+1/40", "--at", "1/2,1", "--axes", "y", "--steps", "9"];
    assert!(words(&drawn(&over)).iter().any(|words| words == "ε"));
    assert_eq!(described(&over)["points"], 50);
}

#[test]
fn heights_are_straight_lines_of_their_growth() {
    let heights = |system: &[&str]| {
        let arguments = [&["--eps", "1/2", "--steps", "16", "--kind", "heights"], system].concat();
        (described(&arguments), drawn(&arguments))
    };
    let (object, svg) = heights(&["e3", "--at", "3/7,11/13,23/47"]);
    assert_eq!(object["notes"][0], "growth is linear");
    assert!(words(&svg).iter().any(|words| words == "ln n"));
    let (object, svg) = heights(&["lv", "--at", "1/2,5/3"]);
    assert_eq!(object["notes"][0], "growth is exponential");
    assert!(words(&svg).iter().any(|words| words == "n"));
}

#[test]
fn orbits_that_end_early_and_points_outside_are_counted() {
    // The map is x̃ = x/(1 − 2εx), so the orbit is 1/2, 1, ∞.
    let pole = described(&["--field", "xdot = x^2;", "--eps", "1/2", "--at", "1/2", "--steps", "9"]);
    assert_eq!(pole["points"], 2);
    assert!(
        pole["notes"][0].as_str().is_some_and(|note| note.starts_with("1 of 1 orbits end early")),
        "{pole}"
    );
    let growing = ["--field", "xdot = x;", "--eps", "1/10", "--at", "1", "--steps", "20"];
    assert_eq!(described(&growing)["outside"], 0);
    let cut = described(&[&growing[..], &["--window", "x=0:2"]].concat());
    assert!(cut["outside"].as_u64().is_some_and(|count| count > 10), "{cut}");
}

#[test]
fn what_cannot_be_drawn_is_refused_and_leaves_no_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let svg = file("picture.svg");
    let lv = ["lv", "--at", "1/2,1", "--steps", "9"];
    let with_eps = [&lv[..], &["--eps", "1/10"]].concat();
    let cases: Vec<(Vec<&str>, &[&str])> = vec![
        (lv.to_vec(), &["--eps"]),
        ([&with_eps[..], &["--axes", "x,q"]].concat(), &["--axes", "`q`", "x, y"]),
        ([&with_eps[..], &["--axes", "x"]].concat(), &["two axes or three"]),
        ([&with_eps[..], &["--over", "eps=1/10:1:+1/9"]].concat(), &["leave --eps out"]),
        ([&with_eps[..], &["--over", "a=0:1:+1/9"]].concat(), &["`a` is no parameter of lv", "eps"]),
        ([&lv[..], &["--over", "eps=0:1"]].concat(), &["FROM:TO:COUNT", "0:1:+1/10"]),
        ([&lv[..], &["--over", "eps=1:1:5"]].concat(), &["FROM and TO are both 1"]),
        ([&with_eps[..], &["--kind", "orbits-over"]].concat(), &["over what?"]),
        ([&lv[..], &["--over", "eps=0:1:+1/5", "--kind", "heights"]].concat(), &["--over"]),
        ([&with_eps[..], &["--kind", "heights", "--starts", "3"]].concat(), &["one orbit"]),
        ([&with_eps[..], &["--window", "z=0:1"]].concat(), &["no axis `z`", "x, y"]),
        ([&with_eps[..], &["--window", "x=1:0"]].concat(), &["LOW below HIGH"]),
        ([&with_eps[..], &["--size", "9x9"]].concat(), &["960x720"]),
        ([&with_eps[..], &["--size", "4000x100"]].concat(), &["at most four times"]),
        (vec!["lv", "--eps", "1/10", "--at", "1,1..2,2", "--steps", "9"], &["--starts"]),
        (vec!["lv", "--eps", "1/10", "--at", "1,1", "--steps", "1e9"], &["fewer steps"]),
        (vec!["lv", "--eps", "1/10", "--at", "1,1", "--steps", "1e6", "--lines"], &["leave --lines out"]),
        (vec!["lv", "--eps", "1/10", "--at", "1", "--steps", "9"], &["2 coordinates x,y expected"]),
    ];
    for (arguments, expected) in &cases {
        let paragraph = refusal(&[&["picture"], &arguments[..], &["--out", &svg]].concat());
        for part in *expected {
            assert!(paragraph.contains(part), "{arguments:?} does not say {part}: {paragraph}");
        }
    }
    let other = refusal(&[&["picture"], &with_eps[..], &["--out", &file("picture.gif")]].concat());
    assert!(other.contains(".svg, .png or .pdf"), "{other}");
    assert_eq!(fs::read_dir(folder.path()).expect("the folder").count(), 0);
}

#[test]
fn a_png_or_a_pdf_is_written_or_it_is_said_how_to_get_it() {
    let folder = tempfile::tempdir().expect("a folder");
    // In a PNG, width and height follow the first 16 bytes.
    let size = [960_u32.to_be_bytes(), 720_u32.to_be_bytes()].concat();
    let kinds: [(&str, bool, &[u8], &[u8]); 2] = [
        ("png", cfg!(feature = "png"), b"\x89PNG\r\n\x1a\n", &size),
        ("pdf", cfg!(feature = "pdf"), b"%PDF-", b"MediaBox[0 0 720 540]"),
    ];
    for (ending, is_built, magic, part) in kinds {
        let file = folder.path().join("lv").with_extension(ending);
        let arguments = ["picture", "lv", "--eps", "1/10", "--at", "1/2,1", "--steps", "9", "--out"];
        let output = kahan(&[&arguments[..], &[file.to_str().expect("UTF-8")]].concat());
        if is_built {
            assert_eq!(output.status.code(), Some(0));
            let bytes = fs::read(&file).expect("the picture");
            assert!(bytes.starts_with(magic) && bytes.windows(part.len()).any(|window| window == part));
        } else {
            assert_eq!(output.status.code(), Some(2));
            let why = text(&output.stderr);
            assert!(why.contains(&format!("--features {ending}")) && why.contains(".svg"), "{why}");
            assert!(!Path::new(&file).exists());
        }
    }
}

#[test]
fn in_print_a_picture_is_black_on_white_and_has_the_width_of_a_column() {
    let svg = drawn(&["lv", "--eps", "1/10", "--at", "1/2,1", "--steps", "9", "--paper"]);
    assert!(svg.contains("width=\"86.02mm\"") && svg.contains("fill=\"#ffffff\""), "{svg}");
    assert!(!svg.contains("<style") && painted(&svg) > 15, "{svg}");
}

#[test]
fn time_is_bounded_and_what_there_is_is_shown() {
    let long = ["lv", "--over", "eps=1/10:1/5:+1/90", "--at", "1/2,1", "--steps", "9", "--transient", "1e15"];
    let object = described(&[&long[..], &["--seconds", "0.2"]].concat());
    assert!(object["notes"][0].as_str().is_some_and(|note| note.starts_with("time ran out")), "{object}");
}

#[test]
fn the_pictures_of_the_documentation_have_plain_colours() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let folders = [docs.join("reference"), docs].map(|folder| fs::read_dir(folder).expect("the folder"));
    let files = folders.into_iter().flatten().flatten().map(|file| file.path());
    let pictures: Vec<_> =
        files.filter(|path| path.extension().is_some_and(|ending| ending == "svg")).collect();
    assert!(pictures.len() >= 3, "{pictures:?}");
    for picture in pictures {
        assert!(painted(&fs::read_to_string(&picture).expect("a picture")) > 1, "{picture:?}");
    }
}

#[test]
fn an_orbit_that_comes_back_to_the_same_places_is_seen() {
    // The field has two integrals, so each orbit is a closed curve with one crossing.
    let rabinovich =
        ["--field", "xdot = y*z; ydot = -x*z; zdot = x*y;", "--eps", "1/10", "--at", "1,1/2,1/3"];
    let section = ["--at", "1,1/3,1/5", "--plane", "z", "--steps", "20000"];
    let svg = drawn(&[&rabinovich[..], &section].concat());
    let (_, dots) = svg.split_once("class=\"dots\" d=\"").expect("dots");
    assert!(dots.contains("stroke-width=\"4\""), "{dots}");
}
