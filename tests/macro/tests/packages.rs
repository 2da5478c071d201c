//! Tests the packages as users get them: unpacked outside of the repository, with a user's program.
//!
//! The program runs the example of the packed README, and cargo may read no file of the repository.
//! `cargo test -p kahan-macro-tests --test packages -- --ignored` runs this test. Usual runs skip
//! it, because it compiles everything again.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, process};

const UNPUBLISHED: [&str; 6] = [
    "kahan-core-tests",
    "kahan-macro-tests",
    "kahan-python",
    "kahan-python-benchmarks",
    "kahan-sweep",
    "kahan-tests",
];

/// The packages that `kahan-core` depends on.
const OF_THE_CORE: [&str; 7] = [
    "kahan-algebra",
    "kahan-core",
    "kahan-derive",
    "kahan-emit",
    "kahan-lift",
    "kahan-program",
    "kahan-syntax",
];

const CARRIED: [&str; 4] = ["Cargo.toml", "LICENSE-APACHE", "LICENSE-MIT", "README.md"];

fn run(command: &mut Command) {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{errors}");
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder of ours");
    entries.map(|entry| entry.expect("a readable folder").path()).collect()
}

fn unpacked(workspace: &Path, folder: &Path) -> Vec<PathBuf> {
    let target = folder.join("packing");
    run(Command::new(env!("CARGO"))
        .args(["package", "--offline", "--no-verify", "--allow-dirty", "--workspace"])
        .args(UNPUBLISHED.map(|name| format!("--exclude={name}")))
        .arg("--target-dir")
        .arg(&target)
        .current_dir(workspace));
    let crates = folder.join("crates");
    fs::create_dir_all(&crates).expect("a folder of ours");
    let packed = entries(&target.join("package")).into_iter();
    for archive in packed.filter(|path| path.extension().is_some_and(|extension| extension == "crate")) {
        run(Command::new("tar").arg("-xzf").arg(archive).arg("-C").arg(&crates));
    }
    entries(&crates)
}

fn example(readme: &str) -> &str {
    let (_, block) = readme.split_once("```rust\n").expect("an example");
    block.split_once("```").expect("its end").0
}

#[test]
#[ignore = "compiles everything once more"]
fn a_program_needs_nothing_but_the_packages() {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("a workspace");
    let folder = env::temp_dir().join(format!("kahan-packages-{}", process::id()));
    let crates = unpacked(workspace, &folder);
    assert_eq!(crates.len(), 21, "{crates:?}");

    let mut manifest = "[package]\nname = \"user\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n\
                        [dependencies]\nkahan-core = \"0.1\"\n\n[patch.crates-io]\n"
        .to_owned();
    let mut program = None;
    for path in crates {
        for name in CARRIED {
            let file = path.join(name);
            let carried = fs::symlink_metadata(&file).is_ok_and(|metadata| metadata.is_file());
            assert!(carried, "{} is missing, or a link", file.display());
        }
        let name = path.file_name().and_then(|name| name.to_str()).expect("a name");
        let (name, _version) = name.rsplit_once('-').expect("a name and a version");
        if name == "kahan-core" {
            program = Some(read(&path.join("README.md")));
        }
        // Patch only used packages, since cargo warns about the others.
        if OF_THE_CORE.contains(&name) {
            manifest += &format!("{name} = {{ path = {path:?} }}\n");
        }
    }

    let user = folder.join("user");
    fs::create_dir_all(user.join("src")).expect("a folder of ours");
    fs::write(user.join("Cargo.toml"), manifest).expect("a file of ours");
    let program = program.expect("a package of kahan-core");
    fs::write(user.join("src/main.rs"), format!("fn main() {{\n{}}}\n", example(&program)))
        .expect("a file of ours");
    fs::copy(workspace.join("Cargo.lock"), user.join("Cargo.lock")).expect("the workspace has a lock file");
    run(Command::new(env!("CARGO"))
        .args(["run", "--offline"])
        .current_dir(&user)
        .env("CARGO_TARGET_DIR", user.join("target"))
        .env_remove("RUSTFLAGS"));

    // The file lists all files that cargo read for the program.
    let files = read(&user.join("target/debug/user.d"));
    let ours = workspace.to_str().expect("a path in UTF-8");
    assert!(files.contains("kahan-core"), "{files}");
    assert!(!files.contains(&format!("{ours}/")), "{files}");
    fs::remove_dir_all(&folder).expect("a folder of ours");
}
