"""Plots by matplotlib, which is imported for the first plot."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import needed, unknown
from ._kahan import picture_scale

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._lattice import LatticeOrbit
    from ._orbit import Chart, Diagram, Ensemble, Orbit, Section, Table
    from ._series import Series

__all__ = ["chart", "diagram", "ensemble", "lattice", "orbit", "section", "series"]

_DOTS: dict[str, Any] = {"marker": ".", "markersize": 2, "linestyle": ""}
_LINE: dict[str, Any] = {"linewidth": 0.7}


def _over(found: Table, names: tuple[str, ...], usual: list[str], ax: Axes | None) -> tuple[Any, list[Any]]:
    """Returns labelled axes and the columns to draw: those in ``names``, or by default as many usual ones as fit."""
    is_flat = ax is not None and not hasattr(ax, "set_zlabel")
    names = names or tuple(usual[:2] if is_flat else usual[:3])
    if not 2 <= len(names) <= (2 if is_flat else 3):
        raise ValueError(f"{'2 axes are' if is_flat else '2 or 3 axes are'} needed, and {len(names)} given; "
                         'three go into `plt.figure().add_subplot(projection="3d")`')
    columns = found.columns()
    for name in names:
        if name not in columns:
            raise ValueError(unknown("axis", name, columns))
    drawn: Any = ax
    if ax is None:
        needed("matplotlib", "plot")
        import matplotlib.pyplot as plt

        drawn = plt.figure().add_subplot(projection="3d" if len(names) == 3 else None)
    for name, axis in zip(names, "xyz"):
        getattr(drawn, f"set_{axis}label")(name)
    return drawn, [np.asarray(columns[name], dtype=float) for name in names]


def _flat(ax: Axes | None) -> Any:
    """Returns these axes, or those of a new figure."""
    if ax is not None:
        return ax
    needed("matplotlib", "plot")
    import matplotlib.pyplot as plt

    return plt.figure().add_subplot()


def _styled(usual: dict[str, Any], style: dict[str, Any]) -> dict[str, Any]:
    """Returns the usual style, updated by the given one; short names of matplotlib such as ``lw``
    are accepted.

    ``s`` is the area of a dot, as in ``Axes.scatter``.
    """
    from matplotlib import cbook, lines

    if "s" in style:
        style = {"marker": ".", **{name: value for name, value in style.items() if name != "s"}, "markersize": style["s"] ** 0.5}
    return usual | cbook.normalize_kwargs(style, lines.Line2D)


def _scaled(column: str, meaning: str, values: Any) -> tuple[str, Any]:
    """Returns the label of numbers, and the numbers; as logarithms if the command's pictures use them."""
    values = np.asarray(values, dtype=float)
    is_logarithm, shown = picture_scale(column, values.ravel())
    meaning = meaning.partition(";")[0]
    return f"log of {meaning}, to base 10" if is_logarithm else meaning, np.reshape(shown, values.shape)


def orbit(found: Orbit, names: tuple[str, ...], ax: Axes | None, style: dict[str, Any]) -> Axes:
    """Draws the points of an orbit, joined by lines if an axis is the time or there are three axes."""
    variables = list(found.system.variables)
    axes, columns = _over(found, names, variables if len(variables) > 1 else ["t", *variables], ax)
    axes.plot(*columns, **_styled(_LINE if "t" in names or len(columns) == 3 else _DOTS, style))
    axes.set_title(f"{found.system.name}, eps = {found.eps}, {found.steps} steps")
    return axes  # type: ignore[no-any-return]


def ensemble(found: Ensemble, names: tuple[str, ...], color: str | None, ax: Axes | None, style: dict[str, Any]) -> Axes:
    """Draws the trajectories as dots, with a colour bar if they are coloured."""
    axes, columns = _over(found, names, [*found.system.variables, *found.columns()][:2], ax)
    if color is None:
        axes.scatter(*columns, **({"s": 2} | style))
        return axes  # type: ignore[no-any-return]
    label, shown = _scaled(color, color, found[color])
    axes.figure.colorbar(axes.scatter(*columns, c=shown, **({"s": 2} | style)), ax=axes, label=label)
    return axes  # type: ignore[no-any-return]


