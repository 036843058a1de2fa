#!/usr/bin/env python3
"""Grades many generated submissions in one run and checks each grade against an independent recount.

usage: stress.py PROGRAMS COUNT [SEED]

PROGRAMS is the folder of `blossom` and `blossom-grade`. Submissions to the shipped exercises are made (generate.py) and
recounted (recount.py) by two processes while `blossom-grade stream` grades them. It must give a line for each, in order,
lose none, give no submission more than the recount allows, and call exactly those cells right that the recount does.
Lines that break this are kept in build/stress/failures.jsonl. The same count and seed make the same submissions.
"""

import collections
import json
import multiprocessing
import os
import pathlib
import queue
import random
import re
import resource
import subprocess
import sys
import tempfile
import threading
import time
from fractions import Fraction

sys.dont_write_bytecode = True  # the sources stay as they are
import generate  # noqa: E402
import recount  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_IN_BLOCK = 500  # submissions to one exercise in a row
BLOCKS_AHEAD = 40
LOST = re.compile(r"\bdied\b|\btoo long\b|\blonger than\b|memory")
MOST_FAILURES = 50

Expected = collections.namedtuple("Expected", "kind student readable bound right may_carry max_points line")


def load_exercises(programs):
    """Shipped exercises whose numbers are the same for all."""
    exercises = []
    for file in sorted((ROOT / "exercises").glob("[0-9]*.json")):
        document = json.loads(file.read_text(), parse_float=recount.Number)
        if "vary" in document:
            continue
        inputs = json.dumps(json.loads(file.read_text())["inputs"])
        command = [programs / "blossom", "trace", "--algorithm", document["algorithm"], "--inputs", "-", "--exact"]
        trace = subprocess.run([*command, "--format", "json"], input=inputs, text=True, capture_output=True, check=True)
        exercises.append((file, recount.Exercise(document, json.loads(trace.stdout))))
    return exercises


def as_line(choose, student, data):
    """The submission as a line of a stream: in the line's own object, or as a string where it is text."""
    head = b'{"student": "%s", "submission": ' % student.encode()
    try:
        text = data.decode()
        if b"\n" in data or b"\r" in data or choose.random() < 0.4:
            return head + json.dumps(text, ensure_ascii=choose.random() < 0.5).encode() + b"}", data
    except UnicodeDecodeError:
        pass
    data = data.replace(b"\n", b" ").replace(b"\r", b" ")
    if choose.random() < 0.5 and data.startswith(b'{"schema"'):
        line = b'{"student": "%s", ' % student.encode() + data[1:]
        return line, data
    return head + data + b"}", data


def make_block(seed, index, exercise, count):
    """The lines of a block and what is expected of their grades."""
    generator = generate.Generator(exercise, f"{seed}/{index}")
    choose = random.Random(f"{seed}/{index}/lines")
    lines, expected = [], []
    for i in range(count):
        student = f"s{index}-{i}"
        kind, data = generator.make()
        line, data = as_line(choose, student, data)
        counted = recount.Recount(exercise, data)
        readable = kind in generator.READABLE
        sets = frozenset(counted.right), frozenset(counted.may_carry)
        expected.append(Expected(kind, student, readable, counted.bound, *sets, exercise.max_points, line))
        lines.append(line)
    return b"\n".join(lines) + b"\n", expected


EXERCISES = []  # in the processes that make blocks: inherited when they are forked


def work(task):
    seed, index, count = task
    return make_block(seed, index, EXERCISES[index % len(EXERCISES)][1], count)


def problem_of(grade, expected):
    """What is wrong with a grade, or None."""
    reason = grade.get("reason", "")
    if LOST.search(reason):
        return "the grader lost it: " + reason
    if grade.get("student", expected.student) != expected.student:
        return "somebody else's grade stands there"
    points = Fraction(str(grade["points"]))
    parts = grade["parts"]
    nearly = Fraction(1, 10**9)  # points are printed as decimals
    if points > expected.bound + nearly:
        return f"{float(points)} points, but the recount allows {float(expected.bound)}"
    if abs(sum(Fraction(str(part["points"])) for part in parts) - points) > nearly:
        return "the parts' points do not add up"
    if reason:
        return f"refused: {reason}" if expected.readable else None
    if not parts:
        return "neither parts nor a reason"
    right = {part["value"] for part in parts if part["verdict"] == "correct"}
    if right != expected.right:
        return f"right differently: {sorted(right ^ expected.right)}"
    carried = {part["value"] for part in parts if part["verdict"] == "carried"}
    if not carried <= expected.may_carry:
        return f"carried, but not by the recount: {sorted(carried - expected.may_carry)}"
    if expected.kind == "right" and points != expected.max_points:
        return "a right submission without full marks"
    return None


