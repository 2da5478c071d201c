//! Tests questions about every cell of a grid: their rows, for any number of threads.

use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicU64, Ordering};

use kahan_algebra::rational::Rational;
use kahan_study::{
    Answer, Column, End, LiftCriterion, Observed, Over, Poles, Progress, Question, Rows, StoredColumn, Study,
    StudyError, Subject, Systems, Table, Unwatched, Values, Watch,
};
use serde_json::{Value, json};

fn study(subject: Subject) -> Study {
    subject.study(&Systems).expect("a subject")
}

fn over(object: Value) -> Over {
    let Ok(Question::Over(over)) = serde_json::from_value(object) else { panic!("a question over axes") };
    over
}

/// Returns a question with drawn starts, two orders, both scalars, and cells without an orbit.
fn mixed() -> (Study, Over) {
    let field = "xdot = y/r; ydot = x^2 + r;";
    let over = over(json!({
        "ask": "observe", "steps": 40, "seed": 3, "draws": 5, "starts": [[1, 0], ["1e200", 2]],
        "over": {"r": "-1:1:+1", "eps": ["1/10", 0.2], "order": [2, 4], "scalar": ["f64", "f32"]},
        "observe": [
            "final", "drift", "extrema", "lyapunov", "spectrum", "log_det", "fli", "megno", "sali", "rotation", "escape",
            "passed_poles",
        ],
    }));
    (study(Subject::text(field)), over)
}

struct Few(Table, usize);

impl Rows for Few {
    fn block(&mut self, columns: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        let _ = self.0.block(columns, values);
        if self.0.count() < self.1 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }
}

/// A watch that sets the number of threads, and stops the work after `looks` calls of `look`.
struct Hands {
    threads: usize,
    looks: AtomicU64,
}

impl Hands {
    fn of(threads: usize, looks: u64) -> Self {
        Hands { threads, looks: looks.into() }
    }
}

impl Watch for Hands {
    fn look(&self, _: &Progress<'_>) -> ControlFlow<()> {
        match self.looks.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1)) {
            Ok(_) => ControlFlow::Continue(()),
            Err(_) => ControlFlow::Break(()),
        }
    }

    fn threads(&self) -> usize {
        self.threads
    }
}

fn rows(study: &Study, over: &Over, range: Range<u64>, watch: &dyn Watch) -> (Table, End) {
    let mut table = Table::default();
    let end = study.rows(&Question::Over(over.clone()), range, &mut table, watch).expect("rows");
    (table, end)
}

/// Returns the bits of the values, because NaN differs from itself.
fn bits(table: &Table, cells: Range<usize>) -> Vec<Vec<u64>> {
    let column = |kept: &StoredColumn| match kept {
        StoredColumn::F64(list) => list[cells.clone()].iter().map(|value| value.to_bits()).collect(),
        StoredColumn::Integer(list) => list[cells.clone()].iter().map(|value| *value as u64).collect(),
        StoredColumn::Text(list) => list[cells.clone()].iter().map(|word| word.len() as u64).collect(),
        other => panic!("{other:?}"),
    };
    table.values.iter().map(column).collect()
}

#[test]
fn a_row_depends_on_its_number_alone() {
    let (study, over) = mixed();
    let count = over.cells(&study).expect("cells");
    assert_eq!(count, 2 * 3 * 2 * 2 * 2, "no axis is drawn");
    let (all, end) = rows(&study, &over, 0..count, &Unwatched);
    assert_eq!((all.count() as u64, end), (count, End::Complete));
    for threads in [2, 3] {
        let (other, _) = rows(&study, &over, 0..count + 9, &Hands::of(threads, u64::MAX));
        assert_eq!(bits(&other, 0..count as usize), bits(&all, 0..count as usize), "{threads}");
    }
    for range in [0..1, 5..6, 7..31, 40..48] {
        let own = range.start as usize..range.end as usize;
        let (part, _) = rows(&study, &over, range, &Unwatched);
        assert_eq!(bits(&part, 0..own.len()), bits(&all, own));
    }
    let Answer::Over(found) = study.ask(&Question::Over(over), &Unwatched).expect("an answer") else {
        unreachable!("the answer to this question")
    };
    assert_eq!(bits(&found.rows, 0..count as usize), bits(&all, 0..count as usize));
}

