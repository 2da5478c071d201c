//! Chains of any number of sites: formulas, files, and preserved sums.

use super::*;
use crate::running::{answer, kahan, object, refusal};

const WAVE: &str = "for i in periodic {
        u[i]dot = -3*(u[i+1]^2 - u[i-1]^2)/(2*h) - (u[i+2] - 2*u[i+1] + 2*u[i-1] - u[i-2])/(2*h^3);
    }
    integral mass = sum(u[i]);
    hamiltonian H = sum((u[i+1] - u[i])^2/(2*h^2) - u[i]^3);";

const SHORE: &str = "for i in open { n[i]dot = n[i]*(r[i] - n[i] - mu*(n[i-1] + n[i+1])); }";

const SPRINGS: &str = "for i in open { a[i]dot = a[i]*(b[i+1] - b[i]); b[i]dot = 2*(a[i]^2 - a[i-1]^2); }";

fn chain<'a>(field: &'a str, further: &[&'a str]) -> Vec<&'a str> {
    [&["orbit", "--field", field, "--eps", "1e-3"], further].concat()
}

fn wave<'a>(further: &[&'a str]) -> Vec<&'a str> {
    let given = ["--sites", "400", "--param", "h=1/10", "--start", "u = 2*sech(h*(i - n/2))^2"];
    chain(WAVE, &[&given, further].concat())
}

fn numbers(table: &str) -> Vec<Vec<f64>> {
    table
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect()
}

fn array(file: &Path) -> (String, Vec<f64>) {
    let bytes = fs::read(file).expect("the file");
    let (header, data) = bytes.split_at(128);
    let values = data.chunks(8).map(|bytes| f64::from_le_bytes(bytes.try_into().expect("whole numbers")));
    (String::from_utf8_lossy(&header[10..]).trim_end().to_owned(), values.collect())
}

#[test]
fn a_short_chain_is_the_block_that_is_written_out() {
    let common = ["--sites", "4", "--param", "mu=3/10", "--steps", "5"];
    let at = "1/2,1,3/2,2";
    let written: Vec<String> = (0..4).map(|i| format!("r{i}={}/4", 4 + i)).collect();
    let written = written.iter().flat_map(|value| ["--param", value.as_str()]);
    let plain: Vec<&str> = chain(SHORE, &common).into_iter().chain(["--at", at]).chain(written).collect();
    let family =
        chain(SHORE, &[&common[..], &["--start", "n = (1 + i)/2", "--param", "r = 1 + i/n"]].concat());
    let (plain, family) = (answer(&plain), answer(&family));
    assert_eq!(plain.lines().next(), family.lines().next());
    for (a, b) in numbers(&plain).iter().flatten().zip(numbers(&family).iter().flatten()) {
        assert!((a - b).abs() < 1e-14, "{a} {b}");
    }
}

#[test]
fn a_wave_keeps_its_mass_and_its_modified_energy() {
    let table = answer(&wave(&["--steps", "40", "--every", "10"]));
    assert_eq!(table.lines().next(), Some("n,t,u_min,u_max,mass,H,H_modified"));
    let rows = numbers(&table);
    assert_eq!(rows.iter().map(|row| row[0]).collect::<Vec<_>>(), [0.0, 10.0, 20.0, 30.0, 40.0]);
    let drift =
        |column: usize| rows.iter().map(|row| (row[column] - rows[0][column]).abs()).fold(0.0, f64::max);
    // The map preserves `mass` and `H_modified` up to rounding, but not `H`.
    assert!(drift(4) < 1e-12 && drift(6) < 1e-11 && drift(5) > 1e-9, "{table}");
}

#[test]
fn every_k_th_state_is_in_the_array() {
    let folder = folder();
    let file = folder.path().join("u.npy");
    let further = ["--steps", "5", "--every", "2", "--out", path_text(&file)];
    let with_file = answer(&wave(&further));
    assert_eq!(with_file, answer(&wave(&further[..4])));
    let (header, values) = array(&file);
    assert_eq!(header, "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 400), }");
    assert_eq!(values.len(), 1200);
    let largest = values[400..800].iter().copied().fold(f64::MIN, f64::max);
    assert_eq!(largest, numbers(&with_file)[1][3]);
    assert_eq!(contents(&folder), ["u.npy"]);
}

