"""A slow, independent recount: how many points a submission may have at most.

Nothing of the grader is used here. An exercise is its own file and the exact trace of its inputs, whose graph says which
value was made from which others by the rule of which name; the rules are written here once more, in fractions. A cell
may have its points when it is right, within the tolerance, or when the right rule gives it on what the same submission
says of the values before it.

Where the grader is more careful than this (an early value that leaves nothing to compute, a wrong rule that is known), it
gives less. So this is a bound, and the cells that count as right are exact.
"""

import functools
import json
import re
from bisect import bisect_left, bisect_right
from fractions import Fraction

LONGEST_NUMBER = 400
LARGEST_EXPONENT = 400
MOST_WIDENING = 100  # tolerances that the rounding of operands may grant
LONGEST_EXACT = 20  # characters; longer numbers are carried on in double precision
DECIMAL = re.compile(r"[+-]?(?:(\d+)(?:\.(\d*))?|\.(\d+))(?:[eE]([+-]?\d+))?", re.ASCII)
FRACTION = re.compile(r"([+-]?\d+)/(\d+)", re.ASCII)


class Number(str):
    """A JSON number by its text."""


@functools.lru_cache(maxsize=200_000)
def parse_number(text):
    """The fraction a person typed, or None."""
    if len(text) > LONGEST_NUMBER:
        return None
    match = FRACTION.fullmatch(text)
    if match:
        below = int(match[2])
        return Fraction(int(match[1]), below) if below else None
    match = DECIMAL.fullmatch(text)
    if not match or (match[4] and abs(int(match[4])) > LARGEST_EXPONENT):
        return None
    number = Fraction(text)
    try:
        float(number)
    except OverflowError:
        return None
    return number


def no_duplicates(pairs):
    keys = dict(pairs)
    if len(keys) != len(pairs):
        raise ValueError("duplicate key")
    return keys


def refuse(word):
    raise ValueError(word)


def parse_json(data):
    """The document, numbers by their text; None where it is not to be read."""
    if len(data) > 65536 or b"\0" in data:
        return None
    try:
        text = data.decode("utf-8")
        if text.startswith("\ufeff"):
            text = text[1:]
        return json.loads(text, object_pairs_hook=no_duplicates, parse_float=Number, parse_int=Number, parse_constant=refuse)
    except (ValueError, RecursionError):
        return None


## Tolerances


def decimal_exponent(value):
    size = abs(value)
    e = len(str(size.numerator)) - len(str(size.denominator))
    while Fraction(10) ** e > size:
        e -= 1
    while Fraction(10) ** (e + 1) <= size:
        e += 1
    return e


class Tolerance:
    def __init__(self, text):
        self.kind, self.amount = ("exact", None) if text == "exact" else next(iter(text.items()))
        if self.kind in ("absolute", "relative"):
            self.amount = Fraction(str(self.amount))

    def slack(self, value):
        if self.kind == "exact":
            return Fraction(0)
        if self.kind == "decimals":
            return Fraction(1, 2) / 10 ** int(self.amount)
        if self.kind == "significant":
            return Fraction(1, 2) * Fraction(10) ** (decimal_exponent(value) - int(self.amount) + 1) if value else Fraction(0)
        return self.amount if self.kind == "absolute" else self.amount * abs(value)


def rounding_of(text):
    """How far the number meant may be from the decimal typed: half a unit of its last digit."""
    if "." not in text:
        return Fraction(0)
    mantissa, _, exponent = text.lower().partition("e")
    places = len(mantissa.split(".")[1])
    return Fraction(10) ** (int(exponent or 0) - places) / 2


## The rules. Operands and results are tuples of numbers: a point is (wx, wy, wz, w). None: it cannot be applied.


def blend(a, A, B):
    return tuple((1 - a[0]) * x + a[0] * y for x, y in zip(A, B))


def ratio(u, a, b):
    return None if a == b else ((u[0] - a[0]) / (b[0] - a[0]),)


def span(p, u, U):
    p, u, n = int(p[0]), u[0], len(U) - int(p[0]) - 2
    if p < 1 or n < p or u < U[p] or U[n + 1] < u:
        return None
    k = min(bisect_right(U, u) - 1, n)
    while k > p and not U[k] < U[k + 1]:
        k -= 1
    return (Fraction(k),)


