"""Modules that need a program which may be absent."""

import importlib


def opensees(module):
    """A module that imports OpenSees, or `None` and a message why it cannot be had here."""
    try:
        return importlib.import_module(module)
    except (ImportError, RuntimeError) as fault:
        first = fault
        while first.__context__ is not None:
            first = first.__context__
        print(f"OpenSees cannot be had here, its rows are left out: {first}", flush=True)
        return None
