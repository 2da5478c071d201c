//! The table of the exact orbits, whose heights the figures show.

use maud::{Markup, html};

use super::super::found::Orbits;
use super::super::text::grouped;
use super::orbit::{Heights, Orbit};
use kahan_draw::decimal;
use kahan_paper::figures::Figure;

pub(super) fn table(orbits: &Orbits<'_>) -> Markup {
    let rows = Figure::all().filter_map(|figure| Orbit::of(orbits, figure));
    html! {
        h3 #orbits { "All orbits" }
        div.scroll tabindex="0" {
            table {
                caption { "Every exact orbit computed for this page; growth and digits are those of its largest component" }
                thead { tr {
                    th scope="col" { "Orbit" } th scope="col" { "Largest" } th scope="col" { "Growth of " i { "h" } }
                    th.number scope="col" { "last " i { "h" } } th.number scope="col" { "digits" }
                    th.number scope="col" { "last ratio" }
                } }
                tbody {
                    @for orbit in rows {
                        @let heights = Heights(orbit.measured.survey.component(orbit.measured.survey.largest()));
                        tr {
                            th scope="row" { (orbit.data()) }
                            td { i { (orbit.largest()) } }
                            td { (orbit.measured.survey.growth) }
                            td.number { (decimal(heights.last().1, 2)) }
                            td.number { (grouped(orbit.digits(orbit.largest()))) }
                            td.number { (decimal(heights.last_ratio(), 4)) }
                        }
                    }
                }
            }
        }
    }
}
