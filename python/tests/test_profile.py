"""The wheel is optimised as the command is: profiles are not inherited from another workspace."""

from pathlib import Path

import pytest


def test_the_release_profile_is_the_roots():
    tomllib = pytest.importorskip("tomllib")
    root = Path(__file__).resolve().parents[2]
    own, theirs = (tomllib.loads((folder / "Cargo.toml").read_text())["profile"]["release"] for folder in (root / "python", root))
    assert own == theirs
