//! Tests that the object of `--json` contains the whole table.

use super::*;

#[test]
fn an_object_has_everything_that_the_table_has() {
    let arguments =
        ["e7", "--param", "xi=2", "--eps", "1/2", "--at", "1,2,1/3", "--steps", "4", "--every", "2"];
    for scalar in ["exact", "f64"] {
        let arguments = with(&arguments, &[]).into_iter().chain(["--scalar", scalar]).collect::<Vec<_>>();
        let (names, rows) = table(&answer(&arguments));
        let json: Vec<&str> = arguments.iter().copied().chain(["--json"]).collect();
        let object_text = answer(&json);
        let object: Value = serde_json::from_str(&object_text).expect("one object");
        assert_eq!(object["system"], "e7");
        assert_eq!(object["variables"], json!(["x", "y", "z"]));
        assert_eq!(
            object["parameters"],
            if scalar == "exact" { json!({"xi": "2"}) } else { json!({"xi": 2.0}) }
        );
        assert_eq!(object["eps"], if scalar == "exact" { json!("1/2") } else { json!(0.5) });
        assert_eq!(object["scalar"], scalar);
        assert_eq!(object["order"], 2);
        assert_eq!((&object["steps"], &object["every"]), (&json!(4), &json!(2)));
        assert_eq!(object["columns"], json!(names));
        assert_eq!(object["stopped"], Value::Null);
        // Texts are compared, because readers of JSON may round numbers.
        let listed: Vec<&str> = object_text.lines().filter(|line| line.starts_with("    [")).collect();
        assert_eq!(object["rows"].as_array().map(Vec::len), Some(rows.len()));
        assert_eq!(listed.len(), rows.len());
        for (listed, row) in listed.iter().zip(&rows) {
            let cells = listed.trim().trim_start_matches('[').trim_end_matches(',').trim_end_matches(']');
            let cells: Vec<&str> = cells.split(',').map(|cell| cell.trim_matches('"')).collect();
            assert_eq!(&cells, row);
        }
    }
}

#[test]
fn with_a_file_the_object_describes_it_and_the_rows_are_there() {
    let folder = folder();
    let file = folder.path().join("e6.csv");
    let arguments = ["e6", "--eps", "0.1", "--at", "1,2,3", "--steps", "3"];
    let more = ["--json", "--out", path_text(&file)].map(str::to_owned);
    let object: Value = serde_json::from_str(&answer(&with(&arguments, &more))).expect("one object");
    assert_eq!(object["out"], path_text(&file));
    assert!(object["rows"].is_null() && object["stopped"].is_null(), "{object}");
    assert_eq!(fs::read_to_string(&file).expect("the file"), answer(&arguments));
}