/// With `f64`, each cell with an orbit has the same numbers as the question asked for it alone.
#[test]
fn a_cell_has_what_the_question_answers_there() {
    let (study, over) = mixed();
    let (all, _) = rows(&study, &over, 0..48, &Unwatched);
    let column = |name: &str| {
        let place = all.columns.iter().position(|column| column.name == name).expect(name);
        match &all.values[place] {
            StoredColumn::F64(list) => list.clone(),
            StoredColumn::Integer(list) => list.iter().map(|value| *value as f64).collect(),
            StoredColumn::Text(list) => {
                list.iter().map(|scalar| scalar[1..].parse().unwrap_or(f64::NAN)).collect()
            }
            other => panic!("{other:?}"),
        }
    };
    let [x, y, r, eps, order, bits] = ["x", "y", "r", "eps", "order", "scalar"].map(column);
    let (steps, fli, turns, last) =
        (column("ended_step"), column("fli"), column("rotation_x"), column("final_x"));
    assert_eq!(x[..24], [1.0; 24]);
    assert_eq!(
        (&r[..8], &bits[..3], &order[..3]),
        (&[-1.0; 8][..], &[64.0, 32.0, 64.0][..], &[2.0, 2.0, 4.0][..])
    );
    let (mut compared, mut left) = (0, 0);
    for cell in (0..48).filter(|cell| bits[*cell] == 64.0) {
        if r[cell] == 0.0 {
            assert!(steps[cell] == 0.0 && fli[cell].is_nan());
            continue;
        }
        let Question::Observe(asked) = &*over.question else { unreachable!("it is one") };
        let mut asked = asked.clone();
        let exactly = |value: f64| Rational::parse(&value.to_string()).expect("a number");
        (asked.eps, asked.at) = (exactly(eps[cell]), vec![exactly(x[cell]), exactly(y[cell])]);
        asked.order = order[cell] as u32;
        let own = Subject::text("xdot = y/r; ydot = x^2 + r;").with("r", exactly(r[cell]));
        let observed: Observed = asked.ask(&self::study(own), &Unwatched).expect("an answer");
        let object = json!(observed);
        let number = |of: &Value| of.as_f64().map(f64::to_bits);
        assert_eq!(object["steps"], steps[cell] as u64);
        compared += 1;
        if observed.end.is_early() {
            left += 1;
            assert!([fli[cell], turns[cell], last[cell]].iter().all(|number| number.is_nan()));
            continue;
        }
        for (own, found) in [(&object["fli"], fli[cell]), (&object["rotation"]["x"]["value"], turns[cell])] {
            assert_eq!(number(own), Some(found).filter(|found| found.is_finite()).map(f64::to_bits));
        }
        assert_eq!(number(&object["final"]["x"]), Some(last[cell].to_bits()));
    }
    assert!(compared == 16 && left > 0, "{compared} {left}");
}

#[test]
fn who_watches_or_takes_rows_can_stop_them() {
    let lv = study(Subject::named("lv"));
    let over = over(json!({
        "ask": "observe", "over": {"x": "1/10:2:/4000"},
        "eps": "1/10", "at": [1, 1], "steps": 9, "observe": ["sali"],
    }));
    let (all, _) = rows(&lv, &over, 0..4000, &Unwatched);
    for threads in [1, 2] {
        let (some, end) = rows(&lv, &over, 0..4000, &Hands::of(threads, 7));
        assert!(end == End::Stopped(some.count() as u64) && some.count() < 4000, "{end:?}: {}", some.count());
        if some.count() > 0 {
            assert_eq!(bits(&some, 0..some.count()), bits(&all, 0..some.count()));
        }
    }
    let mut few = Few(Table::default(), 300);
    let end = lv.rows(&Question::Over(over), 0..4000, &mut few, &Unwatched).expect("rows");
    assert!(matches!(end, End::Stopped(_)) && few.0.count() < 1000);
}

