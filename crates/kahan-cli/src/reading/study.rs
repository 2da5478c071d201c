//! Turns arguments into a [`Study`] of a field. Most messages of a [`UsageError`] name the option
//! to change.

use kahan_algebra::rational::Rational;
use kahan_study::{Axis, Lift, MOST_VARIABLES, Study, StudyError, Subject, Systems};

use super::block::Block;
use super::points::{first_point, points, single_point};
use super::source::{Source, Start};
use crate::printing::{UsageError, warn};

impl Source {
    pub(crate) fn study(&self) -> Result<Study, UsageError> {
        self.study_at(None)
    }

    /// Returns the field with the given parameters. If the field must be lifted to a quadratic one,
    /// the choice among lifts depends on the orbit of the point `at`.
    pub(crate) fn study_at(&self, at: Option<&str>) -> Result<Study, UsageError> {
        self.study_of(self.subject()?, at, &[])
    }

    /// Returns the field like `study_at`; fails if a claim is false. Parameters may lack values.
    pub(crate) fn proved(&self, at: Option<&str>) -> Result<Study, UsageError> {
        self.proved_over(at, &[])
    }

    fn proved_over(&self, at: Option<&str>, axes: &[Axis]) -> Result<Study, UsageError> {
        let study = self.study_of(self.subject()?, at, axes)?;
        study.proved()?;
        study.lift().and_then(Lift::warning).iter().for_each(|note| warn(note));
        Ok(study)
    }

    /// Returns the field of a block that was already read.
    pub(crate) fn study_of_block(&self, block: &Block, at: Option<&str>) -> Result<Study, UsageError> {
        Ok(self.subject_of_block(block, at)?.study(&Systems)?)
    }

    /// Returns the field for display. Without `at`, a lift is chosen along [`Study::shown_orbit`].
    pub(crate) fn study_to_show(&self, block: &Block, at: Option<&str>) -> Result<Study, UsageError> {
        Ok(self.subject_of_block(block, at)?.study_to_show(&Systems)?)
    }

    fn subject_of_block(&self, block: &Block, at: Option<&str>) -> Result<Subject, UsageError> {
        let named = self.system.as_ref().map(Subject::named);
        self.subject_of(named.unwrap_or_else(|| block.subject()), at, &[])
    }

    fn study_of(&self, subject: Subject, at: Option<&str>, axes: &[Axis]) -> Result<Study, UsageError> {
        Ok(self.subject_of(subject, at, axes)?.study(&Systems)?)
    }

    fn subject_of(&self, subject: Subject, at: Option<&str>, axes: &[Axis]) -> Result<Subject, UsageError> {
        let middle = |axis: &Axis| (axis.name.clone(), axis.range.value(axis.range.count() / 2));
        let lifting = self.lifting(at.and_then(first_point), axes.iter().map(middle).collect())?;
        let subject = lifting.into_iter().fold(subject, Subject::lifting);
        let given = self.given()?.into_iter();
        let subject = given.fold(subject, |subject, (name, value)| subject.with(name, value));
        Ok(self.sites.into_iter().fold(subject, Subject::sites))
    }
}

type Points = Vec<Vec<Rational>>;

impl Start {
    pub(crate) fn study(&self) -> Result<(Study, Vec<Rational>, Rational), UsageError> {
        let (study, starts, eps) = self.starts()?;
        Ok((study, single_point(starts, self.at.as_deref())?, eps))
    }

    pub(crate) fn starts(&self) -> Result<(Study, Points, Rational), UsageError> {
        let study = self.source.proved(self.at.as_deref())?;
        let starts = points(self.at.as_deref(), &study)?;
        study.values()?;
        Ok((study, starts, self.step.half()?.ok_or(StudyError::MissingStep)?))
    }

    /// Returns the field, its initial point, and ε. Fails if an option fixes a quantity on `axes`.
    pub(crate) fn study_over(
        &self,
        axes: &[Axis],
    ) -> Result<(Study, Vec<Rational>, Option<Rational>), UsageError> {
        let (study, starts, eps) = self.starts_over(axes)?;
        Ok((study, single_point(starts, self.at.as_deref())?, eps))
    }

    /// Returns the field, the initial points, and ε. Fails if an option sets what `axes` vary.
    pub(crate) fn starts_over(&self, axes: &[Axis]) -> Result<(Study, Points, Option<Rational>), UsageError> {
        let study = self.source.proved_over(self.at.as_deref(), axes)?;
        self.source.leaves_free(axes, &self.step)?;
        let starts = points(self.at.as_deref(), &study)?;
        Ok((study, starts, self.step.half()?))
    }
}

/// Writes an option and its value as in a command line.
pub(crate) fn option(name: &str, value: &str) -> String {
    format!("--{name} {value}").trim_end().to_owned()
}

impl From<StudyError> for UsageError {
    fn from(error: StudyError) -> Self {
        UsageError::new(match error {
            StudyError::Field(mistakes) => return UsageError::reports(mistakes.to_string()),
            StudyError::UnknownSystem { name, nearest, known } => {
                let hint = nearest.map_or_else(String::new, |name| format!(" Did you mean `{name}`?"));
                let names = known.join(", ");
                format!(
                    "there is no system `{name}`.{hint} The catalog has {names}; --field TEXT takes a field of your own."
                )
            }
            StudyError::NoFamily => {
                "--sites is for a family, `for i in periodic { x[i]dot = …; }`, and this field has its equations written out"
                    .to_owned()
            }
            StudyError::ManySites { sites } => format!(
                "--sites {sites}: the command writes a chain out, up to {MOST_VARIABLES} variables; longer ones are stepped by \
                 `kahan orbit --start …`, and by `kahan!` in a program, for any number of sites"
            ),
            StudyError::LargeMatrices { variables, most } => format!(
                "the matrices of {variables} variables are not written out, which goes up to {most}; --macro shows the block alone, \
                 or show a family of the same equations at fewer sites"
            ),
            StudyError::UnknownParameter { .. } => format!("--param: {error}"),
            StudyError::ParameterTwice { name } => format!("--param: `{name}` is given twice"),
            StudyError::MissingParameters { system, names } => {
                let options: Vec<String> = names.iter().map(|name| format!("--param {name}=VALUE")).collect();
                format!("{system} needs a value for each of its parameters: add {}", options.join(" "))
            }
            StudyError::UnknownAxis { .. } | StudyError::AxisTwice { .. } => format!("--over: {error}"),
            error @ StudyError::Formula { .. } => return UsageError::reports(error.spelled(option)),
            StudyError::ConstantPlane { text } => format!(
                "--plane {text}: the formula is one number everywhere; a section is where a formula of the variables vanishes, as in \
                 --plane 'x - 1/2'"
            ),
            StudyError::MissingSteps => "how far? give --steps N, or --crossings K, or both: an orbit ends at the first of them".to_owned(),
            StudyError::MissingStep => format!("{error}: add --eps E, as in --eps 0.1, or --dt T, the time step, 2 eps"),
            StudyError::NoAxis => "which values? give a range to a parameter or to eps, FROM:TO:+STEP, as in --param xi=-2:2:+1/12 \
                 or --eps 1/4:2:+1/4"
                .to_owned(),
            StudyError::NoIntegral { system } => format!(
                "--color drift: {system} claims no integral that could drift; claim one in the field (`integral H = …;`), as `kahan \
                 discover` prints them"
            ),
            other => other.spelled(option),
        })
    }
}
