"""Reading of model files."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

from ._coefficients import loaded
from ._errors import FieldError, needed
from ._exact import Number
from ._model import Place, Refused
from ._sbml import sbml_model
from ._system import System
from ._xpp import xpp_text

__all__ = ["read"]

_ENDINGS = (".kahan", ".txt", ".ode", ".xml", ".sbml", ".ant")


def read(path: str | os.PathLike[str], *, lift: str | None = None, **parameters: Number) -> System:
    """Reads the field in a file, with the values of its parameters and its initial point.

    The suffix of the name determines the format: ``.kahan`` or ``.txt`` for text as in ``System``,
    ``.ode`` for XPP, ``.xml`` or ``.sbml`` for SBML, ``.ant`` for Antimony, ``.npz`` for arrays c,
    B, Q written by ``np.savez``. SBML needs the package python-libsbml, and Antimony also the
    package antimony. ``parameters`` replace values in the file.

    Equations that are not quadratic are lifted; ``lift`` selects the kind of lift, as in
    ``System``. The attribute ``source`` is the text made from a model, with comments on how it was
    read; it may be saved as a ``.kahan`` file.

    Raises ``ValueError`` with the position of an unsupported part, such as an event.

    >>> import kahan, pathlib, tempfile
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "oscillator.ode"
    >>> _ = file.write_text("par a=2\\ninit x=1,y=0\\nx'=y\\ny'=-a*x\\ndone\\n")
    >>> s = kahan.read(file)
    >>> s.orbit(eps=0.05, steps=100).x.shape
    (101, 2)
    """
    given, path = str(path), Path(path)
    ending = path.suffix.lower()
    if ending == ".npz":
        arrays: dict[str, Any] = {**loaded(path), **parameters}
        try:
            return System.from_arrays(**arrays)
        except FieldError as error:
            raise FieldError(f"{path}: {error.args[0]}", [*error.mistakes]) from None
        except ValueError as error:
            raise ValueError(f"{path}: {error}") from None
    if ending not in _ENDINGS:
        hint = "; Antimony's is .ant" if ending == ".antimony" else ""
        hint = "; equations as text go to kahan.System(text)" if re.search(r"[=\n]", given) else hint
        raise ValueError(f"{path}: the ending says what is in a file; it must be one of {', '.join(_ENDINGS)} and .npz{hint}")
    if ending in (".xml", ".sbml"):
        lib = needed("libsbml", "sbml", "python-libsbml")
        path.stat()
        text = sbml_model(lib, lib.readSBMLFromFile(str(path)), Place(str(path))).text()
        return _system(text, f"text made from {path}", lift, parameters)
    text, origin = path.read_text(encoding="utf-8", errors="replace"), str(path)
    if ending == ".ode":
        text = xpp_text(text)
    elif ending == ".ant":
        lib = needed("libsbml", "sbml", "python-libsbml")
        text = sbml_model(lib, lib.readSBMLFromString(_from_antimony(path)), Place(str(path), text)).text()
        origin = f"text made from {path}"
    return _system(text, origin, lift, parameters)


def _from_antimony(path: Path) -> str:
    """Converts the model of an Antimony file to SBML, with submodels expanded."""
    antimony = needed("antimony", "sbml")
    antimony.clearPreviousLoads()
    if antimony.loadAntimonyFile(str(path)) < 0:
        raise ValueError(f"{path}: {antimony.getLastError().strip()}")
    found: str = antimony.getSBMLString(antimony.getMainModuleName())
    return found


def _system(text: str, origin: str, wanted: str | None, parameters: dict[str, Any]) -> System:
    """Returns the field of a text, lifted if it is not quadratic. Positions of mistakes refer to ``origin``."""
    try:
        return System(text, **parameters)
    except FieldError as error:
        plain = error
    without = re.sub(r"^integral total\d+ = ", "# constant along solutions: ", text, flags=re.MULTILINE)
    failed: Exception = plain
    # Some lifts preserve a total only on their relations, so the claim fails and becomes a comment.
    kinds = [wanted] if wanted else ["automatic", "stable", "smallest"]
    for lift, of in ((kinds[0], text), *((kind, without) for kind in kinds)):
        try:
            return System(of, lift=lift, **parameters)
        except ValueError as error:
            failed = error if failed is plain else failed
    if isinstance(failed, FieldError):
        report, mistakes = failed.args
        failed.args = (re.sub(r"^( *--> )field(?=:\d)", lambda arrow: arrow[1] + origin, report, flags=re.MULTILINE), mistakes)
    raise failed
