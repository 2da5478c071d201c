"""The steps that exponents.py times: Kahan's map and its derivative as a careful user writes them by hand, and the classical
Runge-Kutta method of order 4 on the field and its variational equations.

Kahan's linear system is solved in closed form, by cofactors that the state and its tangent vectors share:
x~ = x + 2 eps A(x,eps)^-1 f(x) and v~ = A(x,eps)^-1 A(x~,-eps) v. Each function here makes steps with the compiler that it is
given, or none.
"""

import numpy as np


def e6(jit):
    """The field in three variables, and the nine entries of its derivative."""

    @jit
    def rate(x, y, z):
        return y * (2 * z - x), x * x - z * z, y * (z - 2 * x)

    @jit
    def slope(x, y, z):
        return -y, 2 * z - x, 2 * y, 2 * x, 0.0, -2 * z, -2 * y, z - 2 * x, y

    return rate, slope


def lorenz(jit):
    @jit
    def rate(x, y, z):
        return 10 * (y - x), x * (28 - z) - y, x * y - 8 / 3 * z

    @jit
    def slope(x, y, z):
        return -10.0, 10.0, 0.0, 28 - z, -1.0, -x, y, x, -8 / 3

    return rate, slope


def steps_in_space(jit, field):
    """Steps of a state x, y, z and a tangent vector: Kahan's, and Runge and Kutta's."""
    rate, slope = field(jit)

    @jit
    def along(j, a, b, c):
        return j[0] * a + j[1] * b + j[2] * c, j[3] * a + j[4] * b + j[5] * c, j[6] * a + j[7] * b + j[8] * c

    @jit
    def kahan(s, eps):
        x, y, z, a, b, c = s
        j = slope(x, y, z)
        m00, m01, m02 = 1 - eps * j[0], -eps * j[1], -eps * j[2]
        m10, m11, m12 = -eps * j[3], 1 - eps * j[4], -eps * j[5]
        m20, m21, m22 = -eps * j[6], -eps * j[7], 1 - eps * j[8]
        c00, c01, c02 = m11 * m22 - m12 * m21, m02 * m21 - m01 * m22, m01 * m12 - m02 * m11
        c10, c11, c12 = m12 * m20 - m10 * m22, m00 * m22 - m02 * m20, m02 * m10 - m00 * m12
        c20, c21, c22 = m10 * m21 - m11 * m20, m01 * m20 - m00 * m21, m00 * m11 - m01 * m10
        adjugate = (c00, c01, c02, c10, c11, c12, c20, c21, c22)
        inverse = 1 / (m00 * c00 + m01 * c10 + m02 * c20)
        f, g, h = rate(x, y, z)
        u, v, w = along(adjugate, f, g, h)
        x, y, z = x + 2 * eps * inverse * u, y + 2 * eps * inverse * v, z + 2 * eps * inverse * w
        u, v, w = along(slope(x, y, z), a, b, c)
        a, b, c = along(adjugate, a + eps * u, b + eps * v, c + eps * w)
        return x, y, z, inverse * a, inverse * b, inverse * c

    @jit
    def rates(s):
        x, y, z, a, b, c = s
        u, v, w = rate(x, y, z)
        d, e, f = along(slope(x, y, z), a, b, c)
        return u, v, w, d, e, f

    @jit
    def moved(s, h, k):
        return s[0] + h * k[0], s[1] + h * k[1], s[2] + h * k[2], s[3] + h * k[3], s[4] + h * k[4], s[5] + h * k[5]

    @jit
    def runge_kutta(s, eps):
        k = rates(s)
        l = rates(moved(s, eps, k))
        m = rates(moved(s, eps, l))
        n = rates(moved(s, 2 * eps, m))
        return moved(moved(moved(moved(s, eps / 3, k), 2 * eps / 3, l), 2 * eps / 3, m), eps / 3, n)

    return kahan, runge_kutta


