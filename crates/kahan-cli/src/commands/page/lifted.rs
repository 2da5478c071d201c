//! The page of a lifted field. The lift depends on the initial point, so the field's text gives it.

use kahan_draw::answer;
use kahan_draw::picture::{PictureOptions, relations};
use maud::{Markup, html};

use super::super::command_line::CommandLine;
use super::super::image_options::usual;
use super::figures::{Subject, figure};
use super::{Page, with_values};
use crate::printing::{UsageError, joined};
use crate::reading::{Block, Source};

impl Page {
    /// Returns the source and its block. If a lifted field has no initial point, one is inserted.
    pub(super) fn with_chosen_start(&self, block: &Block) -> Result<(Source, Block), UsageError> {
        let as_given = (self.source.clone(), block.clone());
        let study = self.source.study_of_block(block, self.at.as_deref())?;
        if study.lift().is_none_or(|lift| lift.order() == 0) {
            return Ok(as_given);
        }
        let study = with_values(&self.source, block, &study).study_to_show(block, self.at.as_deref())?;
        let Some(start) = study.lift_start().filter(|_| study.start().is_none()) else {
            return Ok(as_given);
        };
        let texts = block.with_start(study.coordinates(), &start);
        let begun = texts.into_iter().find_map(|text| {
            let begun = Block::of_text(text.clone(), "--field".to_owned());
            let source = self.source.clone().with_text(text);
            let read = source.study_of_block(&begun, None).ok()?;
            (read.lift_start().as_ref() == Some(&start)).then_some((source, begun))
        });
        Ok(begun.unwrap_or(as_given))
    }
}

impl Subject<'_> {
    /// Returns the equations before and after the lift, and the errors of the relations.
    pub(super) fn lift(&self, written: &str) -> Markup {
        let (eps, start) = (&self.shown.eps, joined(&self.shown.start, ","));
        let found = match self.valued.study.lift_found(Some(eps.to_f64())) {
            Ok(found) => found.expect("the field was lifted"),
            Err(why) => return html! { p.missing { "Left out: " (UsageError::from(why).message()) } },
        };
        let line = CommandLine::new("lift", &self.valued.words).with("--eps", eps).with("--at", start);
        let drawn = relations(&found, &PictureOptions::on(usual()));
        let drawn = drawn.ok_or_else(|| UsageError::new("there is no orbit to follow.")).map(|picture| {
            let words = html! {
                "The error of each relation along the first orbit. What is kept or bounded stays level; a drift is a line that rises "
                "like log t, and what grows at a rate is a straight line."
            };
            (picture.drawing, Vec::new(), words)
        });
        html! {
            h4 { "Equations as written" }
            pre tabindex="0" { code { (written.trim()) } }
            (answer::lift(&found))
            (figure("relations", "Errors of the relations", &line.with("--out", "relations.svg"), drawn))
        }
    }
}