#[test]
fn an_orbit_goes_on_from_a_file() {
    let folder = folder();
    let [first, second, whole] =
        ["first", "second", "whole"].map(|name| folder.path().join(name).with_extension("npy"));
    let springs = |start: &str, steps: &str, every: &str, out: &Path| {
        let given =
            ["--sites", "50", "--start", start, "--steps", steps, "--every", every, "--out", path_text(out)];
        answer(&chain(SPRINGS, &given))
    };
    let formulas = "b = cos(i); a = exp(-i)/2";
    springs(formulas, "6", "6", &whole);
    // The array `first` has the states at n = 0 and n = 3. The next orbit begins at the second.
    springs(formulas, "3", "3", &first);
    let (header, values) = array(&first);
    assert_eq!(header, "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 50, 2), }");
    let middle = folder.path().join("middle.csv");
    let rows: Vec<String> =
        values[100..].chunks(2).map(|site| format!("{:?},{:?}", site[0], site[1])).collect();
    fs::write(&middle, format!("a,b\n{}\n", rows.join("\n"))).expect("a file");
    springs(path_text(&middle), "3", "3", &second);
    assert_eq!(array(&second).1[100..], array(&whole).1[100..]);
    // Columns of the file may have any order, because each heading names the array of its column.
    let turned: Vec<String> =
        values[100..].chunks(2).map(|site| format!("{:?},{:?}", site[1], site[0])).collect();
    fs::write(&middle, format!("b,a\n{}\n", turned.join("\n"))).expect("a file");
    springs(path_text(&middle), "3", "3", &second);
    assert_eq!(array(&second).1[100..], array(&whole).1[100..]);
    fs::write(&middle, format!("b,c\n{}\n", rows.join("\n"))).expect("a file");
    let output = kahan(&chain(SPRINGS, &["--sites", "50", "--start", path_text(&middle), "--steps", "1"]));
    assert!(text(&output.stderr).contains("has no column `a`; it has b, c"));
}

#[test]
fn objects_describe_the_chain() {
    let described = object(&wave(&["--steps", "2", "--json"]));
    assert_eq!(described["arrays"], serde_json::json!(["u"]));
    assert_eq!((&described["sites"], &described["parameters"]["h"]), (&400.into(), &0.1.into()));
    assert_eq!(described["columns"].as_array().map(Vec::len), Some(7));
    assert_eq!(described["rows"].as_array().map(Vec::len), Some(3));
}

#[test]
fn a_chain_that_overflows_keeps_its_rows() {
    let folder = folder();
    let file = folder.path().join("x.npy");
    let given = ["--sites", "3", "--start", "x = 1e200*(1 + i)", "--steps", "9", "--out", path_text(&file)];
    let output = kahan(&chain("for i in periodic { x[i]dot = x[i]^2*1e200 - x[i+1]; }", &given));
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("leaves the range of f64 at step 1"), "{}", text(&output.stderr));
    assert_eq!(
        array(&file),
        ("{'descr': '<f8', 'fortran_order': False, 'shape': (1, 3), }".to_owned(), vec![1e200, 2e200, 3e200])
    );
}