def insert_knot(u, times, U):
    if times[0].denominator != 1 or not 0 <= times[0] <= 26:
        return None
    at = bisect_right(U, u[0])
    return tuple(U[:at]) + tuple(u) * int(times[0]) + tuple(U[at:])


def elevate_knots(p, times, U):
    p, times = int(p[0]), int(times[0])
    V = []
    for knot in sorted(set(U)):
        V += [knot] * (U.count(knot) + times)
    q, a, b = p + times, U[p], U[len(U) - p - 1]
    begin, end = bisect_right(V, a) - 1, bisect_left(V, b)
    return tuple(V[begin - q : end + q + 1])


RULES = {
    "blend": blend,
    "ratio": ratio,
    "span": span,
    "same": lambda A: A,
    "same_number": lambda a: a,
    "project": lambda A: tuple(x / A[3] for x in A) if A[3] else None,
    "multiplicity": lambda u, U: (Fraction(U.count(u[0])),),
    "last_knot": lambda u, U: (Fraction(bisect_right(U, u[0]) - 1),),
    "insert_knot": insert_knot,
    "elevate": lambda a, A, B: blend(a, B, A),
    "elevate_end": lambda A: A,
    "elevate_knots": elevate_knots,
    "fraction": lambda a, b: (a[0] / b[0],) if b[0] else None,
    "quotient": lambda a, b: (a[0] / b[0],) if b[0] else None,
    "sum": lambda a, b: (a[0] + b[0],),
    "total": lambda *a: (sum(x[0] for x in a),),
    "mean": lambda *a: (sum(x[0] for x in a) / len(a),),
    "gather": lambda *a: tuple(x for numbers in a for x in numbers),
}


class Value:
    def __init__(self, entry, dimension):
        self.name, self.kind, self.rule, self.operands = entry["name"], entry["kind"], entry["rule"], entry["from"]
        given = entry["value"]
        numbers = [Fraction(x) for x in (given if isinstance(given, list) else [given])]
        if self.kind == "point":
            weight = Fraction(entry.get("weight", 1))
            numbers = [weight * x for x in numbers] + [Fraction(0)] * (3 - dimension) + [weight]
        self.right = tuple(numbers)


class Part:
    def __init__(self, value, ask, exercise_tolerance, trace):
        self.value, self.name, self.kind = value, value.name, value.kind
        self.points = Fraction(str(ask["points"]))
        self.form = ask.get("form", "affine")
        self.as_set = ask.get("as") == "set"
        self.tolerance = Tolerance(ask.get("tolerance", exercise_tolerance))
        if self.kind == "integer":
            self.tolerance = Tolerance("exact")
        self.dimension, self.rational = trace["dimension"], trace["rational"]
        self.single = self.kind in ("integer", "scalar") or self.form == "weight"
        self.right = self.as_typed(value.right)
        if self.as_set:
            self.right = tuple(sorted(self.right))
        self.slacks = [self.tolerance.slack(x) for x in self.right]

    def as_typed(self, traced):
        if self.kind != "point":
            return traced
        if self.form == "weight":
            return traced[3:]
        typed = traced[: self.dimension]
        if self.form == "homogeneous":
            return typed + traced[3:]
        if self.rational:
            return tuple(x / traced[3] for x in typed) if traced[3] else None
        return typed

    def as_traced(self, typed, model):
        if self.kind != "point":
            return typed
        d = self.dimension
        if self.form == "weight":
            return tuple(x / model[3] * typed[0] for x in model[:3]) + typed if model[3] else None
        weight = typed[d] if self.form == "homogeneous" else model[3]
        scale = model[3] if self.form == "affine" and self.rational else 1
        return tuple(x * scale for x in typed[:d]) + model[d:3] + (weight,)

    def read(self, answer):
        """The texts of an answer of this part's shape and their numbers, or None."""
        if self.single:
            answer = [answer]
        elif self.as_set and isinstance(answer, dict):
            answer = answer["set"] if list(answer) == ["set"] else None
        if not isinstance(answer, list) or not all(isinstance(x, str) for x in answer):
            return None
        if self.kind != "list" and len(answer) != len(self.right):
            return None
        numbers = [parse_number(x) for x in answer]
        if None in numbers:
            return None
        pairs = sorted(zip(numbers, answer), key=lambda pair: pair[0]) if self.as_set else list(zip(numbers, answer))
        return [text for _, text in pairs], tuple(number for number, _ in pairs)

    def is_right(self, numbers):
        return len(numbers) == len(self.right) and all(
            abs(x - right) <= slack for x, right, slack in zip(numbers, self.right, self.slacks)
        )