def series(found: Series, names: tuple[str, ...], ax: Axes | None, style: dict[str, Any]) -> Axes:
    """Draws each orbit as a line."""
    axes, columns = _over(found, names, ["t", *found.system.variables][:2], ax)
    for lines in zip(*(column.reshape(found.steps.size, -1) for column in columns)):
        axes.plot(*lines, **_styled(_LINE, style))
    axes.set_title(f"{found.system.name}, {found.steps.size} orbits")
    return axes  # type: ignore[no-any-return]


def section(found: Section, names: tuple[str, ...], ax: Axes | None, style: dict[str, Any]) -> Axes:
    """Draws the crossings as dots, each initial point in its own colour."""
    others = [name for name in found.system.variables if name not in found.plane]
    axes, columns = _over(found, names, (others if len(others) > 1 else list(found.system.variables))[:2], ax)
    starts = found.given.get("start", np.zeros(len(found.x)))
    for start in np.unique(starts):
        axes.plot(*(column[starts == start] for column in columns), **_styled(_DOTS, style))
    steps = f"{found.steps} steps" if isinstance(found.steps, int) else f"{len(found.steps)} orbits"
    eps = "" if found.eps is None else f", eps = {found.eps}"
    axes.set_title(f"{found._place}{eps}, {steps}")
    return axes  # type: ignore[no-any-return]


def diagram(found: Diagram, names: tuple[str, ...], ax: Axes | None, style: dict[str, Any]) -> Axes:
    """Draws one column at the crossings over another, as fine dots."""
    axes, columns = _over(found, names, [], ax)
    axes.plot(*columns, **_styled({"marker": ",", "linestyle": ""}, style))
    axes.set_title(f"{found.system.name}, {found._place}")
    return axes  # type: ignore[no-any-return]


def chart(found: Chart, ax: Axes | None, style: dict[str, Any]) -> Axes:
    """Draws a curve over one axis, or coloured cells over two, with a labelled colour bar."""
    names = list(found.axes)
    if len(names) > 2:
        raise ValueError("a picture has two axes; take a part of `values`")
    label, shown = _scaled(found.color, found.meaning, found.values)
    axes = _flat(ax)
    if len(names) == 1:
        axes.plot(found.axes[names[0]], shown, **_styled(_LINE, style))
        axes.set_ylabel(label)
    else:
        mesh = axes.pcolormesh(*found.axes.values(), shown.T, **({"shading": "nearest"} | style))
        axes.figure.colorbar(mesh, ax=axes, label=label)
        axes.set_ylabel(names[1])
    axes.set_xlabel(names[0])
    early = int(np.sum(found.ended != "complete"))
    empty = f", {early} of {found.values.size} orbits end early" if early else ""
    axes.set_title(f"{found.system.name}, {found.of}{empty}")
    return axes  # type: ignore[no-any-return]


def lattice(found: LatticeOrbit, names: tuple[str, ...], ax: Axes | None, style: dict[str, Any]) -> Axes:
    """Draws the first array in colours over sites and time, or two columns as a line."""
    if names:
        axes, columns = _over(found, names, [], ax)
        axes.plot(*columns, **_styled(_LINE, style))
        return axes  # type: ignore[no-any-return]
    chain = found.system
    if found.x.ndim - 1 != chain._alone(found.x[0])[1]:
        raise ValueError("a picture has one orbit; take `x[:, k]` of arrays of states, or give two columns")
    axes, first = _flat(ax), found.x.reshape(len(found), chain.sites, -1)[:, :, 0]
    mesh = axes.pcolormesh(np.arange(chain.sites), found.t, first, **({"shading": "nearest"} | style))
    axes.figure.colorbar(mesh, ax=axes, label=chain.arrays[0])
    axes.set_xlabel("site")
    axes.set_ylabel("t")
    return axes  # type: ignore[no-any-return]
