"""``python -m kahan_command`` is the command ``kahan``."""

from . import main

main()