class Exercise:
    def __init__(self, document, trace):
        self.id = document["id"]
        self.carried = Fraction(str(document.get("carried", 1)))
        partial = document.get("partial", {})
        self.consolation = max(Fraction(str(partial.get(key, 0))) for key in ("misconception", "slip"))
        self.values = {entry["name"]: Value(entry, trace["dimension"]) for entry in trace["values"]}
        self.parts = []
        for ask in document["ask"]:
            for name, value in self.values.items():
                if value.rule != "input" and selects(ask["value"], name):
                    self.parts.append(Part(value, ask, document.get("tolerance", "exact"), trace))
        self.part_of = {part.name: part for part in self.parts}
        self.max_points = sum(part.points for part in self.parts)
        needed = set(self.part_of)
        for value in reversed(list(self.values.values())):
            if value.name in needed:
                needed.update(value.operands)
        self.order = [v for v in self.values.values() if v.name in needed and v.rule != "input"]
        unknown = {v.rule for v in self.order} - set(RULES)
        if unknown - {"distance"}:  # of given points, which nobody can change
            raise SystemExit(f"{self.id}: rules that the recount does not have: {sorted(unknown)}")


def selects(selector, name):
    """Whether P[1..2][*] selects P[1][0]."""
    if re.sub(r"\[.*", "", selector) != re.sub(r"\[.*", "", name):
        return False
    wanted, indices = re.findall(r"\[([^]]*)\]", selector), re.findall(r"\[([^]]*)\]", name)
    if len(wanted) != len(indices):
        return False
    for want, index in zip(wanted, indices):
        low, _, high = want.partition("..")
        if want != "*" and not int(low) <= int(index) <= int(high or low):
            return False
    return True


