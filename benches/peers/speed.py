"""Measures whole runs beside numba loops and writes the table in docs/performance.md.

    speed.py ROOT [PROGRAM]

PROGRAM is another build of slipgap, whose times are printed beside those of this one and written nowhere.
"""

import json
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

import loops
from cases import N, alphas, gammas, study

# Name, problem, elements of a bar, cases, cases of the loop in a turn.
SWEEPS = [
    ("oscillators, 80 steps", "oscillator", None, 1_000_000, 40_000),
    ("bars, n = 10, 300 steps", "bars", N, 200_000, 4_000),
    ("bars, n = 40, 300 steps", "bars", 40, 60_000, 1_000),
]
TURNS = 5
BEGIN, END = "<!-- `make speed` writes this -->", "<!-- end -->"


def machine():
    """The processor, and how many cores of it this system has."""
    name = "a processor without a name"
    info = pathlib.Path("/proc/cpuinfo")
    if info.exists():
        found = re.search(r"model name\s*: (.*)", info.read_text())
        name = found.group(1).strip() if found else name
    flags = info.read_text() if info.exists() else ""
    width = "AVX-512" if "avx512f" in flags else "AVX2" if "avx2" in flags else "no AVX2"
    return f"{name}, {os.cpu_count()} cores, {width}"


def run(program, problem, n, count, threads):
    """Processor time and elapsed time of a run in seconds, and the bytes of its files."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "sweep.json"
        file.write_text(json.dumps(study(problem, count, n)))
        command = [program, "run", file, "--out", folder, "--jobs", str(threads), "--format", "parquet"]
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        subprocess.run(command, check=True, capture_output=True)
        elapsed = time.perf_counter() - start
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        files = pathlib.Path(folder, "sweep").rglob("*")
        size = sum(path.stat().st_size for path in files if path.is_file())
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, elapsed, size


def loop(problem, n, count):
    """Processor time of the numba loop for a case, in seconds."""
    sweep = (lambda: loops.numba_oscillator(alphas(count))) if problem == "oscillator" else (
        lambda: loops.numba_bars(gammas(count), n)
    )
    start = time.process_time()
    sweep()
    return (time.process_time() - start) / count


def measure(programs, name, problem, n, count, few):
    """The shortest of the turns of a sweep: for each program (processor time, seconds on one thread and on two, bytes), and the loop's time."""
    loop(problem, n, 10)
    found, numba = {program: [] for program in programs}, []
    for _ in range(TURNS):
        numba.append(loop(problem, n, few))
        for program in programs:
            (one, alone, size), (_, two, _) = (run(program, problem, n, count, j) for j in (1, 2))
            found[program].append((one, alone, two, size))
    # Other programs on the machine only make a run longer.
    shortest = {program: [min(x) for x in zip(*times)] for program, times in found.items()}
    return shortest, min(numba)


def main():
    root = pathlib.Path(sys.argv[1])
    own = root / "target" / "release" / "slipgap"
    programs = [own, *map(pathlib.Path, sys.argv[2:])]
    rows = []
    for name, problem, n, count, few in SWEEPS:
        shortest, numba = measure(programs, name, problem, n, count, few)
        for program, (one, alone, two, size) in shortest.items():
            rate = numba / (one / count)
            row = (
                f"| {name} | {count} | {numba * 1e6:.2f} | {one / count * 1e6:.3f} | {rate:.1f} | "
                f"{alone:.3f} | {two:.3f} | {alone / two:.2f} | {size / count:.0f} |"
            )
            if program == own:
                rows.append(row)
            else:
                print(f"{program}: {row}")
    table = "\n".join([
        "| Sweep | Cases | numba loop, µs a case | `slipgap run`, µs a case | times the rate of the loop "
        "| s on one thread | s on two threads | speed-up | bytes a case |",
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |",
        *rows,
    ])
    print(f"{machine()}\n\n{table}")
    replace(root / "docs" / "performance.md", f"{machine()}, the shortest of {TURNS} turns:\n\n{table}")


def replace(path, text):
    """Writes the text between the two marks of a page."""
    page = path.read_text()
    before, rest = page.split(BEGIN + "\n", 1)
    after = rest.split(END, 1)[1]
    path.write_text(f"{before}{BEGIN}\n{text}\n{END}{after}")


main()
