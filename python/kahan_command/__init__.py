"""The command ``kahan``, which the wheel brings along.

It needs no NumPy: it loads the compiled module beside the package and not the package.
"""

import signal
import sys
from importlib.machinery import EXTENSION_SUFFIXES, ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

__all__ = ["main"]


def main() -> None:
    """Runs the command with this program's arguments, and ends with its exit status."""
    folder = Path(__file__).resolve().parent.parent / "kahan"
    paths = [folder / f"_kahan{suffix}" for suffix in EXTENSION_SUFFIXES]
    path = next((str(path) for path in paths if path.exists()), None)
    if path is None:
        sys.exit(f"error: the compiled module is not in {folder}; install the wheel again")
    spec = spec_from_file_location("_kahan", path, loader=ExtensionFileLoader("_kahan", path))
    assert spec is not None and spec.loader is not None
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    # Ctrl-C ends the command at once, while Python's handler would wait for the command.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(module.command(["kahan", *sys.argv[1:]]))
