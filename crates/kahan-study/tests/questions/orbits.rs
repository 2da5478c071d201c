//! Questions about orbits, crossings and cycles.

use std::sync::Mutex;

use kahan_study::{Answer, End, StudyError, Subject, Unwatched};
use serde_json::{Value, json};

use super::{Clock, Listening, answer, question, study};

#[test]
fn what_orbits_do() {
    let away = study(Subject::text("xdot = x^2 + 1;"));
    let observed =
        answer(&away, json!({"ask": "observe", "eps": "1/20", "at": [0], "steps": 100, "escape": 5}));
    assert!(observed["escaped"].as_u64().is_some_and(|step| step < 20), "{observed}");
    let turning = study(Subject::text("xdot = y; ydot = -x; integral E = x^2 + y^2;"));
    let asked = json!({"ask": "observe", "eps": "1/20", "at": [1, 0], "steps": 10_000});
    let observed = answer(&turning, asked.clone());
    // Each step turns by an angle; the tangent of half this angle is ε.
    let turns = 0.05_f64.atan() / std::f64::consts::PI;
    // Clockwise rotation is negative. The tolerance is one rounding error for each of 10⁴ steps.
    let value = observed["rotation"]["x"]["value"].as_f64().expect("a number");
    assert!((value + turns).abs() < 1e4 * f64::EPSILON * turns, "{observed}");
    assert!(observed["drift"]["E"]["max"].as_f64().is_some_and(|drift| drift < 1e-11), "{observed}");
    assert_eq!(observed["extrema"]["y"].as_array().map(Vec::len), Some(2));
    let stopped =
        Listening { clock: Clock::default(), heard: Mutex::new(vec![String::new()]), stops_at_first: true };
    let Ok(Answer::Observe(part)) = turning.ask(&question(asked).expect("a question"), &stopped) else {
        panic!("observations")
    };
    assert!(matches!(part.end, End::Stopped(steps) if steps == part.steps && steps < 10_000));
}

/// The flow of ẋ = y, ẏ = −x turns clockwise, so y rises through 0 at x = −1.
#[test]
fn crossings_of_a_plane() {
    let turning = study(Subject::text("xdot = y; ydot = -x;"));
    let asked =
        json!({"ask": "section", "eps": "1/100", "at": [1, "1/2"], "steps": 1000, "plane": "y", "points": 2});
    let found = answer(&turning, asked);
    let points = found["points"].as_array().expect("points");
    assert_eq!((points.len(), found["times"].as_array().map(Vec::len)), (2, Some(2)));
    let x = points[0][0].as_f64().expect("a number");
    assert!((x + 1.25_f64.sqrt()).abs() < 1e-3, "{found}");
}

/// Tests the fixed point (1, 1) of the Lotka–Volterra map, and the fold of x = ±√a at a = 0.
#[test]
fn cycles_and_their_branches() {
    let lv = study(Subject::named("lv"));
    let found = answer(&lv, json!({"ask": "periodic", "eps": "1/10", "at": ["0.9", "1.1"]}));
    assert_eq!((&found["period"], &found["stability"]), (&json!(1), &json!("neutral")));
    assert_eq!(found["exact"]["points"], json!([["1", "1"]]));
    assert!(found.get("branch").is_none(), "{found}");
    let fold = study(Subject::text("xdot = a - x^2;"));
    let over = json!({"a": "1:-1:41"});
    let found = answer(&fold, json!({"ask": "periodic", "eps": "1/10", "at": [1], "over": over}));
    assert_eq!(found["branch"]["turns"][0]["change"], "fold, two steady states meet");
    let error =
        |object: Value| fold.ask(&question(object).expect("a question"), &Unwatched).expect_err("a mistake");
    let other = json!({"b": "1:-1:41"});
    assert!(matches!(
        error(json!({"ask": "periodic", "eps": 1, "at": [1], "over": other})),
        StudyError::UnknownAxis { .. }
    ));
    assert!(matches!(
        error(json!({"ask": "periodic", "at": [1], "period": 2, "over": over})),
        StudyError::MissingStep
    ));
    assert!(matches!(
        error(json!({"ask": "periodic", "eps": 1, "at": [1], "period": 601, "over": over})),
        StudyError::LongCycle { .. }
    ));
}

#[test]
fn an_orbit_diagram_shows_what_is_left_after_the_transient() {
    // At ε = 1/10, each step multiplies the distance to the fixed point a by 9/11.
    let sink = study(Subject::text("xdot = a - x; ydot = -y;"));
    let asked = json!({
        "ask": "diagram", "eps": "1/10", "at": [7, 1], "over": {"a": "0:2:3"},
        "transient": 400, "steps": 2,
    });
    let found = answer(&sink, asked.clone());
    assert_eq!(found["values"], json!(["0", "1", "2"]));
    assert_eq!([&found["variable"], &found["axis"]], [&json!("x"), &json!("a")]);
    assert_eq!(found["ended"], 0);
    assert!(found["points"][2].as_array().is_some_and(|points| points.len() == 3), "{found}");
    assert!((found["points"][2][0].as_f64().expect("a number") - 2.0).abs() < 1e-14, "{found}");
    let of = |changed: &str, value: Value| {
        let mut asked = asked.clone();
        asked[changed] = value;
        question(asked).map(|asked| sink.ask(&asked, &Unwatched).map(|answer| json!(answer)))
    };
    let short = of("transient", json!(0)).expect("a question").expect("an answer");
    let exact = [7.0, 2.0 + 5.0 * 9.0 / 11.0, 2.0 + 5.0 * 81.0 / 121.0];
    for (i, x) in exact.into_iter().enumerate() {
        let shown = short["points"][2][i].as_f64().expect("a number");
        assert!((shown - x).abs() < 1e-14, "{short}");
    }
    let y = of("variable", json!("y")).expect("a question").expect("an answer");
    assert!(y["points"][0][0].as_f64().is_some_and(|y| y > 0.0 && y < 1e-30), "{y}");
    for (changed, value, said) in [
        ("variable", json!("q"), "`q` is no variable of field; there is x, y"),
        ("over", json!({"b": "0:1:3"}), "`b` is no parameter of field; there is a, eps"),
    ] {
        let refused = of(changed, value).expect("a question").expect_err("a mistake");
        assert_eq!(refused.to_string(), said);
    }
    let over_eps = of("over", json!({"eps": "1/10:1/5:2"})).expect("a question");
    assert!(over_eps.is_err_and(|error| matches!(error, StudyError::MissingParameters { .. })));
}
