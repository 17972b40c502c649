"""Times and memory of slipgap, and the rates of the machine."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

# A process begins with the memory of the one that starts it: that of these scripts is larger than what is measured.
MEASURE = """
import resource, subprocess, sys, time
start = time.perf_counter()
subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
print(time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1e3)
"""


class Slipgap:
    """The release build of the program and of what measures its parts."""

    def __init__(self, root):
        self.folder = pathlib.Path(root) / "target" / "release"

    def run(self, study, folder=None, *more, read=lambda results: None):
        """Seconds of a run on one thread from the study's file to its results, its largest memory in MB, and what is read."""
        with tempfile.TemporaryDirectory() as out:
            file = pathlib.Path(folder or out) / "study.json"
            file.write_text(json.dumps(study))
            command = [self.folder / "slipgap", "run", file, "--out", out, "--jobs", "1", *more]
            done = subprocess.run([sys.executable, "-c", MEASURE, *command], check=True, stdout=subprocess.PIPE, text=True)
            return *map(float, done.stdout.split()), read(pathlib.Path(out) / "study")

    def kernel(self, study):
        """Seconds of all cases in memory on one thread."""
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            json.dump(study, file)
            file.flush()
            return self.guard("kernel", file.name)[0]

    def guard(self, *words):
        done = subprocess.run([self.folder / "slipgap-guard", *map(str, words)], check=True, stdout=subprocess.PIPE, text=True)
        return [float(word) for word in done.stdout.split()]


def machine():
    """The processor, and how many cores of it this system has."""
    info = pathlib.Path("/proc/cpuinfo")
    text = info.read_text() if info.exists() else ""
    found = re.search(r"model name\s*: (.*)", text)
    name = found.group(1).strip() if found else "a processor without a name"
    width = "AVX-512" if "avx512f" in text else "AVX2" if "avx2" in text else "no AVX2"
    return f"{name}, {os.cpu_count()} cores, {width}"
