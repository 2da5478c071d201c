"""The largest exponent of Lorenz' system over r and s, 10 000 steps of 0.01 a cell, by one of three packages.

    python grids.py kahan|numba|pynamicalsys SIDE

Prints the mean over SIDE × SIDE cells, and the seconds of a second run, where all is compiled. One process is one package, so
that whoever starts it can measure what importing and compiling cost, too.
"""

import os
import sys
import time

os.environ["NUMBA_NUM_THREADS"] = "2"

import numpy as np

STEPS, EPS, B, START = 10_000, 0.005, 8 / 3, (1.0, 1.0, 20.0)
R, S = (24.0, 100.0), (8.0, 16.0)


def by_kahan():
    import kahan

    lorenz = kahan.System("xdot = s*(y - x); ydot = x*(r - z) - y; zdot = x*y - b*z;", b="8/3", r=28, s=10)
    return lambda side: lorenz.chart({"r": (*R, side), "s": (*S, side)}, START, EPS, steps=STEPS, color="lyapunov", threads=2).values


def by_numba():
    """Kahan's map and its derivative by cofactors, as a careful user writes them: 16 cells in the inner loop, of which the
    compiler makes vectors, lengths looked at each 20 steps, `fastmath`."""
    import numba

    lanes, scaled = 16, 20

    @numba.njit(fastmath=True, error_model="numpy", inline="always")
    def step(x, y, z, a, b, c, r, s):
        m00, m01 = 1 + EPS * s, -EPS * s
        m10, m11, m12 = -EPS * (r - z), 1 + EPS, EPS * x
        m20, m21, m22 = -EPS * y, -EPS * x, 1 + EPS * B
        c00, c01, c02 = m11 * m22 - m12 * m21, -m01 * m22, m01 * m12
        c10, c11, c12 = m12 * m20 - m10 * m22, m00 * m22, -m00 * m12
        c20, c21, c22 = m10 * m21 - m11 * m20, m01 * m20 - m00 * m21, m00 * m11 - m01 * m10
        inverse = 1 / (m00 * c00 + m01 * c10)
        f, g, h = s * (y - x), x * (r - z) - y, x * y - B * z
        k = 2 * EPS * inverse
        x, y, z = (x + k * (c00 * f + c01 * g + c02 * h), y + k * (c10 * f + c11 * g + c12 * h),
                   z + k * (c20 * f + c21 * g + c22 * h))
        f = a + EPS * s * (b - a)
        g = b + EPS * ((r - z) * a - b - x * c)
        h = c + EPS * (y * a + x * b - B * c)
        return (x, y, z, inverse * (c00 * f + c01 * g + c02 * h), inverse * (c10 * f + c11 * g + c12 * h),
                inverse * (c20 * f + c21 * g + c22 * h))

    @numba.njit(fastmath=True, error_model="numpy", parallel=True)
    def grid(r, s):
        exponent = np.empty(len(r))
        for block in numba.prange(len(r) // lanes):
            first = block * lanes
            state, growth = np.empty((6, lanes)), np.zeros(lanes)
            for k in range(lanes):
                state[0, k], state[1, k], state[2, k] = START
                state[3, k], state[4, k], state[5, k] = 0.6, 0.64, 0.48
            for n in range(1, STEPS + 1):
                for k in range(lanes):
                    (state[0, k], state[1, k], state[2, k], state[3, k], state[4, k], state[5, k]) = step(
                        state[0, k], state[1, k], state[2, k], state[3, k], state[4, k], state[5, k],
                        r[first + k], s[first + k])
                if n % scaled == 0:
                    for k in range(lanes):
                        length = np.sqrt(state[3, k] ** 2 + state[4, k] ** 2 + state[5, k] ** 2)
                        growth[k] += np.log(length)
                        state[3, k] /= length
                        state[4, k] /= length
                        state[5, k] /= length
            for k in range(lanes):
                exponent[first + k] = growth[k] / (2 * EPS * STEPS)
        return exponent

    return lambda side: grid(*(axis.ravel() for axis in np.meshgrid(np.linspace(*R, side), np.linspace(*S, side))))


def by_pynamicalsys():
    from pynamicalsys import ContinuousDynamicalSystem

    lorenz = ContinuousDynamicalSystem(model="lorenz system")
    lorenz.integrator("rk4", time_step=2 * EPS)
    cells = lambda side: [[lorenz.lyapunov(list(START), 2 * EPS * STEPS, parameters=[s, r, B], num_exponents=1)
                           for r in np.linspace(*R, side)] for s in np.linspace(*S, side)]
    return lambda side: np.array(cells(side))


if __name__ == "__main__":
    grid, side = {"kahan": by_kahan, "numba": by_numba, "pynamicalsys": by_pynamicalsys}[sys.argv[1]](), int(sys.argv[2])
    mean = grid(side).mean()
    begun = time.perf_counter()
    grid(side)
    print(mean, time.perf_counter() - begun)
