"""Modules that need a package which may be absent."""

import importlib


def module(name):
    """A module that imports numba or OpenSees, or `None` and a message why it cannot be had here."""
    try:
        return importlib.import_module(name)
    except (ImportError, RuntimeError) as fault:
        first = fault
        while first.__context__ is not None:
            first = first.__context__
        print(f"{name} cannot be had here, its cells are left out: {first}", flush=True)
        return None
