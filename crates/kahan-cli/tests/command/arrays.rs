//! Fields from files of `np.savez`, which are built byte by byte.

use std::io::Write;

use flate2::Compression;
use flate2::write::DeflateEncoder;
use rawzip::{CompressionMethod, ZipArchiveWriter};

use crate::running::{answer, kahan, refusal, text};

struct Npz {
    folder: tempfile::TempDir,
    files: Vec<(String, Vec<u8>)>,
}

fn floats(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

impl Npz {
    fn new() -> Self {
        Npz { folder: tempfile::tempdir().expect("a folder"), files: Vec::new() }
    }

    fn with(mut self, name: &str, descr: &str, shape: &str, data: Vec<u8>) -> Self {
        let header = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}\n");
        let length = u16::try_from(header.len()).expect("short").to_le_bytes();
        let file = [&b"\x93NUMPY\x01\x00"[..], &length, header.as_bytes(), &data].concat();
        self.files.push((format!("{name}.npy"), file));
        self
    }

    fn numbers(self, name: &str, shape: &str, values: &[f64]) -> Self {
        self.with(name, "<f8", shape, floats(values))
    }

    fn words(self, name: &str, shape: &str, words: &[&str]) -> Self {
        let length = words.iter().map(|word| word.chars().count()).max().unwrap_or(0);
        let letters = words.iter().flat_map(|word| word.chars().chain(std::iter::repeat('\0')).take(length));
        let data = letters.flat_map(|letter| u32::from(letter).to_le_bytes()).collect();
        self.with(name, &format!("<U{length}"), shape, data)
    }

    fn run<R>(&self, is_packed: bool, command: impl Fn(&str) -> R) -> R {
        let mut archive = ZipArchiveWriter::new(Vec::new());
        for (name, file) in &self.files {
            let method = if is_packed { CompressionMethod::DEFLATE } else { CompressionMethod::STORE };
            let (mut entry, config) =
                archive.new_file(name).compression_method(method).start().expect("an entry");
            let descriptor = if is_packed {
                let mut writer = config.wrap(DeflateEncoder::new(&mut entry, Compression::default()));
                writer.write_all(file).expect("memory");
                let (encoder, descriptor) = writer.finish().expect("memory");
                encoder.finish().expect("memory");
                descriptor
            } else {
                let mut writer = config.wrap(&mut entry);
                writer.write_all(file).expect("memory");
                writer.finish().expect("memory").1
            };
            entry.finish(descriptor).expect("memory");
        }
        let path = self.folder.path().join("model.npz");
        std::fs::write(&path, archive.finish().expect("memory")).expect("a file");
        command(path.to_str().expect("a path of letters"))
    }

    fn refusal(&self) -> String {
        self.run(false, |path| refusal(&["show", "--file", path]))
    }
}

const ROTATED: [f64; 4] = [0.0, 1.0, -1.0, -0.25];

#[test]
fn a_file_of_arrays_is_a_field() {
    let given = Npz::new().numbers("c", "(2,)", &[0.0, 0.5]).numbers("B", "(2, 2)", &ROTATED);
    let given = given.words("names", "(2,)", &["x", "vel"]);
    let text = "xdot = vel; veldot = 1/2 - x - 1/4*vel - x^2 + 3*x*vel;";
    let wanted = answer(&["show", "--field", text]);
    let mut cube = [0.0; 8];
    (cube[4], cube[5], cube[6]) = (-1.0, 1.0, 2.0);
    for (shape, q) in
        [("(2, 2, 2)", &cube[..]), ("(2, 4)", &cube[..]), ("(2, 3)", &[0.0, 0.0, 0.0, -1.0, 3.0, 0.0])]
    {
        let given = Npz { files: given.files.clone(), ..Npz::new() }.numbers("Q", shape, q);
        for is_packed in [false, true] {
            let shown = given.run(is_packed, |path| answer(&["show", "--file", path]));
            assert_eq!(shown, wanted, "{shape}");
        }
    }
    let sparse = Npz { files: given.files.clone(), ..Npz::new() }
        .numbers("Q_data", "(3,)", &[-1.0, 1.0, 2.0])
        .with(
            "Q_indices",
            "<i4",
            "(3,)",
            [0_i32, 1, 2].iter().flat_map(|index| index.to_le_bytes()).collect(),
        )
        .with("Q_indptr", "<i8", "(3,)", [0_i64, 0, 3].iter().flat_map(|end| end.to_le_bytes()).collect());
    assert_eq!(sparse.run(true, |path| answer(&["show", "--file", path])), wanted);
    let orbit = |source: [&str; 2]| {
        let run =
            kahan(&[&["orbit"][..], &source, &["--eps", "0.01", "--at", "1/2,0", "--steps", "50"]].concat());
        assert_eq!((run.status.code(), &*self::text(&run.stderr)), (Some(0), ""));
        self::text(&run.stdout)
    };
    assert_eq!(sparse.run(false, |path| orbit(["--file", path])), orbit(["--field", text]));
}

