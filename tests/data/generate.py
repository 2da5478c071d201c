#!/usr/bin/env python3
"""Makes the exact vectors of this folder, and shares no line with the Rust code that they test.

    python3 tests/data/generate.py            writes SYSTEM.json and heights.json
    python3 tests/data/generate.py --check    compares instead; exit status 1 where they differ

The orbits of heights.json grow long, so `--check` follows them up to numbers of 12 000 digits and says how far that is;
`--check --all` follows them to their ends in some ten minutes, as writing does.

SYSTEM.json holds the text of a field, `cases`, the first 8 iterates of `orbits`, and `singular` points, where det A = 0.
A case has these keys; a value is null where it is not defined:

    params, eps, x       what is given; a step takes the time 2 eps
    f, field_jacobian    f(x), f'(x)
    A, b, x_next         A x_next = b
    jacobian             the derivative of x_next by x
    det_A, det_jacobian  their determinants
    H_eps, K_eps         integrals of the map, at x
    c                    the conformal factor of Table 1
    volume_density       ρ with det_jacobian ρ(x_next) = ρ(x)
    P, Q                 Tables 3 and 4: J P(x) J^T = P(x_next), and the same of Q/c
    extra_...            true, but not printed in the paper

Kahan's map of a quadratic field f and the formulas for its objects are those of Hone and Petrera, "Three-dimensional
discrete systems of Hirota-Kimura type and deformed Lie-Poisson algebras", as corrected where a line says so. Every
number is an exact rational "p/q" in lowest terms, except keys that end in `_decimal` (50 digits, by mpmath) and the
logarithms of heights.json. Each invariant is checked along a step before it is written. Without mpmath the `_decimal`
values are neither compared nor written.
"""

import json
import sys
from decimal import Context
from fractions import Fraction
from itertools import zip_longest
from math import gcd, lcm, prod
from pathlib import Path

try:
    import mpmath
except ImportError:
    mpmath = None

# The iterates of dE9 have more digits than Python prints unless it is told to.
if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)

FOLDER = Path(__file__).parent
FIELDS = {
    "euler": "pub struct Euler { a1, a2, a3 }\nxdot = a1*y*z;\nydot = a2*z*x;\nzdot = a3*x*y;\n",
    "lv": "pub struct Lv;\nxdot = x*(1 - y);\nydot = y*(x - 1);\n",
    "e1": "pub struct E1;\nxdot = -x^2;\nydot = -x*y;\nzdot = 2*y^2 + x*z;\n",
    "e2": "pub struct E2;\nxdot = -x^2;\nydot = x*y;\nzdot = -2*y^2 + x*z;\n",
    "e3": "pub struct E3;\nxdot = -x*z;\nydot = -y*z;\nzdot = x^2 + y^2;\n",
    "e4": "pub struct E4;\nxdot = -x*z;\nydot = y*z;\nzdot = x^2 - y^2;\n",
    "e5": "pub struct E5;\nxdot = x*y;\nydot = -x^2;\nzdot = y*(2*x - z);\n",
    "e6": "pub struct E6;\nxdot = y*(2*z - x);\nydot = x^2 - z^2;\nzdot = y*(z - 2*x);\n",
    "e7": "pub struct E7 { xi }\nxdot = -x^2;\nydot = -xi*x*y;\nzdot = 2*xi*y^2 + x*z;\n",
    "e8": "pub struct E8;\nxdot = -x^2;\nydot = -x*(x + y);\nzdot = 2*y*(x + y) + x*z;\n",
    "e9": "pub struct E9 { xi }\nxdot = -x*z;\nydot = -xi*y*z;\nzdot = x^2 + xi*y^2;\n",
}