class Run:
    def __init__(self, programs, count, seed):
        self.count, self.seed = count, seed
        EXERCISES[:] = load_exercises(programs)
        self.block = max(1, min(MOST_IN_BLOCK, count // len(EXERCISES)))  # so that each exercise has its turn
        self.folder = ROOT / "build" / "stress"
        self.folder.mkdir(parents=True, exist_ok=True)
        self.pending = queue.Queue(maxsize=BLOCKS_AHEAD)
        self.ahead = threading.Semaphore(BLOCKS_AHEAD)
        self.failures, self.kinds, self.verdicts = [], collections.Counter(), collections.Counter()
        self.full_marks = 0
        self.reached_bound = 0
        with tempfile.NamedTemporaryFile("w", suffix=".json", dir=self.folder, delete=False) as assignment:
            json.dump(self.assignment(), assignment)
        self.assignment_file = assignment.name
        self.pool = multiprocessing.get_context("fork").Pool(2)
        self.grader = subprocess.Popen(
            [programs / "blossom-grade", "stream", assignment.name, "--now", "2026-01-01T00:00:00Z"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        )

    def assignment(self):
        items = [{"file": str(os.path.relpath(file, self.folder)), "points": float(e.max_points)} for file, e in EXERCISES]
        return {"schema": "blossom.assignment/1", "id": "stress", "title": "Stress", "exercises": items}

    def tasks(self):
        for index, start in enumerate(range(0, self.count, self.block)):
            self.ahead.acquire()  # so that nothing piles up where one side is slower
            yield self.seed, index, min(self.block, self.count - start)

    def feed(self):
        try:
            for lines, expected in self.pool.imap(work, self.tasks()):
                self.pending.put(expected)
                self.grader.stdin.write(lines)
                self.ahead.release()
            self.grader.stdin.close()
        except Exception as error:  # the main thread must not wait for ever
            self.pending.put(error)
            self.grader.kill()
            raise

    def check(self, line, expected):
        self.kinds[expected.kind] += 1
        try:
            grade = json.loads(line)
            problem = problem_of(grade, expected)
        except (ValueError, KeyError) as error:
            grade, problem = {}, f"no grade: {error!r}"
        if problem:
            self.failures.append((problem, expected, line))
            return
        self.verdicts.update(part["verdict"] for part in grade["parts"])
        self.verdicts["(refused)"] += "reason" in grade
        self.full_marks += grade["score"] == 1
        self.reached_bound += expected.bound > 0 and Fraction(str(grade["points"])) >= expected.bound - Fraction(1, 10**9)

    def run(self):
        threading.Thread(target=self.feed, daemon=True).start()
        done = 0
        while done < self.count and len(self.failures) < MOST_FAILURES:
            block = self.pending.get()
            if isinstance(block, Exception):
                break
            for expected in block:
                line = self.grader.stdout.readline()
                if not line:
                    self.failures.append(("no more lines came", expected, b""))
                    break
                self.check(line, expected)
                done += 1
        more = b"" if self.failures else self.grader.stdout.read()
        self.grader.stdout.close()
        status = self.grader.wait()
        self.pool.terminate()
        os.unlink(self.assignment_file)
        if not self.failures and (more or done != self.count or status != 0):
            self.failures.append((f"{done} lines of {self.count}, then {more[:80]!r}, status {status}", None, b""))
        return done

    def report(self, done, seconds):
        kinds = ", ".join(f"{kind} {n}" for kind, n in sorted(self.kinds.items()))
        verdicts = ", ".join(f"{verdict} {n}" for verdict, n in sorted(self.verdicts.items()))
        memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024
        print(f"{done} submissions to {len(EXERCISES)} exercises in {seconds:.0f} s, seed {self.seed}; full marks: {self.full_marks};")
        print(f"as many points as the recount allows: {self.reached_bound}; largest process: {memory} MiB")
        print(f"kinds: {kinds}\nverdicts: {verdicts}")
        kept = self.folder / "failures.jsonl"
        with kept.open("wb") as file:
            for problem, expected, line in self.failures:
                kind = expected.kind if expected else "run"
                print(f"FAILED ({kind}): {problem}")
                if expected:
                    file.write(expected.line + b"\n" + line)
        if self.failures:
            print(f"the lines and their grades are in {kept}")


def main():
    if len(sys.argv) not in (3, 4):
        raise SystemExit(__doc__)
    programs, count = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2])
    seed = sys.argv[3] if len(sys.argv) == 4 else str(random.SystemRandom().randrange(10**9))
    start = time.monotonic()
    run = Run(programs, count, seed)
    done = run.run()
    run.report(done, time.monotonic() - start)
    return 1 if run.failures else 0


if __name__ == "__main__":
    sys.exit(main())