def steps_of_cells(jit):
    """Steps of Henon and Heiles' x, y, p, q and two tangent vectors, 12 numbers or 12 arrays: Kahan's, Runge and Kutta's;
    vectors made as long as 1; and the smaller alignment index of such."""

    @jit
    def solved(a, b, c, eps, inverse, r):
        """A(x,eps)^-1 r, by its two equations for the momenta."""
        f, g = r[2] - a * r[0] - c * r[1], r[3] - c * r[0] - b * r[1]
        p = ((1 + eps * b) * f - eps * c * g) * inverse
        q = ((1 + eps * a) * g - eps * c * f) * inverse
        return r[0] + eps * p, r[1] + eps * q, p, q

    @jit
    def carried(a, b, c, eps, v):
        """A(x,-eps) v"""
        return v[0] + eps * v[2], v[1] + eps * v[3], v[2] - a * v[0] - c * v[1], v[3] - c * v[0] - b * v[1]

    @jit
    def kahan(s, eps):
        x, y, p, q = s[0], s[1], s[2], s[3]
        a, b, c = eps * (1 + 2 * y), eps * (1 - 2 * y), 2 * eps * x
        inverse = 1 / ((1 + eps * a) * (1 + eps * b) - eps * eps * c * c)
        u = solved(a, b, c, eps, inverse, (p, q, -x - 2 * x * y, -y - x * x + y * y))
        x, y, p, q = x + 2 * eps * u[0], y + 2 * eps * u[1], p + 2 * eps * u[2], q + 2 * eps * u[3]
        d, e, f = eps * (1 + 2 * y), eps * (1 - 2 * y), 2 * eps * x
        v = solved(a, b, c, eps, inverse, carried(d, e, f, eps, (s[4], s[5], s[6], s[7])))
        w = solved(a, b, c, eps, inverse, carried(d, e, f, eps, (s[8], s[9], s[10], s[11])))
        return x, y, p, q, v[0], v[1], v[2], v[3], w[0], w[1], w[2], w[3]

    @jit
    def rates(s):
        x, y, p, q, a, b, c, d, e, f, g, h = s
        k, l, m = 1 + 2 * y, 1 - 2 * y, 2 * x
        return (p, q, -x - 2 * x * y, -y - x * x + y * y, c, d, -k * a - m * b, -m * a - l * b,
                g, h, -k * e - m * f, -m * e - l * f)

    @jit
    def moved(s, h, k):
        return (s[0] + h * k[0], s[1] + h * k[1], s[2] + h * k[2], s[3] + h * k[3], s[4] + h * k[4], s[5] + h * k[5],
                s[6] + h * k[6], s[7] + h * k[7], s[8] + h * k[8], s[9] + h * k[9], s[10] + h * k[10], s[11] + h * k[11])

    @jit
    def runge_kutta(s, eps):
        k = rates(s)
        l = rates(moved(s, eps, k))
        m = rates(moved(s, eps, l))
        n = rates(moved(s, 2 * eps, m))
        return moved(moved(moved(moved(s, eps / 3, k), 2 * eps / 3, l), 2 * eps / 3, m), eps / 3, n)

    @jit
    def scaled(s):
        v = 1 / np.sqrt(s[4] * s[4] + s[5] * s[5] + s[6] * s[6] + s[7] * s[7])
        w = 1 / np.sqrt(s[8] * s[8] + s[9] * s[9] + s[10] * s[10] + s[11] * s[11])
        return (s[0], s[1], s[2], s[3], v * s[4], v * s[5], v * s[6], v * s[7],
                w * s[8], w * s[9], w * s[10], w * s[11])

    @jit
    def sali(s):
        a, b, c, d = s[4] + s[8], s[5] + s[9], s[6] + s[10], s[7] + s[11]
        e, f, g, h = s[4] - s[8], s[5] - s[9], s[6] - s[10], s[7] - s[11]
        return np.sqrt(np.minimum(a * a + b * b + c * c + d * d, e * e + f * f + g * g + h * h))

    return kahan, runge_kutta, scaled, sali
