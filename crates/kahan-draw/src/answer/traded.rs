//! Shows integrator settings with their errors and their computing time per unit of simulated time.

use kahan_study::trade::{Choice, Measured, Traded};
use maud::{Markup, html};

use crate::document::Table;
use crate::picture::{self, PictureOptions};

pub(super) fn html(traded: &Traded) -> Markup {
    html! {
        figure #trade {
            div.drawings { (picture::trade(traded, &PictureOptions::on(picture::trade_canvas())).drawing.inline()) }
            figcaption { p { "Each dot is a setting: its price on this machine, and its error against a trajectory in 32 digits." } }
        }
        @match choice(traded) {
            Some([words, rust]) => { p { "The cheapest that does: " (words) "." } pre { code { (rust) } } },
            None => p.missing { "No setting that was measured reaches the tolerance." },
        }
        (front(traded))
    }
}

/// Returns the chosen setting in words and as Rust code. Returns `None` if no setting meets the
/// tolerance.
#[must_use]
pub fn choice(traded: &Traded) -> Option<[String; 2]> {
    let Choice { setting: choice, rust } = traded.choice.as_ref()?;
    let words = format!(
        "{}, eps = {:?}: {} ns per unit of time, {} {:.1e}",
        choice.setting.scheme(),
        choice.setting.eps(),
        price(choice),
        traded.error_name(),
        choice.error()
    );
    Some([words, rust.clone()])
}

type Error = fn(&Measured) -> Option<f64>;

const ERRORS: [(&str, Error); 3] = [
    ("trajectory", |measured| measured.trajectory_error),
    ("integrals", |measured| measured.integral_drift),
    ("return", |measured| measured.return_error),
];

/// Returns the settings that no other setting beats in both time and error, the fastest first.
#[must_use]
pub fn front(traded: &Traded) -> Table {
    let front = || traded.settings.iter().filter(|measured| measured.on_front);
    let is_measured = |(_, error): &&(&str, Error)| front().any(|measured| error(measured).is_some());
    let errors: Vec<&(&str, Error)> = ERRORS.iter().filter(is_measured).collect();
    let rows = front().map(|measured| {
        let scheme = measured.setting.scheme();
        let mut row = vec![
            scheme.precision.name().to_owned(),
            scheme.order().to_string(),
            if scheme.compensated { "yes" } else { "no" }.to_owned(),
            format!("{:?}", measured.setting.eps()),
            price(measured),
        ];
        row.extend(errors.iter().map(|(_, error)| written(error(measured))));
        row
    });
    let headings = ["scalar", "order", "compensated", "eps", "ns per unit time"].into_iter();
    let headings = headings.chain(errors.iter().map(|(heading, _)| *heading));
    Table::new("Settings that no other one beats in price and error together", headings, rows)
}

fn price(measured: &Measured) -> String {
    let price = measured.nanoseconds_per_unit_time;
    if price < 0.1 {
        return format!("{price:.1e}");
    }
    let decimals = if price < 10.0 {
        2
    } else if price < 100.0 {
        1
    } else {
        0
    };
    format!("{price:.decimals$}")
}

fn written(value: Option<f64>) -> String {
    match value {
        Some(value) if value.is_finite() => format!("{value:.1e}"),
        Some(_) => "not finite".to_owned(),
        None => "-".to_owned(),
    }
}
