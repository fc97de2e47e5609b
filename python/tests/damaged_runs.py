# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command on files of the corpus: what each run has to be like, whatever the file.

As a program: python damaged_runs.py [--files N] [--seed N] [--at-once N] [--keep FOLDER]
"""

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from corpus import DamagedFile, corpus

MOST_MEMORY = 1 << 30
MOST_SECONDS = 10.0
_GIVEN_UP_AFTER = 120.0

# One process for one run, which says at its end how much time and memory it and its children took.
_MEASURED = """
import resource, subprocess, sys
code = subprocess.run(sys.argv[2:]).returncode
used = resource.getrusage(resource.RUSAGE_CHILDREN)
open(sys.argv[1], "w").write(f"{used.ru_utime + used.ru_stime} {used.ru_maxrss}")
sys.exit(code if code >= 0 else 128 - code)
"""


def fault_of_a_run(file: DamagedFile, folder: Path) -> tuple[str, str]:
    """What is wrong with a run, empty where nothing is, and how it ended."""
    source, target, used = folder / file.name, folder / "out.ply", folder / "used"
    source.write_bytes(file.content)
    words = [sys.executable, "-P", "-m", "laplacian_simplify", "simplify", str(source), str(target), "--percent", "50"]
    try:
        done = subprocess.run(
            [sys.executable, "-S", "-c", _MEASURED, str(used), *words],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=_GIVEN_UP_AFTER,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return "it did not end", ""
    seconds, kilobytes = map(float, used.read_text().split())
    said = done.stderr.decode(errors="replace")
    return _fault(done.returncode, said, target.exists(), seconds, kilobytes * 1024, folder), said


def _fault(code: int, said: str, written: bool, seconds: float, memory: float, folder: Path) -> str:
    if code not in (0, 1):
        return f"exit code {code}"
    if written != (code == 0):
        return "a file was written" if written else "no file was written"
    lines = said.splitlines()
    if code == 1 and len(lines) != 1:
        return f"{len(lines)} lines"
    if code == 1 and not lines[0].startswith(f"laplacian-simplify: error: {folder}"):
        return "the file is not named"
    for words in ("Traceback", "internal error", "crashed", "please report"):
        if words in said:
            return words
    if any(not line.startswith("laplacian-simplify: ") for line in lines):
        return "a line that is none of the command's"
    if seconds > MOST_SECONDS:
        return f"{seconds:.0f} s"
    return f"{memory / 2**20:.0f} MB" if memory > MOST_MEMORY else ""


def faults(files: Iterable[DamagedFile], at_once: int, counts: Counter[str]) -> list[tuple[DamagedFile, str, str]]:
    """The files whose runs were not as they have to be; counts gets how the others ended."""

    def run(file: DamagedFile) -> tuple[DamagedFile, str, str]:
        with tempfile.TemporaryDirectory() as folder:
            return file, *fault_of_a_run(file, Path(folder))

    found = []
    with ThreadPoolExecutor(at_once) as pool:
        for file, fault, said in pool.map(run, files):
            counts["fault" if fault else "refused" if "error:" in said else "read"] += 1
            if fault:
                found.append((file, fault, said))
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--files", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=2)
    parser.add_argument("--at-once", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--keep", type=Path, help="keep the files with faults in this folder")
    options = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    counts: Counter[str] = Counter()
    start, wrong = time.monotonic(), 0
    files = list(corpus(options.files, options.seed))
    for first in range(0, len(files), 100):
        for number, (file, fault, said) in enumerate(faults(files[first : first + 100], options.at_once, counts)):
            wrong += 1
            print(f"{file.name}: {fault}: {said.strip()[:300]}", flush=True)
            if options.keep:
                options.keep.mkdir(parents=True, exist_ok=True)
                (options.keep / f"{first}_{number}_{file.name}").write_bytes(file.content)
        print(f"{first + 100} files, {time.monotonic() - start:.0f} s: {dict(counts)}", flush=True)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
