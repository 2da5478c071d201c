"""Progress bars by tqdm, or a warning if tqdm is not installed."""

from __future__ import annotations

import warnings
from typing import Any

__all__ = ["listener"]


def listener(progress: bool) -> Any:
    """Returns a function that updates a bar with the kind of items, the number done and the total;
    ``None`` without progress.
    """
    if not progress:
        return None
    try:
        from tqdm.auto import tqdm
    except ImportError:
        warnings.warn("progress=True shows a bar of tqdm, which is not installed: pip install tqdm")
        return None
    # Short work shows no bar.
    bar: Any = tqdm(leave=False, delay=0.2)

    def hear(what: str, done: Any, of: Any) -> None:
        if what == "found":
            kind, name, _ = done
            bar.write(f"found: {kind} {name}")
            return
        bar.total, bar.n = of, done if of else 0
        bar.bar_format = None if of else "{desc} {elapsed}"
        bar.set_description_str(what)
        bar.refresh()

    return hear
