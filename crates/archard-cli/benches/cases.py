"""CPU time and effort of whole cases by two programs: a section of the book's page on performance.

    python3 cases.py EARLIER PRESENT CASES

Both run every case of the folder CASES, by turns, on one thread. A ratio is that of the shortest times; solves and applications
of the compliance are counted, and hold on any machine.
"""

import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

TURNS = 3
HEAD = """## Whole cases against an earlier version

CPU time by the earlier program and by this one, in turns on one thread, the shortest of three runs of each; how many \
contacts were solved, in how many iterations and applications of the compliance, before / now. Counts hold on any machine. \
`just bench-cases REVISION` writes this table.

| case | earlier, CPU s | present / earlier | solves | iterations | applications |
|---|---|---|---|---|---|"""
ONE_THREAD = {"RAYON_NUM_THREADS": "1"}


def run(program, case):
    """CPU seconds of a run and its summary; None where the program does not end it."""
    with tempfile.TemporaryDirectory() as folder:
        output, caches = Path(folder, "out"), Path(folder, "caches")
        command = [program, "run", str(case), "--quiet", "--output", str(output)]
        environment = os.environ | ONE_THREAD | {"XDG_CACHE_HOME": str(caches)}
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        ended = subprocess.run(command, env=environment, capture_output=True, check=False)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if ended.returncode != 0:
            return None
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return seconds, json.loads((output / "summary.json").read_text())


def row(programs, case):
    """A line of the table: the times, and what was counted before and now."""
    turns = [[run(program, case) for program in programs] for _ in range(TURNS)]
    if any(result is None for turn in turns for result in turn):
        return f"| {case.name} | | not run by both | | | |"
    earlier, present = [min(turn[side][0] for turn in turns) for side in (0, 1)]
    summaries = [result[1] for result in turns[0]]
    counts = [
        " / ".join(str(summary.get(key, "-")) for summary in summaries)
        for key in ("solves", "iterations", "applications")
    ]
    return f"| {case.name} | {earlier:.2f} | {present / earlier:.2f} | " + " | ".join(counts) + " |"


def main():
    earlier, present, cases = sys.argv[1:]
    print(HEAD, flush=True)
    for case in sorted(Path(cases).iterdir()):
        if (case / "case.toml").is_file():
            print(row([earlier, present], case), flush=True)


if __name__ == "__main__":
    main()
