//! Tests the macro's error messages, as rustc prints them.
//!
//! Every mistake must give one error, at the tokens to change. The expected output is beside each
//! file, and `TRYBUILD=overwrite` renews it.

#[test]
fn every_mistake_is_explained_once_at_its_place() {
    let cases = trybuild::TestCases::new();
    for files in ["tests/compile_errors/*.rs", "tests/compile_errors/*/*.rs"] {
        cases.compile_fail(files);
    }
}
