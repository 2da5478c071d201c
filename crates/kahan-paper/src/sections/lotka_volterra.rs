//! Claims of section 1 about the Lotka-Volterra system and its map.

use super::super::claim::Claim;
use super::super::section::Section;
use super::text::read;

/// The integral of the map at ε = ±1, and a function that changes sign in each step.
const INTEGRAL: &str = "
    H_hat := x^2/y^2 + y^2/x^2 + 4*(1/x - 1/y)^2*(1 - x - y);
    I := (x - y)*(x + y - 2)/(x*y);
";

/// The recurrence of the variable x at ε = 1, and the next six values of x.
const ITERATES: &str = "
    r(a, b) := a*(2 - a)/b;
    x1 := r(x, y); x2 := r(x1, x); x3 := r(x2, x1); x4 := r(x3, x2); x5 := r(x4, x3); x6 := r(x5, x4);
";

/// Claims about the flow and the map. `H_hat` is an integral of the map only at ε = ±1.
const CLAIMS: &str = "
field | the Lotka-Volterra flow | f1 = x*(1 - y); f2 = y*(x - 1)
hamilton | Hamilton's equations with {x,y} = x y |
    H := log(x*y) - (x + y); f1 = x*y*d(H, y); f2 = -x*y*d(H, x)
H | H is an integral of the flow | H := log(x*y) - (x + y); f1*d(H, x) + f2*d(H, y) = 0; d(H, x) = 1/x - 1
difference.x | difference equation of x | (next(x) - x)/eps = next(x) + x - next(x)*y - x*next(y)
difference.y | difference equation of y | (next(y) - y)/eps = -next(y) - y + next(x)*y + x*next(y)
matrix | A(x, eps) | A(1,1) = 1 - eps + eps*y; A(1,2) = eps*x; A(2,1) = -eps*y; A(2,2) = 1 + eps - eps*x
rhs | b(x, eps) | b(1) = (1 + eps)*x; b(2) = (1 - eps)*y
determinant | det A, addition | detA = 1 - eps^2 - eps*(1 - eps)*x + eps*(1 + eps)*y
symplectic | the symplectic form as a determinant | J(1,1)*J(2,2) - J(1,2)*J(2,1) = next(x)*next(y)/(x*y)
unit_step | eps = 1: y is the previous x | at(next(y), eps, 1) = x
recurrence | eps = 1: the recurrence of second order | at(next(x), eps, 1)*y = x*(2 - x)
square | H at eps = 1 is 2 + I^2: a pair of conics | H_hat = 2 + I^2; H_hat - 2 - k^2 = (I - k)*(I + k)
    explains B8
exchange | the map exchanges the two conics | at(next(I), eps, 1) = -I; at(next(I), eps, -1) = -I
    explains B8
conics | each conic I = k is rational | X := 2*(1 - m)/(1 - m^2 - k*m); on(I, X, m*X) = k
    explains B8
sum | I(x~) + I(x) has the factor 1 - eps^2, addition |
    next(I) + I = 2*(1 - eps^2)*(eps*(x - y) + x + y - 2)*(eps*(x^2 + y^2 - x - y) - x + y)
        /(x*y*(eps^2*(x - y - 1) + eps*(x + y - 2) - 1)*(eps^2*(x - y + 1) + eps*(x + y - 2) + 1));
    next(H_hat) - H_hat = (next(I) + I)*(next(I) - I)
no_other_step | H is an integral for no other eps |
    a := (eps - 1)*(3*eps + 1)*(3*eps^3 - 5*eps^2 - eps + 1);
    b := (eps + 1)*(3*eps - 1)*(3*eps^3 + 5*eps^2 - eps - 1);
    on(next(H_hat) - H_hat, 1, 3) = 128*eps*(eps^2 - 1)*a/(9*(eps^2 - 2*eps - 1)^2*(3*eps^2 - 2*eps + 1)^2);
    on(next(H_hat) - H_hat, 3, 1) = 128*eps*(eps^2 - 1)*b/(9*(eps^2 + 2*eps - 1)^2*(3*eps^2 + 2*eps + 1)^2);
    (1665*eps^4 + 3885*eps^3 + 1001*eps^2 - 1241*eps - 24)*a
        - (1665*eps^4 - 3885*eps^3 + 1001*eps^2 + 1241*eps - 24)*b = 48
linear | the linear recurrence of order six | x6 - x = (1 - H_hat)*(x4 - x2)
";

pub(super) fn claims() -> Vec<Claim> {
    read(CLAIMS, |id, place, statement| {
        Claim::new(Section::Method, ["section1", "lv", id], "lv", format!("Section 1, {place}"), statement)
            .with_used_definitions(INTEGRAL)
            .with_used_definitions(ITERATES)
    })
}
