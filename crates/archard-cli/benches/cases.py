"""CPU time and effort of whole cases by two programs, as Markdown.

    python3 cases.py EARLIER PRESENT EARLIER_CASES PRESENT_CASES

Both run by turns, on one thread. A ratio is that of the shortest times; solves and applications of the compliance are counted,
and hold on any machine.
"""

import json
import math
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

TURNS = 3
# A run that takes longer (s) is timed once.
LONG = 5.0
# A ratio of times above which a row is named, and below which (s) the start of a process counts.
NAMED, SHORT = 1.1, 0.05
ONE_THREAD = {"RAYON_NUM_THREADS": "1"}
COUNTS = ("solves", "applications")

BODIES = """
[body.ball]
material = { young = "210 GPa", poisson = 0.3 }
profile.sphere = { radius = "50 mm" }
wear.archard = { coefficient = "1.33e-13 1/Pa" }
[body.flat]
material = { young = "210 GPa", poisson = 0.3 }
profile.flat = {}
[frame]
size = ["SIZE mm", "SIZE mm"]
elements = [COUNT, COUNT]
"""
MOTIONS = {
    "pressed": '[motion.indentation]\nload = "10.2 N"\n',
    "worn": '[motion.sliding]\nload = "10.2 N"\ndistance = "5 mm"\nstep = "0.5 mm"\n',
}
# The contact is 0.3 mm wide.
FRAMES = {"tight": "0.42", "wide": "1.2"}
ELEMENTS = (128, 256, 512, 1024)

FRAMES_HEAD = """## Whole cases against an earlier version

CPU time of whole processes by the earlier program and by this one, in turns on one thread, the shortest of three runs of each, \
one of those above 5 s; contact solves and applications of the compliance, before / now. Counts hold on any machine.

### Frames and elements

A ball on a flat, pressed, and worn in ten steps. The contact is 0.3 mm wide, a tight frame 0.42 mm and a wide one 1.2 mm. \
*Exponent* is the power of the number of elements by which the CPU time grew from the row above: 1 where four times the elements \
cost four times as much, 1.7 where they cost ten times.

| case | frame | n | earlier, CPU s | now, CPU s | now / earlier | exponent | solves | applications |
|---|---|---|---|---|---|---|---|---|"""
CASES_HEAD = """
### Published cases

The files of this version, most of which ask for an accuracy. The earlier program may refuse them: then both run *its own* file of \
that name, which gives frame, elements and steps, and the last columns are of this program on the file of this version. Where it \
has none, only they are filled.

| case | compared on | earlier, CPU s | now, CPU s | now / earlier | solves | applications | file of this version, CPU s | solves |
|---|---|---|---|---|---|---|---|---|"""


def once(program, case):
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


def timed(programs, case):
    """For each program the shortest CPU time and the counts; None of one that does not run the case."""
    best = [once(program, case) for program in programs]
    for _ in range(TURNS - 1):
        for side, program in enumerate(programs):
            if best[side] is not None and best[side][0] < LONG:
                best[side] = min(best[side], once(program, case), key=lambda result: result[0])
    return best


def counts(pair):
    """Two cells: what was counted before and now."""
    return [" / ".join(str(summary.get(key, "-")) for _, summary in pair) for key in COUNTS]


def above(name, pair):
    """What a row is named for, if it is slower than before: its ratios of time and of counts."""
    (earlier, was), (present, now) = pair
    if present < SHORT or present / earlier <= NAMED:
        return []
    ratios = [
        f"{now[key] / was[key]:.2f} of the {key}" for key in COUNTS if was.get(key) and now.get(key)
    ]
    counted = " and ".join(ratios) or "nothing that both count"
    return [f"- {name}: {present / earlier:.2f} of the CPU time, {counted}"]


def line(*cells):
    print("| " + " | ".join(cells) + " |", flush=True)


def frames(programs):
    """The table over frames and elements; the rows above the ratio that is named."""
    print(FRAMES_HEAD, flush=True)
    named = []
    for motion, text in MOTIONS.items():
        for frame, size in FRAMES.items():
            last = None
            for count in ELEMENTS:
                with tempfile.TemporaryDirectory() as folder:
                    case = Path(folder, "case.toml")
                    bodies = BODIES.replace("SIZE", size).replace("COUNT", str(count))
                    case.write_text(bodies + text)
                    pair = timed(programs, case)
                earlier, present = [result[0] for result in pair]
                grew = "" if last is None else f"{math.log(present / last, 4):.2f}"
                last = present
                times = [f"{earlier:.2f}", f"{present:.2f}", f"{present / earlier:.2f}", grew]
                line(motion, frame, str(count), *times, *counts(pair))
                named += above(f"{motion}, {frame}, {count}", pair)
    return named


def published(programs, earlier_cases, present_cases):
    """The table over the published cases; the rows above the ratio that is named."""
    print(CASES_HEAD, flush=True)
    named = []
    for case in sorted(path.parent for path in Path(present_cases).glob("*/case.toml")):
        pair, own, file = timed(programs, case), Path(earlier_cases, case.name), "its file"
        alone = pair[1]
        if pair[0] is None and (own / "case.toml").is_file():
            pair, file = timed(programs, own), "the earlier file"
        today = ["", ""] if alone is None else [f"{alone[0]:.2f}", str(alone[1].get("solves", "-"))]
        if None in pair:
            line(case.name, "-", *[""] * 5, *today)
            continue
        earlier, present = [result[0] for result in pair]
        times = [f"{earlier:.2f}", f"{present:.2f}", f"{present / earlier:.2f}"]
        line(case.name, file, *times, *counts(pair), *today)
        named += above(f"`{case.name}`, {file}", pair)
    return named


def main():
    earlier, present, earlier_cases, present_cases = sys.argv[1:]
    programs = [earlier, present]
    named = frames(programs) + published(programs, earlier_cases, present_cases)
    print(f"\n### Above {NAMED} times the earlier CPU time\n")
    print(f"Of runs above {SHORT} s. Where the counts grew as the time did, the run asks for more; otherwise each application does.\n")
    print("\n".join(named or ["None."]))


if __name__ == "__main__":
    main()