# ε and points of the cases: ordinary ones, zeros, large, small, and far apart.
EPS = "1/2 -1/3 7/2 1/10 -5/4 1 3/7 1/1000 -7/2 9/14 -1 22/7".split()
POINTS = [
    "3/7 11/13 23/47", "7/3 11/13 23/47", "2/5 7/3 11/13", "-3/2 5/4 -7/9", "1/6 -2/3 0", "5/3 0 -4/7", "0 3/5 2/11",
    "1000003/7 -999983/11 123456/5", "1/1000003 -7/999983 3/1000033", "1/3 1000/7 -1/900", "-4/5 -4/5 9/8",
    "17/19 -23/29 31/37",
]
POINTS_OF_LV = [
    "1/2 5/3", "3/7 11/13", "2 -1/3", "-3/2 5/4", "1/6 -2/3", "488/291 1/97", "0 3/5", "1000003/7 -999983/11",
    "1/1000003 -7/999983", "1/3 1000/7", "-4/5 9/8", "17/19 -23/29",
]
PARAMETERS = {
    "euler": [
        "1 2 3", "-1 -1 1", "1 -3 1", "1/2 -2/3 5/4", "2 1 -3", "1 1 1", "-1/7 3/5 2", "1 -1 1/1000", "10 -20 30",
        "3/2 5/7 -11/13", "0 1 2", "1/3 1/5 1/7",
    ],
    "e7": "19/17 -1/2 1 -1 2/3 -7/3 3 19/17 5/2 -1 2 -3".split(),
    "e9": "-1/2 2 1 -1 1/2 -7/3 3 19/17 5/2 0 1 -1".split(),
}
# Parameters, ε, the first point, and where it comes from.
ORBITS = {
    "euler": ("1/2 -2/3 5/4", "1/2", POINTS[0], "not in the paper"),
    "lv": ("", "9/14", POINTS_OF_LV[0], "figure: first 17 iterates of Kahan's Lotka-Volterra map"),
    "e1": ("", "1/2", POINTS[0], "not in the paper"),
    "e2": ("", "1/2", POINTS[0], "not in the paper"),
    "e3": ("", "1/2", POINTS[0], "figure: first 200 iterates of dE3"),
    "e4": ("", "1/2", POINTS[1], "figure: first 125 iterates of dE4"),
    "e5": ("", "1/2", POINTS[0], "not in the paper"),
    "e6": ("", "1/2", POINTS[1], "no figure; same data as dE4"),
    "e7": ("19/17", "1/2", POINTS[0], "figure: first 2000 iterates of dE7, xi = 19/17"),
    "e8": ("", "1/2", POINTS[0], "no figure; same data as dE7"),
    "e9": ("-1/2", "1/2", POINTS[2], "figure: first 11 iterates of dE9, xi = -1/2"),
}
# Parameters, ε and a point with det A = 0.
SINGULAR = {
    "euler": [("1 1 1", "1", "1 0 0")],
    "lv": [("", "1", "1 0")],
    "e1": [("", "1/2", "-1 2/3 5/7"), ("", "1/2", "2 1/3 1/5")],
    "e2": [("", "1/3", "3 2/3 5/7")],
    "e3": [("", "1/2", "0 0 -2")],
    "e4": [("", "1/2", "0 3 -2")],
    "e5": [("", "1/2", "1 -2 4/3")],
    "e6": [("", "1", "1/2 0 1/2")],
    "e7": [("2/3", "1/2", "-3 1/2 1/5")],
    "e8": [("", "1/2", "-1 1/2 1/5")],
    "e9": [("1/2", "1", "0 0 -1")],
}
# How far heights.json follows the orbits above.
HEIGHTS = {"e3": 200, "e4": 125, "e6": 125, "e7": 2000, "e8": 2000, "e9": 11, "lv": 17}


def numbers(text):
    return [Fraction(word) for word in text.split()]


def shown(value):
    """The value as JSON holds it."""
    if isinstance(value, Fraction):
        return f"{value.numerator}/{value.denominator}"
    if isinstance(value, dict):
        return {key: shown(entry) for key, entry in value.items()}
    return [shown(entry) for entry in value] if isinstance(value, list) else value


# Kahan's map: A(x, ε) x' = b(x, ε), where A = I - ε f'(x) and b = x + ε B x + 2ε c.


