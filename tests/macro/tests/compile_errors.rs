//! The macro's error messages, as printed by rustc.
//!
//! Each file covers a topic, with one mistake per block and a comment above it; the expected output
//! is beside the file. Mistakes that need more than a block have files in the topic's folder. Every
//! mistake gives one error, at the tokens to change and in the user's terms, even where code uses
//! the broken type (`fallback`). `TRYBUILD=overwrite` renews the outputs; review them.

#[test]
fn every_mistake_is_explained_once_at_its_place() {
    let cases = trybuild::TestCases::new();
    for files in ["tests/compile_errors/*.rs", "tests/compile_errors/*/*.rs"] {
        cases.compile_fail(files);
    }
}
