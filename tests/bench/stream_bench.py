#!/usr/bin/env python3
"""How fast `blossom-grade stream` is, end to end, from JSON Lines in a file to JSON Lines in another.

    stream_bench.py BLOSSOM_GRADE [--lines N] [--repeat N] [--memory-lines N]

Prints a table: exercises of 6, 13 and 57 asked values, all right and all wrong, with one and with two workers (and one
core for each, where the machine has them); the best of the repeats, for others may be using the machine. Beside it the
processor time of all processes together, per line, which others disturb less: cores / time is what a machine does that
is used by nobody else. Then the memory at 1,000 lines and at many: the largest sum, over all processes, of what each
has for itself and its share of what is shared (PSS), and of all that it sees (RSS).

The lines are the same in every run: the submissions are made of the exercise's trace, in exact decimals.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from fractions import Fraction as F


def de_boor(knots, points, degree, u):
    """The values of de Boor's triangle, named as in the trace: k, alpha[r][i], P[r][i]."""
    k = max(i for i in range(len(knots) - 1) if knots[i] <= u)
    values = {"k": k}
    level = {i: points[i] for i in range(k - degree, k + 1)}
    triangle = {}
    for r in range(1, degree + 1):
        following = {}
        for i in range(k - degree + r, k + 1):
            alpha = (u - knots[i]) / (knots[i + degree - r + 1] - knots[i])
            values[f"alpha[{r}][{i}]"] = alpha
            following[i] = [(1 - alpha) * a + alpha * b for a, b in zip(level[i - 1], level[i])]
            triangle[f"P[{r}][{i}]"] = following[i]
        level = following
    values.update(triangle)
    return values


POINTS = [[10, 0], [0, 0], [0, 20], [30, 20], [30, 0], [15, 0], [15, 10],
          [3, -4], [-7, 2], [8, 8], [1, 9], [4, 6], [5, 5]]


def exercise(asked):
    """An exercise of so many asked values, and their right values."""
    degree = {6: 3, 13: 3, 57: 7}[asked]
    inner = [F(1, 4), F(1, 2), F(3, 4)]
    knots = [F(0)] * (degree + 1) + inner + [F(1)] * (degree + 1)
    count = len(knots) - degree - 1
    points = [[F(x) for x in p] for p in POINTS[:count]]
    right = de_boor(knots, points, degree, F(2, 5))
    if asked == 6:
        ask = [{"value": "P[1..3][*]", "points": 2}]
        right = {name: value for name, value in right.items() if name.startswith("P")}
    else:
        ask = [{"value": "k", "points": 1}, {"value": "alpha[*][*]", "points": 1},
               {"value": f"P[1..{degree}][*]", "points": 2}]
    number = lambda x: str(x) if x.denominator > 1 else int(x)
    document = {
        "schema": "blossom.exercise/1", "id": f"de-boor-{asked}", "title": "De Boor",
        "prompt": "Compute the point at u = 2/5.", "algorithm": "de_boor",
        "inputs": {"curve": {"degree": degree, "knots": [number(k) for k in knots],
                             "points": [[number(c) for c in p] for p in points]}, "u": "2/5"},
        "ask": ask, "tolerance": {"decimals": 3}, "feedback": "hint"}
    return document, right


def typed(x):
    return int(x) if isinstance(x, int) or x.denominator == 1 else round(float(x), 5)


def line(document, right, student, wrong):
    """All right; or every value off by an amount that no rule gives and that differs from value to value."""
    answers = {}
    for place, (name, value) in enumerate(right.items()):
        off = F(137 + 29 * place + student % 89, 1000) if wrong else 0
        one = lambda x: typed(x + (1 if name == "k" and wrong else off))
        answers[name] = [one(c) for c in value] if isinstance(value, list) else one(value)
    return json.dumps({"student": f"s{student:07}", "submitted": "2026-10-01T21:59:00Z",
                       "schema": "blossom.answers/1", "exercise": document["id"], "answers": answers}) + "\n"