#[test]
fn columns_of_products_have_two_orders() {
    let products = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    let field = |order: &str| {
        let file = Npz::new().words("order", "()", &[order]);
        let q = [products, [0.0; 6], [0.0; 6]].concat();
        file.numbers("Q", "(3, 6)", &q).run(false, |path| answer(&["show", "--file", path]))
    };
    let wanted =
        |products: &str| answer(&["show", "--field", &format!("x1dot = {products}; x2dot = 0; x3dot = 0;")]);
    assert_eq!(field("tril"), wanted("x1^2 + 2*x2*x1 + 3*x2^2 + 4*x3*x1 + 5*x3*x2 + 6*x3^2"));
    assert_eq!(field("triu"), wanted("x1^2 + 2*x1*x2 + 3*x1*x3 + 4*x2^2 + 5*x2*x3 + 6*x3^2"));
}

#[test]
fn what_is_no_field_is_refused_with_its_reason() {
    let pair = || Npz::new().numbers("c", "(2,)", &[1.0, 2.0]);
    for (file, reason) in [
        (Npz::new(), "lacks arrays c, B and Q"),
        (Npz::new().words("names", "(1,)", &["x"]), "lacks arrays c, B and Q"),
        (pair().numbers("D", "(1,)", &[1.0]), "has an array `D`"),
        (
            Npz::new().numbers("b", "(1,)", &[1.0]).numbers("A", "(1, 1)", &[1.0]),
            "has arrays `A`, `b`, and a field has c, B, Q, names and order",
        ),
        (Npz::new().numbers("arr_0", "(1,)", &[1.0]), "has an array `arr_0`, and a field has c, B, Q"),
        (pair().numbers("B", "(2,)", &[1.0, 2.0]), "has an array B of 2, and with 2 variables it is (2, 2)"),
        (
            pair().numbers("Q", "(2, 2)", &ROTATED),
            "has an array Q of 2 x 2, and with 2 variables it is (2, 2, 2), (2, 4) or (2, 3)",
        ),
        (
            Npz::new().numbers("c", "(1,)", &[f64::NAN]),
            "has an array c, and a coefficient of component 0 is not finite",
        ),
        (pair().words("names", "(1,)", &["x"]), "has 1 names and 2 variables"),
        (pair().words("names", "(2,)", &["x", "eps"]), "eps"),
        (pair().words("order", "()", &["F"]), "has the order `F`"),
        (pair().numbers("names", "(2,)", &[1.0, 2.0]), "has an array names, and its entries are no words"),
        (pair().with("B", "<c16", "(2, 2)", vec![0; 64]), "has an array B, and its numbers are no floats"),
        (pair().numbers("B_data", "(1,)", &[1.0]), "has a sparse B without one of"),
        (
            pair().numbers("B_data", "(1,)", &[1.0]).numbers("B_indices", "(1,)", &[2.0]).numbers(
                "B_indptr",
                "(3,)",
                &[0.0, 1.0, 1.0],
            ),
            "has a sparse B that is not in row format (csr)",
        ),
    ] {
        let said = file.refusal();
        assert!(said.contains(reason) && said.contains("model.npz"), "{said}");
    }
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("text.npz");
    std::fs::write(&path, "xdot = x;").expect("a file");
    let said = refusal(&["show", "--file", path.to_str().expect("a path of letters")]);
    assert!(said.contains("text.npz is no file of np.savez"), "{said}");
}

#[test]
fn files_of_other_kinds_are_refused_with_the_way_to_read_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let savez = "np.savez(\"F.npz\", c=c, B=B, Q=Q)";
    for (name, bytes, reason) in [
        ("mine.xml", &b"<?xml version='1.0'?><sbml/>"[..], "kahan.read(\""),
        ("mine.SBML", b"<sbml/>", "kahan.read(\""),
        ("latin.xml", b"<sbml name='\xe9'/>", "kahan.read(\""),
        ("mine.ant", b"J0: A -> B; k*A", "kahan.read(\""),
        ("arr.npy", b"\x93NUMPY\x01\x00v\x00", savez),
        ("model.dat", b"\xff\xfe", savez),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).expect("a file");
        let file = path.to_str().expect("a path of letters");
        let of_file = || refusal(&["orbit", "--file", file, "--eps", "0.1", "--steps", "1"]);
        let said = of_file();
        assert!(said.contains(reason) && said.contains(name), "{said}");
        std::fs::remove_file(&path).expect("the file");
        let said = of_file();
        assert!(said.contains("cannot read the file"), "{said}");
    }
}