class Map:
    """The map of a system at parameters and ε. The field f = Q + B + c is evaluated from its text."""

    def __init__(self, system, parameters, eps):
        header, *lines = FIELDS[system].strip().split("\n")
        self.states = [line.split("dot")[0] for line in lines]
        names = header.split("{")[1].split("}")[0].split(",") if "{" in header else []
        self.names = [name.strip() for name in names]
        self.parameters = dict(zip(self.names, parameters))
        sides = ", ".join(line.split("=")[1].rstrip(";") for line in lines).replace("^", "**")
        self.code = compile(f"({sides})", system, "eval")
        self.eps = eps
        if len(parameters) == len(self.names):
            self.find_coefficients()

    def field(self, x):
        return [Fraction(value) for value in eval(self.code, {**self.parameters, **dict(zip(self.states, x))})]

    def find_coefficients(self):
        """c = f(0), B v = (f(v) - f(-v))/2 and Q(u, v) = (f(u + v) - f(u) - f(v) + c)/2 for unit vectors u and v."""
        self.units = [[Fraction(i == j) for j in self.states] for i in self.states]
        self.constant = self.field([0] * len(self.states))
        ahead, behind = [[self.field([sign * v for v in unit]) for unit in self.units] for sign in (1, -1)]
        self.linear = transposed([[(p - q) / 2 for p, q in zip(*ends)] for ends in zip(ahead, behind)])
        both = [[self.field([p + q for p, q in zip(u, v)]) for v in self.units] for u in self.units]
        size = range(len(self.states))
        self.quadratic = [
            [[(both[j][k][i] - ahead[j][i] - ahead[k][i] + self.constant[i]) / 2 for k in size] for j in size] for i in size
        ]

    def derivative(self, x, w=1):
        """w f'(x/w), where f'(x) v = 2 Q(x, v) + B v."""
        return [
            [sum((2 * q * v for q, v in zip(form, x) if q), w * linear) for form, linear in zip(*rows)]
            for rows in zip(self.quadratic, self.linear)
        ]

    def matrix(self, x, eps, w=1):
        """w A(x/w, ε)."""
        derivative = self.derivative(x, w)
        return [[w * unit - eps * entry for unit, entry in zip(*rows)] for rows in zip(self.units, derivative)]

    def right_side(self, x, w=1):
        """w b(x/w, ε)."""
        linear = [sum(entry * value for entry, value in zip(row, x) if entry) for row in self.linear]
        return [value + self.eps * (b + 2 * w * c) for value, b, c in zip(x, linear, self.constant)]

    def step(self, x):
        return [row[0] for row in solve(self.matrix(x, self.eps), [[value] for value in self.right_side(x)])]


def transposed(matrix):
    return [list(row) for row in zip(*matrix)]


