"""Measures slipgap, the rates of the machine, numba loops and OpenSees, and writes the table in docs/performance.md.

    table.py ROOT [quick]

With `quick`, a tenth of the cases and one turn; the table is only printed.
"""

import math
import pathlib
import sys
import time

import girders_rows
import large_rows
import sweeps
from measured import Slipgap, machine

BEGIN, END = "<!-- `make peers` writes this -->", "<!-- end -->"
TURNS = 3
COLUMNS = ["Problem", "Cases", "Steps", "Whole run", "Kernel", "Floor", "Kernel / floor", "numba", "OpenSees", "MB", "MB of the factor"]


def cells(row):
    def shown(key):
        return short(row[key]) if key in row else "not there"

    # A loop by hand has no sparse factor.
    numba = "" if "factor" in row else shown("numba")
    factor = f"{row['factor']:.1f}" if "factor" in row else ""
    return [
        row["problem"], str(row["cases"]), str(row["steps"]), shown("whole"), shown("kernel"), shown("floor"),
        short(row["kernel"] / row["floor"]), numba, shown("OpenSees"), f"{row['MB']:.0f}", factor,
    ]


def short(ns):
    """Three digits without an exponent; a difference of two times may be below their noise."""
    if ns <= 0:
        return "too short"
    digits = max(0, 2 - math.floor(math.log10(ns)))
    return f"{float(f'{ns:.3g}'):.{digits}f}"


def main():
    root, is_quick = pathlib.Path(sys.argv[1]), "quick" in sys.argv[2:]
    start = time.perf_counter()
    program = Slipgap(root)
    turns, part = (1, 10) if is_quick else (TURNS, 1)
    rates = {"additions": program.guard("rates")[0]}

    def reading(size):
        """Bytes a ns of reading so many bytes again and again."""
        rates[size] = program.guard("rates", size)[1]
        return rates[size]

    rows = [
        *sweeps.rows(program, turns, part, rates),
        *girders_rows.rows(program, turns, part, rates),
        *large_rows.rows(program, root / "target" / "peers-large", turns, part, reading),
    ]
    head = f"| {' | '.join(COLUMNS)} |\n| --- |{' ---: |' * (len(COLUMNS) - 1)}"
    table = "\n".join([head, *(f"| {' | '.join(cells(row))} |" for row in rows)])
    read = ", ".join(f"{rate:.3g} for {size / 1e6:.2g} MB" for size, rate in rates.items() if size != "additions")
    text = (
        f"{machine()}, the shortest of {turns} turns on one thread, ns for a step of a case. "
        f"The rates are {rates['additions']:.3g} additions a ns, and bytes read a ns: {read}.\n\n{table}"
    )
    print(f"{text}\n\n{time.perf_counter() - start:.0f} s")
    if not is_quick:
        replace(root / "docs" / "performance.md", text)


def replace(path, text):
    """Writes the text between the two marks of a page."""
    before, rest = path.read_text().split(BEGIN + "\n", 1)
    path.write_text(f"{before}{BEGIN}\n{text}\n{END}{rest.split(END, 1)[1]}")


if __name__ == "__main__":
    main()
