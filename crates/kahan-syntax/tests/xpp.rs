//! Tests XPP files: the parts that are supported, and the parts that are refused by name.

use kahan_syntax::diagnostics::Diagnostics;
use kahan_syntax::lenient::read;
use kahan_syntax::parse::parse;
use kahan_syntax::rational::Rational;

fn mistake(text: &str) -> String {
    let read = read(text);
    let mut diagnostics = Diagnostics::default();
    let _ = parse(&read.lexed.tokens, &mut diagnostics);
    diagnostics.finish().first().map_or_else(|| read.canonical(), |first| first.message.clone())
}

fn canonical(text: &str) -> String {
    let found = read(text);
    let mut diagnostics = Diagnostics::default();
    let _ = parse(&found.lexed.tokens, &mut diagnostics);
    assert_eq!(diagnostics.finish(), [], "{text}");
    found.canonical().replace('\n', " ")
}

fn values(list: &[(String, Rational)]) -> String {
    let one = |(name, value): &(String, Rational)| format!("{name}={value}");
    list.iter().map(one).collect::<Vec<_>>().join(" ")
}

#[test]
fn a_file_is_read() {
    let text = "# neuron\n\" {I=.5}\npar I=.5, e=.08 a=.7\nnumber b=.8\np c=-.25e1\n!d=a/2\ni v=-1\nw(0)=1\n\
                v'=c*v - w + I\nw'=e*(v+a-\\\n  b*w)*d\naux energy=v^2+w^2\n@ total=10,dt=.05\n@ xplot=v\ndone\nbehind it $ anything";
    assert_eq!(canonical(text), "vdot = c*v - w + I; wdot = e*(v+a- b*w)*(a/2);");
    let read = read(text);
    assert_eq!(values(&read.parameters), "I=1/2 e=2/25 a=7/10 b=4/5 c=-5/2");
    assert_eq!(values(&read.start), "v=-1 w=1");
    assert_eq!(read.notes[0], "`energy` is not read: no equation needs it");
}

#[test]
fn functions_of_the_file_are_put_in() {
    for (text, expected) in [
        ("f(x)=x*(1-x)\ny'=f(y)", "ydot = ((y)*(1-(y)));"),
        ("f(x,k)=k*x\ng(x)=f(x+1, 2)-x\ny'=g(z)\nz'=f(z,a)", "ydot = (((2)*((z)+1))-(z)); zdot = ((a)*(z));"),
        // The argument `y` of `f` must not be confused with the state `y` in `q`.
        ("q = y*a\nf(y)=y + q\nx'=f(x)\ny'=x", "xdot = ((x) + (y*a)); ydot = x;"),
        ("r = f(y) + 1\nf(x)=2*x\ny'=r", "ydot = ((2*(y)) + 1);"),
    ] {
        assert_eq!(canonical(text), expected, "{text}");
    }
    assert!(mistake("f(x,k)=k*x\ny'=f(y)").contains("`f` has 2 arguments"));
    assert!(mistake("f(x)=f(x-1)\ny'=f(y)").contains("`f` is defined by itself"));
}

#[test]
fn functions_of_any_size_are_read_or_refused() {
    let doubling = |name: usize| format!("f{name}(x)=f{}(x)+f{}(x)\n", name + 1, name + 1);
    let text = (0..60).map(doubling).collect::<String>() + "f60(x)=x*x\ny'=f0(y)";
    assert!(mistake(&text).contains("too large"));
    let chain = |name: usize| format!("f{name}(x)=f{}(x)\n", name + 1);
    let text = (0..5000).map(chain).collect::<String>() + "f5000(x)=x\ny'=f0(y)";
    assert!(mistake(&text).contains("too large"));
    let text = format!("f(x)=x\ny'={}y{}", "f(".repeat(50_000), ")".repeat(50_000));
    assert!(mistake(&text).contains("too large"));
    assert_eq!(canonical("f(x)=x+1\ny'=f(f(f(y)))"), "ydot = ((((((y)+1))+1))+1);");
}

#[test]
fn other_parts_are_refused_by_name() {
    for (text, part) in [
        ("x'=-x+w\nwiener w\n", "`wiener`"),
        ("x'=-x\nglobal 1 x-1 {x=0;y=2}\ny'=x", "`global`"),
        ("x'=-x*z\nmarkov z 2\n{0} {1}\n{2} {0}\n", "`markov`"),
        ("table h % 101 0 6.2 sin(t)\nx'=-x", "`table`"),
        ("x'=-x\nbdry x-1", "`bdry`"),
        ("x'=y\n0=x+y", "`0 =`"),
        ("x'=-delay(x,1)", "`delay"),
        ("x'=-heav(x)", "`heav"),
        ("x'=if(x>1)then(x)else(-x)", "condition"),
        ("x[1..4]'=-x[j]", "`x[1..4]`"),
        ("volterra v=int{exp(-t)#x}\nx'=v", "`volterra`"),
    ] {
        let found = mistake(text);
        assert!(found.contains(part), "{text}: {found}");
    }
}

#[test]
fn names_of_directives_stay_names() {
    for (text, expected) in [
        ("p' = i\ni' = -p", "pdot = i; idot = -p;"),
        ("r = a + i\nx' = r*x; par a=2", "xdot = (a + i)*x;"),
        ("number' = -global*number", "numberdot = -global*number;"),
    ] {
        assert_eq!(canonical(text), expected, "{text}");
    }
}