def write_lines(path, document, right, wrong, count):
    """Blocks of 1000 different lines, again and again."""
    block = "".join(line(document, right, student, wrong) for student in range(min(count, 1000))).encode()
    with open(path, "wb") as file:
        for begin in range(0, count, 1000):
            file.write(block if count - begin >= 1000 else b"\n".join(block.split(b"\n")[:count - begin]) + b"\n")
    return len(block) / min(count, 1000)


def run(program, exercise_file, lines_file, jobs, out):
    """Seconds by the clock, and of all processes' processor time."""
    cores = sorted(os.sched_getaffinity(0))[:jobs]
    used = lambda: sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])
    begin, before = time.monotonic(), used()
    subprocess.run([program, "stream", exercise_file, "--input", lines_file, "--output", out, "--jobs", str(jobs)],
                   check=True, preexec_fn=lambda: os.sched_setaffinity(0, cores))
    return time.monotonic() - begin, used() - before


def processes_of(pid):
    found = [pid]
    try:
        with open(f"/proc/{pid}/task/{pid}/children") as file:
            for child in file.read().split():
                found += processes_of(int(child))
    except OSError:
        pass
    return found


def memory_of(pid):
    sums = {"Rss": 0, "Pss": 0}
    for process in processes_of(pid):
        try:
            with open(f"/proc/{process}/smaps_rollup") as file:
                for row in file:
                    if row.split(":")[0] in sums:
                        sums[row.split(":")[0]] += int(row.split()[1])
        except OSError:
            pass
    return sums


def peak_memory(program, exercise_file, lines_file, jobs, out):
    child = subprocess.Popen([program, "stream", exercise_file, "--input", lines_file, "--output", out, "--jobs",
                              str(jobs)])
    peak = {"Rss": 0, "Pss": 0}
    while child.poll() is None:
        for kind, value in memory_of(child.pid).items():
            peak[kind] = max(peak[kind], value)
        time.sleep(0.002)
    return peak


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--lines", type=int, default=200_000, help="of right submissions; a tenth of wrong ones")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--memory-lines", type=int, default=1_000_000)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = lambda name: os.path.join(folder, name)
        print(f"{'asked':>5} {'answers':>8} {'bytes/line':>10} {'cores':>5} {'lines/s':>9} {'cpu us':>9} "
              f"{'cores/cpu us':>12}")
        for asked in (6, 13, 57):
            document, right = exercise(asked)
            with open(path("exercise.json"), "w") as file:
                json.dump(document, file)
            for wrong in (False, True):
                count = given.lines // 10 if wrong else given.lines
                size = write_lines(path("lines.jsonl"), document, right, wrong, count)
                for jobs in (1, 2):
                    times = [run(given.program, path("exercise.json"), path("lines.jsonl"), jobs, path("out.jsonl"))
                             for _ in range(given.repeat)]
                    best, used = min(t[0] for t in times), min(t[1] for t in times)
                    print(f"{len(right):>5} {'wrong' if wrong else 'right':>8} {size:>10.0f} {jobs:>5} "
                          f"{count / best:>9.0f} {used / count * 1e6:>9.1f} {jobs * count / used:>12.0f}", flush=True)
        document, right = exercise(13)
        with open(path("exercise.json"), "w") as file:
            json.dump(document, file)
        print(f"\n{'lines':>9} {'PSS MiB':>8} {'RSS MiB':>8}   all processes together, two workers")
        for count in (1000, given.memory_lines):
            write_lines(path("lines.jsonl"), document, right, False, count)
            peak = peak_memory(given.program, path("exercise.json"), path("lines.jsonl"), 2, path("out.jsonl"))
            print(f"{count:>9} {peak['Pss'] / 1024:>8.1f} {peak['Rss'] / 1024:>8.1f}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
