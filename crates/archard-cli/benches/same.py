"""Whether two programs compute the same to the last bit: the proof of a change that moves code and no number.

    python3 same.py EARLIER PRESENT CASES [NAME...]

Runs every case of the folder CASES, or the named ones: by EARLIER on two threads, by PRESENT on one and on two, and by PRESENT from
where EARLIER was interrupted. Compares the last rows of their tables in hexadecimal. Ends with 1 where any differ. A run that
EARLIER began may be refused in words; such a refusal is shown.
"""

import csv
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

TABLES = ("history.csv", "contacts.csv", "displacements.csv")


def exact(cell):
    """A number to the last bit; other text as it is."""
    try:
        return float(cell).hex()
    except ValueError:
        return cell


def last_rows(folder):
    """Table and column -> value of the last row, of the tables that a run left."""
    values = {}
    for name in TABLES:
        path = folder / name
        if path.exists():
            with path.open(newline="") as file:
                rows = list(csv.DictReader(file))
            if rows:
                values |= {f"{name} {key}": exact(value) for key, value in rows[-1].items()}
    return values


def call(program, threads, cache, *arguments):
    environment = os.environ | {"RAYON_NUM_THREADS": str(threads), "XDG_CACHE_HOME": str(cache)}
    command = [program, "run", "--quiet", *map(str, arguments)]
    return subprocess.Popen(command, env=environment, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)


def run(program, threads, cache, *arguments):
    """What a run left to say; None where it ended well."""
    process = call(program, threads, cache, *arguments)
    said = process.communicate()[1]
    return said if process.returncode else None


def interrupted(programs, case, cache, folder, seconds):
    """By PRESENT from where EARLIER was stopped; None where it was never under way."""
    earlier, present = programs
    process = call(earlier, 2, cache, case, "--output", folder)
    time.sleep(seconds / 2)
    process.send_signal(signal.SIGINT)
    process.communicate()
    if process.returncode != 3 or not (folder / "case.toml").exists():
        return None
    said = run(present, 2, cache, "--resume", folder)
    return {"refused": said.strip().splitlines()[0]} if said else last_rows(folder)


def differences(before, after):
    return [key for key in before.keys() | after.keys() if before.get(key) != after.get(key)]


def compared(programs, case):
    """Words on each way of running the case, and whether all agree."""
    earlier, present = programs
    with tempfile.TemporaryDirectory() as place:
        place = Path(place)
        cache = place / "caches"
        begun = time.monotonic()
        failed = run(earlier, 2, cache, case, "--output", place / "earlier")
        seconds = time.monotonic() - begun
        if failed:
            return ["not run by the earlier program"], True
        before = last_rows(place / "earlier")
        words, same = [], True
        for threads in (1, 2):
            folder = place / f"present{threads}"
            failed = run(present, threads, cache, case, "--output", folder)
            off = ["failed: " + failed.strip()] if failed else differences(before, last_rows(folder))
            same &= not off
            words.append(f"{threads}: " + (", ".join(sorted(off)) or f"{len(before)} equal"))
        resumed = interrupted(programs, case, cache, place / "resumed", seconds)
        if resumed is None:
            words.append("resumed: ended before")
        elif "refused" in resumed:
            words.append("resumed: refused, " + resumed["refused"])
        else:
            off = differences(before, resumed)
            same &= not off
            words.append("resumed: " + (", ".join(sorted(off)) or "equal"))
        return words, same


def main():
    earlier, present, cases, *names = sys.argv[1:]
    found = sorted(case for case in Path(cases).iterdir() if not names or case.name in names)
    all_same = True
    for case in found:
        words, same = compared((earlier, present), case)
        all_same &= same
        print(f"{'same' if same else 'DIFFERS':8} {case.name:28} " + "; ".join(words), flush=True)
    sys.exit(not all_same)


if __name__ == "__main__":
    main()
