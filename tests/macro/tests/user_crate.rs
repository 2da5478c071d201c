//! Tests user crates that cargo builds with kahan-core as their only dependency.
//!
//! `cargo test -p kahan-macro-tests -- --ignored` runs these tests. The user crates share the
//! target folder of the compile-error cases, so dependencies are compiled once.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Once;
use std::{env, fs};

/// The flags that trybuild passes to rustc. With other flags, cargo recompiles every dependency.
const FLAGS: &str = r#"build.rustflags=["--cfg","trybuild","--verbose","-A","dead_code"]"#;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/user_crates")
}

fn cargo(arguments: &[&str]) -> String {
    // Trybuild compiles in the folder `tests/trybuild` of the target folder.
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("tests").join("trybuild");
    // Copy the lock file once, so that no cargo process reads an incomplete file.
    static LOCK_FILE: Once = Once::new();
    LOCK_FILE.call_once(|| {
        let lock = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../Cargo.lock");
        fs::copy(lock, folder().join("Cargo.lock")).expect("the workspace has a lock file");
    });
    let output = Command::new(env!("CARGO"))
        .args(["--offline", "--config", FLAGS])
        .args(arguments)
        // The target is named as by trybuild. Otherwise cargo compiles all dependencies again.
        .args(["--target", "host-tuple"])
        .current_dir(folder())
        .env("CARGO_TARGET_DIR", target)
        .env("CARGO_INCREMENTAL", "0")
        .env_remove("RUSTFLAGS")
        .output()
        .expect("cargo runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "cargo {arguments:?}\n{errors}");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
#[ignore = "compiles kahan-core once more; .ci/run runs it"]
fn crates_of_users_run() {
    cargo(&["run", "--quiet", "--package", "renamed"]);
    cargo(&["run", "--quiet", "--package", "edition_2021"]);
}

#[test]
fn a_program_over_floats_contains_no_big_integers() {
    let program = |package: &str| {
        cargo(&["tree", "--package", package, "--edges", "normal,no-proc-macro", "--prefix", "none"])
    };
    assert!(!program("edition_2021").contains("num-bigint"));
    assert!(!program("without_std").contains("num-bigint"));
    assert!(program("renamed").contains("num-bigint"));
}