#[test]
fn mistakes_are_told() {
    let folder = folder();
    let bad = folder.path().join("bad.csv");
    fs::write(&bad, "1\nnan\n3\n").expect("a file");
    let bad = path_text(&bad).to_owned();
    let simple = "for i in open { x[i]dot = c[i]*x[i+1]; }";
    let three = |start| [["--sites", "3"], ["--start", start], ["--param", "c=1"]].concat();
    for (field, further, part) in [
        (simple, three(""), "add `x = …`"),
        (simple, three("y = 1"), "no array `y`; the family has x"),
        (simple, three("x = 1; x = 2"), "`x` is given twice"),
        (simple, three("x = log(i - 1)"), "x[0] is NaN"),
        (simple, three("x = j"), "`j` is not known here"),
        (simple, three("no.npy"), "cannot read the file no.npy"),
        (simple, three(&bad), "x[1] is NaN"),
        (
            simple,
            [&three(&bad)[2..], &["--sites", "4"]].concat(),
            "has 3 x 1 numbers, and 4 sites take 4 x 1: a row a site",
        ),
        (simple, vec!["--start", "x = 1", "--param", "c=1"], "--sites"),
        (simple, vec!["--sites", "0", "--start", "x = 1", "--param", "c=1"], "1 or more"),
        (simple, vec!["--sites", "1e12", "--start", "x = 1", "--param", "c=1"], "at most"),
        (simple, vec!["--sites", "3", "--start", "x = 1"], "add one for `c`"),
        (
            simple,
            vec!["--sites", "4", "--start", "x = 1", "--param", &format!("c={bad}")],
            "`c` is not a finite",
        ),
        (simple, [three("x = 1"), vec!["--order", "4"]].concat(), "leave --scalar and --order out"),
        ("xdot = x;", three("x = 1"), "has its equations written out"),
        ("xdot = x;", vec!["--at", "1", "--out", "x.npy"], "with --start"),
        (SPRINGS, vec!["--sites", "3", "--start", "a = 1"], "add `b = …`"),
    ] {
        let paragraph = refusal(&chain(field, &[&further[..], &["--steps", "1"]].concat()));
        assert!(paragraph.replace('\n', " ").contains(part), "{further:?}: {paragraph}");
    }
}

pub(super) fn numpy(file: &Path, shape: &str, values: &[f64]) {
    numpy_of(file, "'<f8'", shape, values);
}

pub(super) fn numpy_of(file: &Path, descr: &str, shape: &str, values: &[f64]) {
    let header = format!("{{'descr': {descr}, 'fortran_order': False, 'shape': {shape}, }}");
    let mut bytes = [b"\x93NUMPY\x01\x00\x76\x00".as_slice(), format!("{header:<117}\n").as_bytes()].concat();
    bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    fs::write(file, bytes).expect("a file");
}

#[test]
fn files_are_read_by_their_shape() {
    let folder = folder();
    let file = folder.path().join("x.npy");
    let run = |path: &Path| {
        let given = ["--sites", "3", "--start", path_text(path), "--steps", "0"];
        kahan(&chain(SPRINGS, &given))
    };
    let values: Vec<f64> = (0..12).map(f64::from).collect();
    numpy(&file, "(3, 2)", &values[..6]);
    assert_eq!(numbers(&text(&run(&file).stdout))[0][2..8], values[..6]);
    // If a file has several states, the last state is the start.
    numpy(&file, "(2, 3, 2)", &values);
    assert_eq!(numbers(&text(&run(&file).stdout))[0][2..8], values[6..]);
    for shape in ["(2, 3)", "(6,)", "(1, 6)"] {
        numpy(&file, shape, &values[..6]);
        let output = run(&file);
        assert_eq!(output.status.code(), Some(2), "{shape}");
        let told = text(&output.stderr).replace('\n', " ");
        assert!(told.contains("3 sites take 3 x 2: a row a site, each with its a, b"), "{told}");
    }
    let ragged = folder.path().join("x.csv");
    fs::write(&ragged, "a,b\n1,2\n3,4,5\n6\n").expect("a file");
    assert!(text(&run(&ragged).stderr).contains("line 3 has 3 numbers, and those before it 2"));
}

#[test]
fn families_of_the_catalog_are_verified_and_shown_as_blocks() {
    let proofs = answer(&["verify", "volterra-ring", "--sites", "4"]);
    assert!(proofs.contains("proved"), "{proofs}");
    let told = refusal(&["verify", "kdv"]);
    assert!(told.contains("the number of its sites is not known"), "{told}");
    let block = answer(&["show", "volterra-ring", "--sites", "3", "--macro"]);
    assert!(block.contains("integral S = x0 + x1 + x2;"), "{block}");
    let folder = folder();
    let file = folder.path().join("block.txt");
    fs::write(&file, &block).expect("a file");
    assert!(answer(&["verify", "--file", path_text(&file)]).contains("proved"));
    let zero = "for i in periodic { x[i]dot = x[i+1] - x[i-1]; } integral Z = sum(x[i+1] - x[i]);";
    assert!(refusal(&["show", "--field", zero, "--sites", "3"]).contains("`Z` says nothing"));
}
