"""Plots by matplotlib, which is loaded when the first one is drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._errors import unknown

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._orbit import Chart, Orbit, Section

__all__ = ["chart", "orbit", "section"]

_DOTS: dict[str, Any] = {"marker": ".", "markersize": 2, "linestyle": ""}
_LINE: dict[str, Any] = {"linewidth": 0.7}


def _axes(ax: Axes | None, dimensions: int) -> Any:
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    return plt.figure().add_subplot(projection="3d" if dimensions == 3 else None)


def _label(ax: Any, names: tuple[str, ...]) -> None:
    for name, set_label in zip(names, ("set_xlabel", "set_ylabel", "set_zlabel")):
        getattr(ax, set_label)(name)


def _columns(found: Orbit | Section, names: tuple[str, ...], counts: tuple[int, ...]) -> list[Any]:
    known = {name: found.x[:, k] for k, name in enumerate(found.system.variables)}
    known.setdefault("t", found.t)
    if len(names) not in counts:
        raise ValueError(f"{' or '.join(map(str, counts))} axes are needed, and {len(names)} given")
    for name in names:
        if name not in known:
            raise ValueError(unknown("axis", name, known))
    return [known[name] for name in names]


def orbit(found: Orbit, names: tuple[str, ...], ax: Axes | None, style: dict[str, Any]) -> Axes:
    """The points of an orbit, joined by a line where the axes have the time."""
    names = names or (found.system.variables[:3] if len(found.system.variables) > 1 else ("t", *found.system.variables))
    columns = _columns(found, names, (2, 3))
    ax = _axes(ax, len(names))
    ax.plot(*columns, **((_LINE if "t" in names else _DOTS) | style))
    _label(ax, names)
    return ax


def section(found: Section, names: tuple[str, ...], ax: Axes | None, style: dict[str, Any]) -> Axes:
    """The crossings as dots."""
    others = [name for name in found.system.variables if name not in found.plane]
    names = names or tuple((others if len(others) > 1 else list(found.system.variables))[:2])
    columns = _columns(found, names, (2, 3))
    ax = _axes(ax, len(names))
    ax.plot(*columns, **(_DOTS | style))
    _label(ax, names)
    ax.set_title(f"{found.plane} = 0")
    return ax


def chart(found: Chart, ax: Axes | None, style: dict[str, Any]) -> Axes:
    """A curve over one axis; over two the cells in colours, with a bar that says what they mean."""
    names, values = list(found.axes), list(found.axes.values())
    if len(names) > 2:
        raise ValueError("a picture has two axes; take a part of `values`")
    ax = _axes(ax, 2)
    if len(names) == 1:
        ax.plot(values[0], found.values, **(_LINE | style))
        _label(ax, (names[0], found.color))
        return ax
    mesh = ax.pcolormesh(values[0], values[1], found.values.T, **({"shading": "nearest"} | style))
    ax.figure.colorbar(mesh, ax=ax, label=found.color)
    _label(ax, (names[0], names[1]))
    return ax