def product(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def solve(a, b):
    """X with a X = b, by elimination."""
    rows = [left + right for left, right in zip(a, b)]
    size = len(rows)
    for i in range(size):
        pivot = next(k for k in range(i, size) if rows[k][i] != 0)
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [entry / rows[i][i] if entry else entry for entry in rows[i]]
        for k in range(size):
            if k != i and rows[k][i] != 0:
                rows[k] = [x - rows[k][i] * y if y else x for x, y in zip(rows[k], rows[i])]
    return [row[size:] for row in rows]


def determinant(a):
    """By the first row."""
    if len(a) == 1:
        return a[0][0]
    minors = ([row[:j] + row[j + 1 :] for row in a[1:]] for j in range(len(a)))
    return sum((-1) ** j * a[0][j] * determinant(minor) for j, minor in enumerate(minors))


# What the maps preserve. A function raises ZeroDivisionError where its value is not defined.


def tensor(xy, yz, zx):
    zero = Fraction(0)
    return [[zero, xy, -zx], [-xy, zero, yz], [zx, -yz, zero]]


def xz_y2(x, y, z):
    return x * z + y * y


def half_r2(x, y, z):
    return (x * x + y * y + z * z) / 2


def pair(index, e, point):
    """The objects of dE1 to dE6, where e is ε²: Table 1 (H, K and c), Table 2 (integrals), Table 3 (P) and Table 4 (Q),
    whose third row has 1 - e z² where 1 - ε² z is printed."""
    x, y, z = point
    r, s = x * x + y * y, x * (x * z + 2 * y * y)
    d = {
        1: 1 - e * x * x, 2: 1 - e * x * x, 3: 1 + e * r, 4: 1 + e * r, 5: 1 + e * x * x, 6: 1 - 3 * e * x * z,
    }[index]
    h = {
        1: lambda: y / x, 2: lambda: x * y, 3: lambda: y / x, 4: lambda: x * y, 5: lambda: r / 2, 6: lambda: xz_y2(x, y, z),
    }[index]
    k = xz_y2(x, y, z) if index in (1, 2, 5) else half_r2(x, y, z)
    c = {1: lambda: 1 / x**2, 2: lambda: Fraction(1), 3: lambda: 1 / x**2, 4: lambda: Fraction(1)}.get(index, lambda: Fraction(-1))
    p = {
        1: lambda: (0 * x, y * d, -x * d),
        2: lambda: (0 * x, -y * (1 + e * x * x), -x * d),
        3: lambda: (0 * x, y * d, -x * d),
        4: lambda: (0 * x, -y * (1 - e * (x * x - y * y)), -x * (1 + e * (x * x - y * y))),
        5: lambda: (0 * x, x * (1 - e * y * y), y * d),
        6: lambda: (x * (1 + 3 * e * y * y), z * (1 + 3 * e * y * y), 2 * y * d),
    }[index]
    q = {
        1: lambda: (x, (z + e * s) / d, 2 * y),
        2: lambda: (x * d, z + e * s, 2 * y * d),
        3: lambda: (z, x * (1 - e * z * z) / d, y * (1 - e * z * z) / d),
        4: lambda: (z * d, x * (1 - e * z * z), y * (1 - e * z * z)),
        5: lambda: (x * d, z - e * s, 2 * y * d),
        6: lambda: (
            z + e * x * (x * x + y * y - z * z) * 3 / 2, x + e * z * (z * z + y * y - x * x) * 3 / 2, y * d,
        ),
    }[index]
    is_deformed = index not in (1, 3)
    return {
        "H_eps": lambda: h() / d if is_deformed else h(),
        "K_eps": lambda: k / d,
        "c": c,
        "volume_density": lambda: c() / (h() * k),
        "P": lambda: tensor(*p()),
        "Q": lambda: tensor(*q()),
    }


def ratio_of_gammas(u, xi):
    """Γ(u + ξ/2)/Γ(u + 1 - ξ/2) for an integer ξ, and its derivative by u divided by itself, which is a difference of
    digamma functions: a product of ξ - 1 factors or its inverse."""
    count = int(xi) - 1
    factors = [u + 1 - xi / 2 + j for j in range(count)] if count > 0 else [u + xi / 2 + j for j in range(-count)]
    sign = 1 if count > 0 else -1
    return prod(factors, start=Fraction(1)) ** sign, sign * sum((1 / factor for factor in factors), Fraction(0))


def gammas_decimal(system, point, eps, xi):
    """The transcendental integral of dE7 or dE8 to 50 digits; none where x = 0."""
    if mpmath is None or point[0] == 0:
        return None
    with mpmath.workdps(80):
        def number(value):
            return mpmath.mpf(value.numerator) / value.denominator

        slope, u = number(point[1] / point[0]), number(1 / (2 * eps * point[0]))
        if system == "e8":
            value = slope + mpmath.digamma(mpmath.mpf(1) / 2 + u)
        else:
            xi = number(xi)
            value = slope * mpmath.gammaprod([xi / 2 + u], [1 - xi / 2 + u])
        return mpmath.nstr(value, 50, strip_zeros=False) if value else "0.0"


def of_lv(eps, point):
    x, y = point
    zero = Fraction(0)
    objects = {"volume_density": lambda: 1 / (x * y), "P": lambda: [[zero, x * y], [-x * y, zero]]}
    if eps * eps == 1:
        objects["H_eps"] = lambda: x**2 / y**2 + y**2 / x**2 + 4 * (1 / x - 1 / y) ** 2 * (1 - x - y)
    return objects


def of_euler(e, parameters, point):
    """The integrals and the density, which are not printed in the paper."""
    a, b, c = parameters.values()
    x, y, z = (value * value for value in point)
    in_x, in_y, in_z = 1 - e * b * c * x, 1 - e * c * a * y, 1 - e * a * b * z
    return {"extra_integrals": lambda: [in_y / in_z, in_z / in_x], "extra_volume_density": lambda: 1 / in_z**2}


def of_e7(e, eps, xi, point):
    x, y, _ = point
    d = 1 - e * x * x
    objects = {"volume_density": lambda: 1 / (x * y * d)}
    if xi.denominator == 1:
        objects["H_eps"] = lambda: y / x * ratio_of_gammas(1 / (2 * eps * x), xi)[0]

        def bracket():
            u = 1 / (2 * eps * x)
            return tensor(0 * x, y * d * (-ratio_of_gammas(u, xi)[1] * u - 1), x * d)

        objects["P"] = bracket
    return objects


def of_e8(e, point):
    """The density, which is not printed in the paper."""
    x = point[0]
    return {"extra_volume_density": lambda: 1 / (x * x * (1 - e * x * x))}


def objects_of(kahan, system, point):
    e, xi = kahan.eps**2, kahan.parameters.get("xi")
    if system == "euler":
        return of_euler(e, kahan.parameters, point)
    if system == "lv":
        return of_lv(kahan.eps, point)
    if system == "e7":
        objects = of_e7(e, kahan.eps, xi, point)
        if xi in (1, -1):
            objects["K_eps"] = pair(1, e, point)["K_eps"]
        return objects
    if system == "e8":
        return of_e8(e, point)
    if system == "e9":
        return pair(3 if xi == 1 else 4, e, point) if xi in (1, -1) else {}
    return pair(int(system[1]), e, point)


def value_of(function):
    try:
        return function()
    except ZeroDivisionError:
        return None


def assert_preserved(case, next_objects, x_next):
    """Integrals are equal at both ends of the step, densities and tensors change as they must."""
    jacobian = case["jacobian"]
    after = {key: value_of(function) for key, function in next_objects.items()}
    for key, value in case.items():
        there = after.get(key)
        if value is None or there is None:
            continue
        if key in ("H_eps", "K_eps", "extra_integrals"):
            assert value == there, (key, case)
        if key in ("volume_density", "extra_volume_density"):
            assert case["det_jacobian"] * there == value, (key, case)
        if key == "Q":
            if case["c"] is None:
                continue
            value, there = ([[q / c for q in row] for row in m] for m, c in ((value, case["c"]), (there, after["c"])))
        if key in ("P", "Q"):
            assert product(product(jacobian, value), transposed(jacobian)) == there, (key, case)


def case_of(system, parameters, eps, x):
    kahan = Map(system, parameters, eps)
    matrix, side, x_next = kahan.matrix(x, eps), kahan.right_side(x), kahan.step(x)
    jacobian = solve(matrix, kahan.matrix(x_next, -eps))
    case = {
        "params": kahan.parameters, "eps": eps, "x": x, "A": matrix, "b": side, "x_next": x_next, "jacobian": jacobian,
        "det_A": determinant(matrix), "det_jacobian": determinant(jacobian), "f": kahan.field(x),
        "field_jacobian": kahan.derivative(x),
    }
    objects = objects_of(kahan, system, x)
    case |= {key: value_of(function) for key, function in objects.items()}
    assert_preserved(case, objects_of(kahan, system, x_next), x_next)
    if system in ("e7", "e8"):
        decimal = gammas_decimal(system, x, eps, kahan.parameters.get("xi"))
        if decimal is not None:
            second = {"K_eps": case.pop("K_eps")} if "K_eps" in case else {}
            case |= {"H_eps_decimal": decimal, **second}
    return case


def file_of(system):
    kahan = Map(system, [], Fraction(0))
    lines = zip(PARAMETERS.get(system, [""] * 12), EPS, POINTS_OF_LV if system == "lv" else POINTS)
    parameters, eps, x, source = ORBITS[system]
    start = Map(system, numbers(parameters), Fraction(eps))
    iterates = [numbers(x)]
    for _ in range(8):
        iterates.append(start.step(iterates[-1]))
    singular = []
    for at, its_eps, point in SINGULAR[system]:
        there, point = Map(system, numbers(at), Fraction(its_eps)), numbers(point)
        matrix = there.matrix(point, there.eps)
        assert determinant(matrix) == 0
        entry = {"params": there.parameters, "eps": there.eps, "x": point, "A": matrix}
        singular.append(entry | {"b": there.right_side(point), "det_A": Fraction(0)})
    return shown({
        "system": system, "states": kahan.states, "param_names": kahan.names, "field": FIELDS[system],
        "cases": [case_of(system, numbers(at), Fraction(eps), numbers(x)) for at, eps, x in lines],
        "orbits": [{
            "params": start.parameters, "eps": start.eps, "x0": iterates[0], "iterates": iterates[1:], "source": source,
        }],
        "singular": singular,
    })


# Heights: the logarithm of max(|p|, |q|) of a fraction p/q in lowest terms.


def orbit_by_fractions(kahan, x):
    """The points of an orbit as pairs (p, q); fast where some components stay short, as those of dE7 and dE8 do."""
    while True:
        yield [(value.numerator, value.denominator) for value in x]
        x = kahan.step(x)


# Linear forms that are products aₙaₙ₊₁ along an orbit. The numerators of a step have the square of the product of these
# aₙ in common, up to small factors: nearly all that cancels.
FORMS = {"e4": [(1, 0, 0), (0, 1, 0)], "e6": [(-1, 1, 1), (1, 1, -1)]}


def orbit_by_integers(kahan, x, forms=()):
    """The points of an orbit as pairs (p, q); fast where all components share nearly all of their denominator.

    With x = X/w, and m the product of the denominators of ε and of the parameters, m w A and m w b hold integers, and
    so do the determinants of Cramer's rule. What divides a component and the denominator divides gcd(X1 X2 ..., w), so
    a point takes one greatest common divisor of long numbers, after what is expected to cancel has done so.
    """
    expected = [1] * len(forms)
    scale = kahan.eps.denominator * prod(value.denominator for value in kahan.parameters.values())
    w = lcm(*(value.denominator for value in x))
    whole = [integer(w * value) for value in x]
    while True:
        content = gcd(prod(expected) ** 2, *whole, w)
        whole, w = [value // content for value in whole], w // content
        shared = gcd(prod(whole), w)
        content = gcd(shared, *whole)
        whole, w = [value // content for value in whole], w // content
        commons = [gcd(value, shared, w) for value in whole]
        yield [(value // common, w // common) for value, common in zip(whole, commons)]
        values = [sum(entry * value for entry, value in zip(form, whole)) for form in forms]
        expected = [value // gcd(value, factor) for value, factor in zip(values, expected)]
        columns = transposed([[integer(scale * entry) for entry in row] for row in kahan.matrix(whole, kahan.eps, w)])
        side = [integer(scale * entry) for entry in kahan.right_side(whole, w)]
        whole = [determinant([*columns[:i], side, *columns[i + 1 :]]) for i in range(len(side))]
        w = determinant(columns)


def integer(value):
    assert value.denominator == 1
    return value.numerator


PRECISE = Context(prec=40)
DIGITS = 15
# Numbers of more bits, 12 000 digits, are followed with `--all` alone.
SHORT = 40_000


def logarithm(value):
    """The natural logarithm of a positive integer to 15 digits."""
    below = max(0, value.bit_length() - 200)
    exact = PRECISE.add(PRECISE.ln(value >> below), PRECISE.multiply(below, PRECISE.ln(2)))
    text = f"{Context(prec=DIGITS).plus(exact):f}"
    whole, _, rest = text.partition(".")
    return f"{whole}.{rest.rstrip('0') or '0'}"


def digits_of(value):
    """How many decimal digits a positive integer has."""
    count = int(value.bit_length() * 0.30102999566398) + 1
    return count - (value < 10 ** (count - 1))


def heights_of(system, steps, longest):
    """The entry of one system, up to the first number of more bits than `longest`."""
    parameters, eps, x, source = ORBITS[system]
    kahan, x = Map(system, numbers(parameters), Fraction(eps)), numbers(x)
    points = orbit_by_fractions(kahan, x) if system in ("e7", "e8") else orbit_by_integers(kahan, x, FORMS.get(system, ()))
    kept, heights, last = [], {state: [] for state in kahan.states}, []
    for n, point in zip(range(steps + 1), points):
        last = [max(abs(p), abs(q)) for p, q in point]
        if max(last).bit_length() > longest:
            break
        if n <= 200 or n % 10 == 0:
            kept.append(n)
            for state, value in zip(kahan.states, last):
                heights[state].append(logarithm(value))
    entry = {"params": kahan.parameters, "eps": kahan.eps, "x0": x, "iterates": steps, "source": source}
    entry |= {"n": kept, "h": heights}
    if kept[-1] == steps:
        entry["decimal_digits_of_last_height"] = dict(zip(kahan.states, map(digits_of, last)))
    return shown(entry)


def heights_file(longest):
    return {
        "definition": "h(p/q) = log max(|p|,|q|), lowest terms, natural logarithm; index 0 is the initial point",
        "precision": f"{DIGITS} significant digits",
        "systems": {system: heights_of(system, steps, longest) for system, steps in HEIGHTS.items()},
    }


# The command.


def without_decimals(value):
    if isinstance(value, list):
        return [without_decimals(entry) for entry in value]
    if isinstance(value, dict):
        return {key: without_decimals(entry) for key, entry in value.items() if not key.endswith("_decimal")}
    return value


def text_of(value):
    return json.dumps(value, indent=1) + "\n"


def is_reproduced(path, made):
    """Says how the file and what was made differ, if they do."""
    text = path.read_text()
    if path.name == "heights.json":
        # As far as the orbits were followed.
        stored = json.loads(text)
        for system, entry in made["systems"].items():
            there, count = stored["systems"][system], len(entry["n"])
            if count < len(there["n"]):
                print(f"heights.json: {system} up to {entry['n'][-1]} of {entry['iterates']} iterates")
                there["n"] = there["n"][:count]
                there["h"] = {state: values[:count] for state, values in there["h"].items()}
                del there["decimal_digits_of_last_height"]
        text = text_of(stored)
    elif mpmath is None:
        text = text_of(without_decimals(json.loads(text)))
    if text == text_of(made):
        return True
    places = zip_longest(text.splitlines(), text_of(made).splitlines(), fillvalue="")
    line, (there, here) = next((n, pair) for n, pair in enumerate(places, 1) if pair[0] != pair[1])
    print(f"{path.name}: line {line} is {there.strip()}, made is {here.strip()}")
    return False


def main(words):
    if set(words) - {"--check", "--all"}:
        sys.exit(__doc__)
    checks = "--check" in words
    if mpmath is None and not checks:
        sys.exit("writing the files takes mpmath: pip install mpmath")
    longest = SHORT if checks and "--all" not in words else sys.maxsize
    files = {f"{system}.json": file_of(system) for system in FIELDS} | {"heights.json": heights_file(longest)}
    if not checks:
        for name, made in files.items():
            (FOLDER / name).write_text(text_of(made))
        return
    if mpmath is None:
        print("mpmath is not installed: values that end in `_decimal` are not compared")
    differing = [name for name, made in files.items() if not is_reproduced(FOLDER / name, made)]
    if differing:
        sys.exit(f"not reproduced: {', '.join(differing)}")
    print(f"reproduced: {', '.join(files)}")


if __name__ == "__main__":
    main(sys.argv[1:])
