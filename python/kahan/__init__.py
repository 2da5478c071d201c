"""Kahan's method for quadratic differential equations.

Kahan's method turns a quadratic vector field x' = f(x) into a birational map, which approximates
the flow over the time step 2 eps. The map runs forwards and backwards, and often preserves
integrals and volume forms exactly. Everywhere, ``eps`` is half the time step: dt = 2 eps.

>>> import kahan
>>> s = kahan.System("xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);")
>>> o = s.orbit([1, 2, 3], eps=0.05, steps=1000)
>>> o.x.shape
(1001, 3)
"""

from . import catalog
from ._answer import Answer
from ._basis import Basis
from ._discovery import Discovery
from ._errors import FieldError, Mistake, SingularStep
from ._files import read
from ._formula import Formula
from ._kahan import __version__
from ._lattice import Lattice, LatticeOrbit
from ._lifted import Lifted
from ._orbit import Chart, Diagram, Ensemble, Orbit, Section, Table
from ._series import Series
from ._sindy import from_sindy
from ._system import System

__all__ = [
    "Answer",
    "Basis",
    "Chart",
    "Diagram",
    "Discovery",
    "Ensemble",
    "FieldError",
    "Formula",
    "Lattice",
    "LatticeOrbit",
    "Lifted",
    "Mistake",
    "Orbit",
    "Section",
    "Series",
    "SingularStep",
    "System",
    "Table",
    "__version__",
    "catalog",
    "from_sindy",
    "read",
]
