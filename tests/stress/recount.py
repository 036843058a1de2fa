"""A slow, independent recount: how many points a submission may have at most.

Nothing of the grader is used here. An exercise is its own file and the exact trace of its inputs, whose graph says which
value was made from which others by the rule of which name; the rules are written once more in rules.py, in fractions. A
cell may have its points when it is right, within the tolerance, or when the right rule gives it on what the same
submission says of the values before it.

Where the grader is more careful than this (an early value that leaves nothing to compute, a wrong rule that is known), it
gives less. So this is a bound, and the cells that count as right are exact. What the grader knows in double precision
only (a root, a number of many digits) is doubted here in its tenth digit.

When an exercise is loaded, each rule has to give what the trace says on the trace's own values.
"""

import functools
import json
import re
from fractions import Fraction

from rules import RULES, Rounded

LONGEST_NUMBER = 400
LARGEST_EXPONENT = 400
MOST_WIDENING = 100  # tolerances that the rounding of operands may grant
LONGEST_EXACT = 20  # characters; longer numbers are carried on in double precision
DOUBT = Fraction(1, 10**9)  # of what is known in double precision, as a share of the numbers it was made from
DECIMAL = re.compile(r"[+-]?(?:(\d+)(?:\.(\d*))?|\.(\d+))(?:[eE]([+-]?\d+))?", re.ASCII)
INDEX = re.compile(r"\[([^]]*)\]")
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
        """How far from the value an answer may be; from a rounded one, never less than it is known to."""
        allowed = self.allowed(value)
        return max(allowed, DOUBT * max(1, abs(value))) if isinstance(value, Rounded) else allowed

    def allowed(self, value):
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


## Exercises


class Value:
    def __init__(self, entry, trace):
        self.name, self.kind, self.rule, self.operands = entry["name"], entry["kind"], entry["rule"], entry["from"]
        given, rounded = entry["value"], entry.get("approximate", [])
        texts = entry.get("homogeneous", given if isinstance(given, list) else [given])
        if self.kind == "point" and "homogeneous" not in entry:
            weight = Fraction(entry.get("weight", 1))
            scale = weight or 1  # a point of weight 0 has no coordinates but its homogeneous ones
            zeros = [0] * (3 - trace["dimension"])
            texts = [scale * Fraction(x) for x in texts] + zeros + [weight]
        rounded = range(len(texts)) if rounded is True else rounded  # those of double precision, or all
        self.right = tuple(Rounded(float(x)) if i in rounded else Fraction(x) for i, x in enumerate(texts))


def quotient(x, w):
    """x / w. What is known in double precision is divided in it, within its range."""
    try:
        return Rounded(float(x) / float(w)) if isinstance(x, Rounded) or isinstance(w, Rounded) else x / w
    except (OverflowError, ZeroDivisionError):
        return x / w


def as_doubles(numbers):
    """The numbers as far as double precision knows them; what is beyond its range stays."""
    try:
        return tuple(Rounded(float(x)) for x in numbers)
    except OverflowError:
        return numbers


class Part:
    def __init__(self, value, ask, exercise_tolerance, trace):
        self.value, self.name, self.kind = value, value.name, value.kind
        self.points = Fraction(str(ask["points"]))
        self.is_place = self.kind in ("point", "vector")
        self.form = ask.get("form", "affine")
        if self.kind == "vector" and trace["rational"] and self.form == "affine":
            self.form = "homogeneous"  # a difference of points has no coordinates but these
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
        if not self.is_place:
            return traced
        if self.form == "weight":
            return traced[3:]
        typed = traced[: self.dimension]
        if self.form == "homogeneous":
            return typed + traced[3:]
        if self.rational:
            return tuple(quotient(x, traced[3]) for x in typed) if traced[3] else None
        return typed

    def as_traced(self, typed, model):
        if not self.is_place:
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
        self.values = {entry["name"]: Value(entry, trace) for entry in trace["values"]}
        if len(self.values) != len(trace["values"]):
            raise SystemExit(f"{self.id}: two values of its trace have one name")
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
        self.inexact = {v.name for v in self.values.values() if any(isinstance(x, Rounded) for x in v.right)}
        self.check_rules()

    def check_rules(self):
        """Stops where a rule is missing or is not the trace's."""
        unknown = {v.rule for v in self.order} - set(RULES)
        if unknown:
            raise SystemExit(f"{self.id}: rules that the recount does not have: {sorted(unknown)}")
        for value in self.values.values():
            if value.rule not in RULES:
                continue
            operands = [self.values[o].right for o in value.operands]
            made = apply_rule(RULES[value.rule], operands)
            exact = self.inexact.isdisjoint([value.name, *value.operands])
            if made != value.right and (exact or not nearly_equal(made, value.right, operands)):
                said = f"{value.name} = {[str(x) for x in value.right]}"
                raise SystemExit(f"{self.id}: the rule {value.rule} does not give {said}, but {made}")


def apply_rule(rule, operands):
    """What the rule gives; None where it cannot be applied."""
    if None in operands:
        return None
    try:
        return rule(*operands)
    except ZeroDivisionError:
        return None


def nearly_equal(made, right, operands):
    """Whether two results are the same as far as double precision knows."""
    size = max([1, *(abs(x) for numbers in (right, *operands) for x in numbers)])
    return made is not None and len(made) == len(right) and all(abs(x - y) <= DOUBT * size for x, y in zip(made, right))


def selects(selector, name):
    """Whether P[1..2][*] selects P[1][0]."""
    if INDEX.sub("[]", selector) != INDEX.sub("[]", name):
        return False
    for want, index in zip(INDEX.findall(selector), INDEX.findall(name)):
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
        # What was made in double precision: their own value; what the rule gives.
        self.inexact, self.made_inexact = set(exercise.inexact), set(exercise.inexact)
        self.changed = set()
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
        made = apply_rule(rule, operands)
        is_inexact = any(o in self.inexact for o in value.operands) or any(isinstance(x, Rounded) for x in made or ())
        for names in (self.inexact, self.made_inexact):
            (names.add if is_inexact else names.discard)(value.name)
        self.expected[value.name] = as_doubles(made) if made and is_inexact else made
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
                there = apply_rule(rule, moved)
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
            if part.rational and part.form == "affine" and part.is_place:
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
            if part.is_place and part.rational and part.form == "affine":
                wide = [r / abs(expected[3]) for r in wide]
            most = MOST_WIDENING * max(part.tolerance.slack(x) for x in typed)
            wide = [min(r, most) for r in wide]
        if part.as_set:
            typed = sorted(typed)
        # What was carried on in double precision is known to nine digits of the largest number it was made from.
        doubt = Fraction(0)
        if name in self.made_inexact:
            made_from = [abs(x) for o in part.value.operands for x in self.own[o] or ()]
            doubt = DOUBT * max(1, *(abs(x) for x in typed), *made_from)
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