#[test]
fn other_questions_have_rows_too() {
    let of = |mut question: Value| {
        question["over"] = json!({"a": [0, 1], "eps": "1/10"});
        let over = over(question);
        let study = study(Subject::text("xdot = y; ydot = 1/a - x^2;"));
        study.ask(&Question::Over(over), &Unwatched)
    };
    let found = of(json!({"ask": "evaluate", "eps": 1, "at": [1, "1/2"]})).expect("an answer");
    let found = json!(found);
    assert_eq!(found["columns"], json!(["index", "a", "next_x", "next_y", "det_A", "det_jacobian"]));
    assert_eq!(found["rows"][0], json!([0, 0.0, null, null, null, null]));
    // The matrix of Kahan's map is A = [[1, −ε], [2εx, 1]], so det A = 1 + 2ε²x.
    assert_eq!(found["rows"][1][4], json!(1.02));
    let found =
        json!(of(json!({"ask": "heights", "eps": 1, "at": [1, "1/2"], "steps": 4})).expect("an answer"));
    assert_eq!((&found["rows"][0][2], &found["rows"][0][3]), (&json!(0), &json!("undefined")));
    assert_eq!(found["rows"][1][2], json!(4));
    // The map of a planar Hamiltonian field preserves an integral and a density.
    let found = json!(of(json!({"ask": "discover"})).expect("an answer"));
    let row = |cell: usize| (&found["rows"][cell][2], found["rows"][cell][6] != json!(""));
    assert_eq!([row(0), row(1)], [(&json!(-1), false), (&json!(1), true)], "{found}");
    let poles = Over::new(Question::Poles(Poles::default()), Vec::new());
    let refused = study(Subject::named("lv")).ask(&Question::Over(poles), &Unwatched).expect_err("no rows");
    assert!(matches!(refused, StudyError::NoRows("poles")), "{refused}");
}

#[test]
fn axes_that_do_not_fit_say_so() {
    let refused = |axes: Value| {
        let over = over(json!({
            "ask": "observe", "eps": 1, "at": [1, 1], "steps": 4, "over": axes, "draws": (1_u64 << 32) + 1,
        }));
        study(Subject::named("lv")).ask(&Question::Over(over), &Unwatched).expect_err("a mistake").to_string()
    };
    for (axes, part) in [
        (json!({"w": [1]}), "`w` is neither a variable nor a parameter of lv; there is x, y, eps"),
        (json!({"order": [2, 3]}), "order: 3 is none of 2, 4, 6, 8"),
        (json!({"scalar": ["f32", "dd"]}), "scalar: dd is none of f64, f32"),
        (json!({"x": {"draw": "uniform", "low": 1, "high": 0}}), "x: low is below high"),
        (
            json!({"x": {"draw": "uniform", "low": 0, "high": 1}, "y": {"draw": "sobol", "low": 0, "high": 1}}),
            "y: Sobol's sequence has 4294967296 points",
        ),
        (json!({"x": "0:1:/100000", "y": "0:1:/1000"}), "100000000 cells"),
    ] {
        let said = refused(axes);
        assert!(said.contains(part), "{part}: {said}");
    }
    let twice = over(json!({"ask": "observe", "eps": 1, "steps": 4, "over": {"y": 1}, "starts": [[1, 2]]}));
    let none = over(json!({"ask": "observe", "eps": 1, "steps": 4, "over": {"y": 1}}));
    for (over, part) in [(twice, "`y` is gone through twice"), (none, "`x` has no first value")] {
        let refused = study(Subject::named("lv")).ask(&Question::Over(over), &Unwatched);
        let said = refused.expect_err("a mistake").to_string();
        assert!(said.contains(part), "{part}: {said}");
    }
}

#[test]
fn rows_of_a_lifted_field_have_all_variables() {
    let lifted = Subject::text("xdot = v; vdot = -sin(x);").lifted(LiftCriterion::default()).study(&Systems);
    let lifted = lifted.expect("a lift");
    assert!(lifted.variables().len() > 2);
    let over_x = json!({"x": [0, "1/2"], "v": [1]});
    for (ask, first) in [
        (json!({"ask": "evaluate", "eps": "1/10", "over": over_x}), "next_"),
        (json!({"ask": "heights", "eps": "1/10", "steps": 2, "over": over_x}), "height_"),
    ] {
        let asked = over(ask.clone());
        let (table, end) = rows(&lifted, &asked, 0..2, &Unwatched);
        let named = table.columns.iter().filter(|column| column.name.starts_with(first)).count();
        assert_eq!((end, table.count(), named), (End::Complete, 2, lifted.variables().len()), "{ask}");
    }
}
