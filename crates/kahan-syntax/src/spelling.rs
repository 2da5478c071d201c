//! The spelling of names: keywords, misspellings, derivatives such as `xdot`, and proposed names.

/// The documentation page about fields that are not quadratic, for help texts.
pub const NOT_QUADRATIC: &str = "docs/how-to/not-quadratic.md";

/// The advice that help texts give for fields that are not quadratic.
pub const LIFTS: &str = "`kahan lift`, or `lift=True` in Python, makes a quadratic field of it";

/// The documentation page about notations for equations, to which help texts refer.
pub const ON_TEXTS: &str = "docs/how-to/texts.md";

/// Returns whether a name is `_`, or a strict or reserved keyword of Rust.
#[must_use]
pub fn is_keyword(name: &str) -> bool {
    const KEYWORDS: &str = "_ as async await break const continue crate dyn else enum extern false fn for if \
        impl in let loop match mod move mut pub ref return self Self static struct super trait true type unsafe \
        use where while abstract become box do final gen macro override priv try typeof unsized virtual yield";
    KEYWORDS.split(' ').any(|keyword| keyword == name)
}

/// Returns advice for π, which must be a parameter because it is irrational. Returns `None` for
/// other names.
#[must_use]
pub fn number(name: &str) -> Option<String> {
    matches!(name, "pi" | "PI" | "π").then(|| {
        format!("numbers are exact, and this one is not rational: declare a parameter, `struct Name {{ {name} }}`, and give it the value 3.141592653589793")
    })
}

/// Returns the known name that is closest to `name`, if a misspelling is plausible.
///
/// The distance counts letters that differ and neighbours that are swapped; case is ignored. The
/// distance may be 0 for a name of one letter, 1 for two to four letters, and 2 for longer names.
/// Among equally close names, the first name is returned.
#[must_use]
pub fn nearest<'a, N: AsRef<str>>(name: &str, known: &'a [N]) -> Option<&'a N> {
    let tolerance = match name.chars().count() {
        0..=1 => 0,
        2..=4 => 1,
        _ => 2,
    };
    let distance = |known: &&N| strsim::osa_distance(&name.to_lowercase(), &known.as_ref().to_lowercase());
    known.iter().min_by_key(distance).filter(|nearest| distance(nearest) <= tolerance)
}

/// Returns the first name of `wanted` that is not in use, or else one with a number appended.
///
/// ```
/// use kahan_syntax::spelling::fresh;
///
/// assert_eq!(fresh(&["w", "u"], |name| name == "w"), "u");
/// assert_eq!(fresh(&["w"], |name| name == "w" || name == "w1"), "w2");
/// ```
#[must_use]
pub fn fresh(wanted: &[&str], is_taken: impl Fn(&str) -> bool) -> String {
    let plain = wanted.iter().map(|name| (*name).to_owned());
    let numbered = (1_usize..).flat_map(|k| wanted.iter().map(move |name| format!("{name}{k}")));
    plain.chain(numbered).find(|name| !is_taken(name)).expect("there is always one more")
}

/// Returns advice on how to write a derivative of `state`, with one equation for each order.
#[must_use]
pub fn derivative(state: &str, order: usize, is_taken: impl Fn(&str) -> bool) -> String {
    if order < 2 {
        return format!("write `{state}dot = …` for the derivative of `{state}`");
    }
    let velocity = fresh(&["v", "u", "p"], &is_taken);
    if order == 2 {
        return format!(
            "for the second derivative of `{state}` write `{state}dot = {velocity}; {velocity}dot = …`"
        );
    }
    let next = fresh(&["a", "b", "c"], is_taken);
    format!(
        "write an equation for each derivative of `{state}`: `{state}dot = {velocity}; {velocity}dot = {next}; {next}dot = …`"
    )
}

/// Counts and removes Newton's dots: `ẋ` is `x` with one dot. Returns `None` if there are none.
///
/// ```
/// use kahan_syntax::spelling::without_dots;
///
/// assert_eq!(without_dots("ẋ1"), Some(("x1".to_owned(), 1)));
/// assert_eq!(without_dots("q\u{308}"), Some(("q".to_owned(), 2)));
/// assert_eq!(without_dots("x"), None);
/// ```
#[must_use]
pub fn without_dots(name: &str) -> Option<(String, usize)> {
    const DOTTED_LETTERS: &str =
        "ȧaḃbċcḋdėeḟfġgḣhṁmṅnȯoṗpṙrṡsṫtẇwẋxẏyżzȦAḂBĊCḊDĖEḞFĠGḢHİIṀMṄNȮOṖPṘRṠSṪTẆWẊXẎYŻZ";
    const DOUBLE_DOTTED_LETTERS: &str = "ḧhẗtẅwẍxÿyḦHẄWẌXŸY";
    let plain = |dotted: &str, c: char| {
        let mut letters = dotted.chars();
        std::iter::from_fn(|| Some((letters.next()?, letters.next()?))).find(|(own, _)| *own == c)
    };
    let mut dots = 0;
    let letters = name.chars().filter_map(|c| {
        let found = plain(DOTTED_LETTERS, c)
            .map(|found| (1, found))
            .or_else(|| plain(DOUBLE_DOTTED_LETTERS, c).map(|found| (2, found)));
        match (c, found) {
            ('\u{307}', _) => (dots += 1, None).1,
            ('\u{308}', _) => (dots += 2, None).1,
            (_, Some((count, (_, plain)))) => (dots += count, Some(plain)).1,
            (_, None) => Some(c),
        }
    });
    let letters: String = letters.collect();
    (dots > 0 && !letters.is_empty()).then_some((letters, dots))
}
