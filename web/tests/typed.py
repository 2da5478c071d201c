"""Types thirty fields with two to six variables: classical fields, fields of the catalog, and
random fields. The page must show a good picture of at least 28 fields."""

import random

from tab import PAGE, Tab

CLASSICAL = [
    "xdot = x - x*y; ydot = -y + x*y;",
    "x' = a*x - b*x*y\ny' = -c*y + d*x*y",
    "x' = 10*(y - x)\ny' = 28*x - y - x*z\nz' = x*y - 8/3*z",
    "xdot = y; ydot = -x;",
    "x' = y\ny' = -x - x^2",
    "xdot = v; vdot = -x - 1/10*v + x^2;",
    "x'' = 1 - x^2",
    "x1dot = a1*x2*x3; x2dot = a2*x3*x1; x3dot = a3*x1*x2;",
    "xdot = -y - z; ydot = x + 1/5*y; zdot = 1/5 + z*(x - 57/10);",
    "xdot = x*(1 - x - 1/2*y); ydot = y*(1 - y - 1/3*x);",
    "s' = -b*s*i\ni' = b*s*i - g*i\nr' = g*i",
    "xdot = x*(y - z); ydot = y*(z - x); zdot = z*(x - y);",
    "x1dot = x1*(x2 - x4); x2dot = x2*(x3 - x1); x3dot = x3*(x4 - x2); x4dot = x4*(x1 - x3);",
    "xdot = u; ydot = v; udot = -x - 2*x*y; vdot = -y - x^2 + y^2;",
    "xdot = y*z - x; ydot = x*z - y; zdot = 1 - x*y - z;",
    "xdot = y; ydot = z; zdot = -3/5*z - y - x + x^2;",
]
CATALOG = [
    "xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);",
    "m1dot = (w3 - w2)*p2*p3; m2dot = (w1 - w3)*p3*p1; m3dot = (w2 - w1)*p1*p2; p1dot = m3*p2 - m2*p3; p2dot = m1*p3 - m3*p1; p3dot = m2*p1 - m1*p2;",
    "m1dot = a*m2*m3 + p2; m2dot = -a*m1*m3 - p1; m3dot = 0; p1dot = b*m3*p2 - m2*p3; p2dot = m1*p3 - b*m3*p1; p3dot = m2*p1 - m1*p2;",
    "udot = v*w - u; vdot = -u*w + v; wdot = -w;",
]
SEED = 64


def at_random(count):
    """Returns random fields with two to five terms an equation, of degrees 1 and 2."""
    chance = random.Random(SEED)
    fields = []
    for k in range(count):
        names = ["x", "y", "z", "u", "v", "w"][: 2 + k % 5]
        equations = []
        for name in names:
            terms = [f"{chance.choice([-1, 1, -2, 2])}*{chance.choice(names)}" for _ in range(chance.randint(1, 2))]
            terms += [f"{chance.choice([-1, 1, -2, 2])}*{chance.choice(names)}*{chance.choice(names)}" for _ in range(chance.randint(1, 3))]
            equations.append(f"{name}dot = {' + '.join(terms)};".replace("+ -", "- "))
        fields.append("\n".join(equations))
    return fields


FIELDS = CLASSICAL + CATALOG + at_random(10)
# JavaScript that returns, for each orbit, the share of the frame that its bounding box covers.
SHARES = """(() => {
    const places = placesOf()
    return lastDrawn.filter(({method}) => method === 'kahan').map(({columns}) => places.map((k, axis) => {
        const [low, high] = frame.window[axis]
        const other = columns[places[1 - axis]], [from, to] = frame.window[1 - axis]
        const inside = columns[k].filter((value, row) => value >= low && value <= high && other[row] >= from && other[row] <= to)
        return inside.length ? (inside.reduce((a, b) => Math.max(a, b)) - inside.reduce((a, b) => Math.min(a, b))) / (high - low) : 0
    }).reduce((a, b) => a * b))
})()"""


def pictures(browser, fields=FIELDS):
    """Returns the fields with fewer than three orbits that fill a fifth of the frame, each with the
    shares of its orbits and the legend."""
    poor = []
    with Tab(browser, PAGE) as tab:
        tab.opened()
        for field in fields:
            tab.page.evaluate("document.querySelector('#ended').textContent = ''")
            tab.page.fill("#field", field)
            # The page deletes the orbits of the last field at once, but their legend may come late.
            tab.waits("document.querySelector('#ended').textContent !== '' && sheetOf !== null && (lastDrawn.length > 0 || document.querySelector('#panes').hidden)")
            shares = tab.page.evaluate(SHARES) if tab.page.is_visible("#panes") else []
            if sum(share >= 0.2 for share in shares) < 3:
                poor.append((field, [round(share, 2) for share in shares], tab.text("#ended")))
    return poor


def typed_fields_have_pictures(browser, _):
    assert len(FIELDS) == 30
    poor = pictures(browser)
    assert len(poor) <= 2, poor
    print(f"of {len(FIELDS)} typed fields {len(FIELDS) - len(poor)} have at least three orbits that fill a fifth of the frame")
