use kahan_algebra::lenient;
use kahan_lift::equations::Equations;
use kahan_lift::search::search;

#[test]
fn orders() {
    for (name, text) in [
        ("cubic", "x' = v; v' = -x^3"),
        ("vdp", "x' = y; y' = mu*(1-x^2)*y - x"),
        ("fhn", "v' = v - v^3/3 - w + I; w' = eps1*(v + a - b*w)"),
        ("chua", "x' = alpha*(y - a*x^3 - c*x); y' = x - y + z; z' = -b*y"),
        ("x3", "x' = -x^3"), ("x5", "x' = -x^5"),
        ("hhx4", "x' = p; y' = q; p' = -x - 2*x*y - 4*x^3; q' = -y - x^2 + y^2"),
        ("bruss", "x' = a + x^2*y - b*x - x; y' = b*x - x^2*y"),
        ("pendulum", "x' = v; v' = -sin(x)"),
        ("quintic", "x' = v; v' = -x^5"),
        ("mm", "s' = -k1*e0*s + (k1*s + km)*c; c' = k1*e0*s - (k1*s+km+k2)*c"),
        ("mm2", "s' = -V*s/(K + s); p' = V*s/(K+s)"),
        ("rf", "x' = y*(z - 1 + x^2) + g*x; y' = x*(3*z + 1 - x^2) + g*y; z' = -2*z*(al + x*y)"),
        ("phi4", "x1' = p1; x2' = p2; x3' = p3; p1' = x2 - 2*x1 - x1^3; p2' = x1 + x3 - 2*x2 - x2^3; p3' = x2 - 2*x3 - x3^3"),
        ("driven duffing", "x' = v; v' = -d*v - a*x - b*x^3 + g*cos(w*t)"),
        ("driven pend", "x' = v; v' = -d*v - sin(x) + g*cos(w*t)"),
        ("sir sat", "S' = -b*S*I/(1 + a*I); I' = b*S*I/(1+a*I) - g*I; R' = g*I"),
        ("holling2", "x' = r*x*(1 - x/K) - a*x*y/(1 + h*x); y' = e*a*x*y/(1+h*x) - m*y"),
        ("toggle2", "x' = a/(1 + y^2) - x; y' = b/(1 + x^2) - y"),
        ("toggle4", "x' = a/(1 + y^4) - x; y' = b/(1 + x^4) - y"),
        ("toggle n", "x' = a/(1 + y^n) - x; y' = b/(1 + x^n) - y"),
        ("repr3", "x' = a/(1 + z^2) - x; y' = a/(1 + x^2) - y; z' = a/(1+y^2) - z"),
        ("repr6", "m1' = a/(1 + p3^2) - m1; m2' = a/(1 + p1^2) - m2; m3' = a/(1+p2^2) - m3; p1' = b*(m1-p1); p2' = b*(m2-p2); p3' = b*(m3-p3)"),
        ("kepler", "x' = p; y' = q; p' = -x/(x^2 + y^2)^(3/2); q' = -y/(x^2+y^2)^(3/2)"),
        ("lj", "r' = p; p' = 12/r^13 - 6/r^7"),
        ("morse", "x' = p; p' = -2*(exp(-x) - exp(-2*x))"),
        ("rossler exp", "x' = -y - z; y' = x + a*y; z' = b + z*(exp(x) - c)"),
        ("toda3", "q1' = p1; q2' = p2; q3' = p3; p1' = exp(q3 - q1) - exp(q1 - q2); p2' = exp(q1-q2) - exp(q2-q3); p3' = exp(q2-q3) - exp(q3-q1)"),
        ("abc", "x' = A*sin(z) + C*cos(y); y' = B*sin(x) + A*cos(z); z' = C*sin(y) + B*cos(x)"),
        ("kuramoto3", "a' = w1 + k*(sin(b-a) + sin(c-a)); b' = w2 + k*(sin(a-b) + sin(c-b)); c' = w3 + k*(sin(a-c) + sin(b-c))"),
        ("thomas", "x' = sin(y) - b*x; y' = sin(z) - b*y; z' = sin(x) - b*z"),
        ("sg3", "x1' = p1; x2' = p2; x3' = p3; p1' = x2 - 2*x1 - sin(x1); p2' = x1 + x3 - 2*x2 - sin(x2); p3' = x2 - 2*x3 - sin(x3)"),
        ("dnls3", "a1' = -(b2 + b3) - b1*(a1^2+b1^2); a2' = -(b1+b3) - b2*(a2^2+b2^2); a3' = -(b1+b2) - b3*(a3^2+b3^2); b1' = a2 + a3 + a1*(a1^2+b1^2); b2' = a1+a3 + a2*(a2^2+b2^2); b3' = a1+a2+a3*(a3^2+b3^2)"),
        ("al3", "a1' = -(b2 + b3)*(1+a1^2+b1^2); a2' = -(b1+b3)*(1+a2^2+b2^2); a3' = -(b1+b2)*(1+a3^2+b3^2); b1' = (a2 + a3)*(1+a1^2+b1^2); b2' = (a1+a3)*(1+a2^2+b2^2); b3' = (a1+a2)*(1+a3^2+b3^2)"),
        ("circ3", "x' = y^3; y' = x^3"), ("circ4", "x' = y^4; y' = x^4"), ("circ5", "x' = y^5; y' = x^5"), ("circ6", "x' = y^6; y' = x^6"),
        ("cycle5", "x1' = x2^3; x2' = x3^3; x3' = x4^3; x4' = x5^3; x5' = x1^3"),
        ("bicycle5", "x1' = x2^3 + x5^3; x2' = x3^3 + x1^3; x3' = x4^3 + x2^3; x4' = x5^3 + x3^3; x5' = x1^3 + x4^3"),
        ("bicycle6", "x1' = x2^3 + x6^3; x2' = x3^3 + x1^3; x3' = x4^3 + x2^3; x4' = x5^3 + x3^3; x5' = x6^3 + x4^3; x6' = x1^3 + x5^3"),
        ("hill5", "h' = 5*i^2*s^4; i' = -5*i^2*s^4; s' = 1"),
        ("hill10", "h' = 5*i^2*s^9; i' = -5*i^2*s^9; s' = 1"),
        ("hill15", "h' = 5*i^2*s^14; i' = -5*i^2*s^14; s' = 1"),
        ("x^1.5", "x' = -x^(3/2)"),
        ("tan", "x' = tan(x)"),
        ("double pendulum", "a' = w; b' = u; w' = (-3*sin(a) - sin(a - 2*b) - 2*sin(a-b)*(u^2 + w^2*cos(a-b)))/(3 - cos(2*a - 2*b)); u' = 2*sin(a-b)*(2*w^2 + 2*cos(a) + u^2*cos(a-b))/(3 - cos(2*a-2*b))"),
    ] {
        let read = lenient::read(text);
        let equations = match Equations::read(&read.lexed.tokens) {
            Ok(one) => one,
            Err(mistakes) => { println!("{name}: {}", mistakes[0]); continue }
        };
        let begun = std::time::Instant::now();
        let found = search(&equations.ring, &equations.problem(), 20_000, 0);
        let time = begun.elapsed();
        match found {
            Some(found) => println!("{name}: {} ({} sets, optimal {}) {time:?} {:?}", found.sets[0].len(), found.sets.len(), found.is_optimal, found.sets[0]),
            None => println!("{name}: none {time:?}"),
        }
    }
}
