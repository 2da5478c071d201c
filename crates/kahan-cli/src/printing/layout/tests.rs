//! Tests how tables, labels, matrices and formulas are broken into lines.

use kahan_algebra::render::{folded, lines};

use super::{after_commas, labelled_within, matrix, table_within};

fn rows(cells: &[&[&str]]) -> Vec<Vec<String>> {
    cells.iter().map(|row| row.iter().map(|cell| (*cell).to_owned()).collect()).collect()
}

fn is_within(line: &str, width: usize) -> bool {
    line.chars().count() <= width || !line.trim().contains(' ')
}

#[test]
fn a_table_that_fits_is_left_alone() {
    let table = rows(&[&["n", "h(x)"], &["10", "0.5"]]);
    assert_eq!(table_within(&table, 1, 80), ["n   h(x)", "10  0.5"]);
}

#[test]
fn columns_of_words_give_way_first() {
    let table = rows(&[&["name", "title"], &["e1", "two words and a third of them"]]);
    assert_eq!(table_within(&table, 1, 24), ["name  title", "e1    two words and a", "      third of them"]);
    let table = rows(&[&["n", "ns per unit time"], &["1", "12345678"]]);
    assert_eq!(table_within(&table, 1, 12), ["n  ns per", "   unit time", "1  12345678"]);
}

#[test]
fn columns_that_do_not_fit_come_below_with_the_keys() {
    let table = rows(&[&["n", "aaaaaaaa", "bbbbbbbb", "c"], &["1", "11111111", "22222222", "3"]]);
    let lines = table_within(&table, 1, 20);
    assert_eq!(lines, ["n  aaaaaaaa", "1  11111111", "", "n  bbbbbbbb  c", "1  22222222  3"]);
}

#[test]
fn a_number_wider_than_the_screen_stands_whole_on_its_own_line() {
    let long = "7".repeat(50);
    let table = rows(&[&["n", "x"], &["1", &long]]);
    assert_eq!(table_within(&table, 1, 20), ["n  1".to_owned(), "x".to_owned(), format!("  {long}")]);
    assert_eq!(labelled_within("x_next", &long, 16, 40), ["x_next".to_owned(), format!("  {long}")]);
    let key = rows(&[&["n", "x"], &[&long, "1"]]);
    assert!(table_within(&key, 1, 20).iter().all(|line| is_within(line, 20)));
}

#[test]
fn a_vector_breaks_between_its_entries() {
    assert_eq!(
        labelled_within("x", "(123456, 123456, 123456)", 2, 18),
        ["x   (123456,", "    123456,", "    123456)"]
    );
}

#[test]
fn a_row_of_a_matrix_breaks_between_its_entries() {
    let entries = rows(&[&["1 + x", "22222", "3"], &["4", "5", "66666"]]);
    assert_eq!(
        matrix(&entries, '[', ']', 18),
        ["[ 1 + x  22222", "      3 ]", "[     4      5", "  66666 ]"]
    );
    let wide = rows(&[&["1", &"9".repeat(30)], &["2", "3"]]);
    assert_eq!(matrix(&wide, '[', ']', 18)[3], "  3 ]");
}

#[test]
fn formulas_break_before_a_term() {
    assert_eq!(lines("x~ = a*x + b*y - c*z", 10), ["x~ = a*x", "+ b*y", "- c*z"]);
    assert_eq!(lines("H := a + b", 4), ["H :=", "a", "+ b"]);
    assert_eq!(lines("one  two", 20), ["one  two"]);
    assert_eq!(lines("one  two", 4), ["one", "two"]);
    assert_eq!(lines("", 4), [""]);
}

#[test]
fn folding_keeps_words_and_indents() {
    let text =
        format!("  H = {}\nshort\n", (0..40).map(|k| format!("a{k}*x^2")).collect::<Vec<_>>().join(" + "));
    for width in [20, 40, 80] {
        let folded = folded(&text, width);
        assert!(folded.lines().all(|line| line.chars().count() <= width), "{folded}");
        assert!(folded.ends_with("\nshort\n"));
        let again: Vec<&str> = folded.split_whitespace().collect();
        assert_eq!(again, text.split_whitespace().collect::<Vec<_>>());
    }
}

#[test]
fn a_row_of_a_csv_breaks_after_commas() {
    assert_eq!(after_commas("0,0.125,-3.5,12\n", 9), "0,0.125,\n  -3.5,12\n");
    assert_eq!(after_commas("0,1\n", 9), "0,1\n");
    assert_eq!(after_commas("0,1234567890\n", 9), "0,\n  1234567890\n");
}