class Replay:
    """A run with somebody's own values put in: what each value is for them, what the rule gives, how far it is known."""

    def __init__(self, exercise, given, right, rules=RULES):
        self.rules = rules
        self.own = {v.name: v.right for v in exercise.values.values()}
        self.expected = dict(self.own)
        self.rounding, self.expected_rounding = {}, {}
        self.changed, self.inexact = set(), set()
        for value in exercise.order:
            name = value.name
            if value.rule in rules and (rules is not RULES or any(o in self.changed for o in value.operands)):
                self.apply(value)
            if name in right:
                self.own[name] = value.right
            elif name in given:
                self.put_in(exercise.part_of[name], *given[name])
            elif self.expected[name] != value.right:
                self.own[name], self.rounding[name] = self.expected[name], self.expected_rounding.get(name)
            if self.own[name] != value.right:
                self.changed.add(name)

    def apply(self, value):
        rule = self.rules[value.rule]
        operands = [self.own[o] for o in value.operands]
        if any(o in self.inexact for o in value.operands):
            self.inexact.add(value.name)
        made = None if None in operands else rule(*operands)
        self.expected[value.name] = made
        radii = [self.rounding.get(o) for o in value.operands]
        if made is None or not any(radii):
            return
        rounding = [Fraction(0)] * len(made)
        for i, radius in enumerate(radii):
            for j, r in enumerate(radius or ()):
                if not r or j >= len(operands[i]):
                    continue
                moved = list(operands)
                moved[i] = operands[i][:j] + (operands[i][j] + r,) + operands[i][j + 1 :]
                there = rule(*moved)
                if there is not None and len(there) == len(made):
                    rounding = [a + abs(x - y) for a, x, y in zip(rounding, there, made)]
        self.expected_rounding[value.name] = rounding

    def put_in(self, part, texts, numbers, rounded):
        name = part.name
        carried_on = []
        for text, x in zip(texts, numbers):
            if len(text) > LONGEST_EXACT or "e" in text.lower():
                self.inexact.add(name)
                x = Fraction(float(x))
            carried_on.append(x)
        made = part.as_traced(tuple(carried_on), self.expected[name] or part.value.right)
        if made is None:
            return
        self.own[name] = made
        if rounded and part.tolerance.kind != "exact" and part.form != "weight":
            radius = [min(rounding_of(t), part.tolerance.slack(x)) for t, x in zip(texts, numbers)]
            if part.form == "homogeneous":  # the weight is typed behind two or three coordinates
                radius[part.dimension : part.dimension] = [Fraction(0)] * (3 - part.dimension)
            radius += [Fraction(0)] * (len(made) - len(radius))
            if part.rational and part.form == "affine" and part.kind == "point":
                radius = [r * abs(made[3]) for r in radius]
            self.rounding[name] = radius

    def allows(self, part, numbers):
        """Whether the right rule on their own operands may give this."""
        expected, name = self.expected[part.name], part.name
        if expected is None or not any(o in self.changed for o in part.value.operands):
            return False
        typed = part.as_typed(expected)
        if typed is None or len(typed) != len(numbers):
            return False
        wide = [Fraction(0)] * len(typed)
        if part.tolerance.kind != "exact" and part.form != "weight" and self.expected_rounding.get(name):
            wide = list(self.expected_rounding[name])
            if part.form == "homogeneous":
                wide = wide[: part.dimension] + wide[3:]
            if part.kind == "point" and part.rational and part.form == "affine":
                wide = [r / abs(expected[3]) for r in wide]
            most = MOST_WIDENING * max(part.tolerance.slack(x) for x in typed)
            wide = [min(r, most) for r in wide]
        if part.as_set:
            typed = sorted(typed)
        # What was carried on in double precision is known to nine digits of the largest number it was made from.
        doubt = Fraction(0)
        if name in self.inexact:
            made_from = [abs(x) for o in part.value.operands for x in self.own[o] or ()]
            doubt = Fraction(1, 10**9) * max(1, *(abs(x) for x in typed), *made_from)
        for x, right, more in zip(numbers, typed, wide):
            # The allowance itself is computed in double precision.
            if abs(x - right) > (part.tolerance.slack(right) + more) * (1 + Fraction(1, 10**9)) + doubt:
                return False
        return True


class Recount:
    """Of one submission: the parts that are right, those that may be carried, and the points it may have at most."""

    def __init__(self, exercise, data):
        self.right, self.may_carry, self.bound = set(), set(), Fraction(0)
        document = parse_json(data)
        self.readable = (
            isinstance(document, dict)
            and isinstance(document.get("answers"), dict)
            and document.get("schema") == "blossom.answers/1"
            and not isinstance(document.get("schema"), Number)
            and document.get("exercise") == exercise.id
        )
        if not self.readable:
            return
        read = {}
        for part in exercise.parts:
            if part.name in document["answers"]:
                typed = part.read(document["answers"][part.name])
                if typed is not None:
                    read[part.name] = typed
                    if part.is_right(typed[1]):
                        self.right.add(part.name)
        open_parts = [part for part in exercise.parts if part.name in read and part.name not in self.right]
        if open_parts:
            self.replay(exercise, read, open_parts)
        for part in exercise.parts:
            if part.name in self.right:
                self.bound += part.points
            elif part.name in read:
                share = max(exercise.carried if part.name in self.may_carry else 0, exercise.consolation)
                self.bound += share * part.points

    def replay(self, exercise, read, open_parts):
        meant, written = {}, {}
        for name, (texts, numbers) in read.items():
            part = exercise.part_of[name]
            if part.kind == "list" and (len(numbers) != len(part.right) or list(numbers) != sorted(numbers)):
                continue
            if name not in self.right:
                meant[name] = (texts, numbers, True)
            if name not in self.right or part.tolerance.kind != "exact":
                written[name] = (texts, numbers, False)
        # A right answer stands for the right value, which need not be what was typed; then for what was typed.
        as_meant = Replay(exercise, meant, self.right)
        left = [p for p in open_parts if not as_meant.allows(p, read[p.name][1])]
        self.may_carry = {p.name for p in open_parts} - {p.name for p in left}
        if left:
            as_written = Replay(exercise, written, self.right - set(written))
            self.may_carry |= {p.name for p in left if as_written.allows(p, read[p.name][1])}
