"""Submissions that students and attackers might hand in: right ones, mutations of right ones, and garbage.

Each has a kind. Of some kinds more is known than the recount's bound: `right` must have full marks, and of what is in
READABLE no submission may be refused as a whole.
"""

import functools
import json
import random
from fractions import Fraction

import recount
from rules import RULES, blend, cox_rising, ratio

ATTACKS = [
    "<script>alert(1)</script>", "\"><img src=x onerror=alert(1)>", "=cmd|' /C calc'!A0", "+1+1", "-1+1", "@SUM(A1)",
    "\u001b[31mred\u001b[2J", "\u009b2J", "\u0000", "\u202etxt.exe", "\u2028", "a\r\nScore: 100", "%n%n%s", "'; DROP TABLE",
    "../../etc/passwd", "{{7*7}}", "${IFS}", "\x7f\x08\x08", "\ufeff", "\U0001f480" * 20, "P[1][0]" * 30,
]
HUGE = ["9" * 400, "9" * 401, "1e308", "1.8e308", "1e400", "-1e-400", "1e-401", "1/" + "7" * 398, "1e99999999999",
        "0." + "3" * 398, "123456789012345678901", "1e21", "-0", "1/0", "00000001", "1e+05", "5.", ".5", "+3", " 3", "0x10", "NaN"]


@functools.lru_cache(maxsize=100_000)
def decimal(x, places):
    """x to so many decimals, as text."""
    scaled = round(abs(x) * 10**places)
    digits = str(scaled).rjust(places + 1, "0")
    text = digits[:-places] + "." + digits[-places:] if places else digits
    return ("-" if x < 0 and scaled else "") + text


def first_of(A, *_):
    return A


def second_of(_, A, *__):
    return A


def one_more(rule):
    """The rule for a count or an index, one too high."""
    return lambda *operands: tuple(x + 1 for x in RULES[rule](*operands) or (0,))


def opposite(rule):
    return lambda *operands: tuple(-x for x in RULES[rule](*operands) or ())


def exchanged(rule, i, j):
    """The rule with two of its operands exchanged."""

    def wrong(*operands):
        operands = list(operands)
        operands[i], operands[j] = operands[j], operands[i]
        return RULES[rule](*operands)

    return wrong


def added(*operands):
    return tuple(sum(numbers) for numbers in zip(*operands))


# What somebody may take for a rule, by the rule's name.
WRONG_RULES = {
    "blend": [exchanged("blend", 1, 2), lambda a, A, B: blend((1,), A, B), lambda a, A, B: RULES["midpoint"](A, B)],
    "between_points": [exchanged("blend", 1, 2), second_of],
    "middle_of": [exchanged("blend", 1, 2), lambda a, A, B: added(A, B)],
    "midpoint": [first_of, added],
    "half_way": [first_of, added],
    "blend_slopes": [exchanged("blend", 1, 2), lambda a, A, B: RULES["midpoint"](A, B)],
    "elevate": [blend],
    "ratio": [exchanged("ratio", 1, 2), lambda u, a, b: (u[0] - a[0],), first_of],
    "span": [one_more("span")],
    "piece_of": [one_more("piece_of")],
    "multiplicity": [one_more("multiplicity")],
    "sign_changes": [one_more("sign_changes")],
    "project": [lambda A: A[:3] + (Fraction(1),)],
    "shadow": [first_of, lambda A: A[:2] + (Fraction(1),) + A[3:]],
    "lift": [first_of, lambda A, w: A[:2] + (A[2] * w[0],) + A[3:]],
    "fraction": [lambda a, b: (a[0] / (b[0] + 1),), lambda a, b: (1 - a[0] / b[0],)],
    "quotient": [exchanged("quotient", 0, 1), first_of],
    "mean": [first_of],
    "product_sum": [lambda *pairs: RULES["product_sum"](*pairs[:2]), added],
    "largest": [RULES["smallest"], added],
    "smallest": [RULES["largest"]],
    "insert_knot": [lambda u, times, U: U],
    "remove_knot": [lambda u, U: U, lambda u, U: tuple(x for x in U if x != u[0])],
    "inner_knots": [first_of, lambda U: U[1:]],
    "unite_knots": [first_of, second_of, lambda U, V: tuple(sorted(U + V))],
    "spread_knot": [lambda u, t, h: (u[0] - t[0] * h[0],), lambda u, t, h: (u[0] + t[0],)],
    "nearest_knot": [lambda u, a, b: (max(u[0] - a[0], b[0] - u[0]),), lambda u, a, b: (b[0] - a[0],)],
    "mirror": [lambda a, b, u: (b[0] - u[0],), lambda a, b, u: u],
    "span_share": [lambda i, m, a, b: (i[0] / m[0],), lambda i, m, a, b: (i[0] / (m[0] + 1) * (b[0] - a[0]),)],
    "step_back": [added],
    "span_length": [second_of],
    "share_of": [exchanged("share_of", 0, 1), first_of],
    "blend_numbers": [exchanged("blend_numbers", 1, 2), lambda u, a, b: (u[0] * (a[0] + b[0]),)],
    "rest_of": [RULES["part_of"], second_of],
    "part_of": [RULES["rest_of"], second_of],
    "tensor_product": [added, first_of],
    "basis_times_weight": [added, first_of],
    "cox_rising": [RULES["cox_falling"], lambda u, a, b, N: ratio(u, a, b)],
    "cox_falling": [RULES["cox_rising"], lambda u, a, b, N: ratio(u, b, a)],
    "cox_de_boor": [lambda u, a, b, N, c, d, M: cox_rising(u, a, b, N), exchanged("cox_de_boor", 3, 6)],
    "basis": [lambda j, q, v, V: RULES["basis"]((j[0] + 1,), q, v, V), lambda j, q, v, V: (1 / (q[0] + 1),)],
    "share": [second_of],
    "multiple": [second_of],
    "weigh_point": [second_of],
    "add_share": [lambda T, a, A: added(T, A), lambda T, a, A: A],
    "add_multiple": [lambda T, a, A: added(T, A), lambda T, a, A: A],
    "add_weighed": [lambda T, a, A: added(T, A), lambda T, a, A: A],
    "reduce": [RULES["add_multiple"], first_of],
    "divide": [first_of, lambda A, d: RULES["multiple"](d, A)],
    "divide_vector": [first_of, lambda A, d: RULES["multiple"](d, A)],
    "horner_vector": [lambda A, u, B: added(A, B), lambda A, u, B: blend(u, A, B)],
    "horner_point": [lambda A, u, B: added(A, B), lambda A, u, B: blend(u, A, B)],
    "slope_factor": [exchanged("slope_factor", 1, 2), lambda p, a, b: p, lambda p, a, b: ((p[0] + 1) / (b[0] - a[0]),)],
    "velocity": [exchanged("velocity", 1, 2), lambda c, A, B: RULES["velocity"]((1,), A, B)],
    "control_slope": [exchanged("control_slope", 3, 4), lambda q, a, b, A, B: RULES["control_slope"]((1,), a, b, A, B)],
    "take_product": [first_of, lambda X, b, w, D: RULES["take_product"](X, (1,), w, D), opposite("take_product")],
    "chord_slope": [exchanged("chord_slope", 0, 1), lambda A, B, w: RULES["towards"](B, A)],
    "continue_slope": [first_of, second_of, exchanged("continue_slope", 0, 1)],
    "third_ahead": [lambda A, w, V: RULES["add_share"](A, w, V), RULES["third_back"]],
    "third_back": [lambda A, w, V: RULES["reduce"](A, w, V), RULES["third_ahead"]],
    "unblend_end": [exchanged("unblend_end", 1, 2), RULES["unblend_begin"], blend],
    "unblend_begin": [exchanged("unblend_begin", 1, 2), RULES["unblend_end"], blend],
    "boolean_sum": [added, lambda A, B, C: added(A, B)],
    "side_of": [opposite("side_of"), lambda A, B, Q: Q[1:2]],
    "stand_up": [first_of],
    "move_along": [first_of, added],
    "swing": [lambda P, T, a: RULES["swing"](P, T, (2 * a[0],)), lambda P, T, a: T],
    "cosine": [RULES["sine"], opposite("cosine")],
    "sine": [RULES["cosine"], opposite("sine")],
    "gap": [lambda A, B: (sum(abs(x - y) for x, y in zip(A, B)),)],
}


class Generator:
    def __init__(self, exercise, seed):
        self.exercise = exercise
        self.random = random.Random(seed)
        self.right = {part.name: list(part.right) for part in exercise.parts}

    ## Numbers as they may be typed

    def exactly(self, x):
        """A JSON literal whose value is x."""
        if x.denominator == 1 and self.random.random() < 0.6:
            return self.random.choice([str(x.numerator), f"{x.numerator}.0", f'"{x.numerator}"'])
        rest = x.denominator
        for factor in (2, 5):
            while rest % factor == 0:
                rest //= factor
        if rest == 1 and x.denominator < 10**6 and self.random.random() < 0.7:
            text = decimal(x, 20).rstrip("0").rstrip(".")
            return text + "0" * self.random.randrange(3) if "." in text else text
        factor = self.random.choice([1, 1, 1, 2, 10])
        return f'"{x.numerator * factor}/{x.denominator * factor}"'

    def nearly(self, x, part, slack):
        """A literal within the tolerance, or x itself."""
        if part.tolerance.kind == "exact" or not slack or self.random.random() < 0.3:
            return self.exactly(x)
        if part.tolerance.kind == "decimals":
            return decimal(x, int(part.tolerance.amount) + self.random.randrange(3))
        off = slack * Fraction(self.random.randint(-100, 100), 100)  # the boundary included
        return self.exactly(x + off)

    def literal(self, part, numbers, write):
        texts = [write(x, i) for i, x in enumerate(numbers)]
        if part.single:
            return texts[0]
        if part.as_set and self.random.random() < 0.5:
            self.random.shuffle(texts)
        inside = "[" + ", ".join(texts) + "]"
        return '{"set": ' + inside + "}" if part.as_set and self.random.random() < 0.5 else inside

    def answers(self, numbers):
        """Literals of all parts, exactly as the numbers say."""
        return {
            part.name: self.literal(part, numbers[part.name], lambda x, _: self.exactly(x))
            for part in self.exercise.parts
            if numbers.get(part.name) is not None
        }

    def right_answers(self):
        return {
            part.name: self.literal(part, part.right, lambda x, i, part=part: self.nearly(x, part, part.slacks[i]))
            for part in self.exercise.parts
        }

    def document(self, answers, exercise=None):
        items = list(answers.items())
        if self.random.random() < 0.3:
            self.random.shuffle(items)
        body = ", ".join(f"{json.dumps(name)}: {literal}" for name, literal in items)
        return (
            f'{{"schema": "blossom.answers/1", "exercise": {json.dumps(exercise or self.exercise.id)}, '
            f'"answers": {{{body}}}}}'
        )

    def some_part(self):
        return self.random.choice(self.exercise.parts)

    ## Kinds: each gives the text (str, or bytes that are no UTF-8) of a submission

    def make_right(self):
        return self.document(self.right_answers())

    def make_changed_number(self):
        answers = self.right_answers()
        for _ in range(self.random.choice([1, 1, 1, 2, 3])):
            part = self.some_part()
            numbers = list(part.right)
            i = self.random.randrange(len(numbers))
            change = self.random.randrange(6)
            if change == 0:
                numbers[i] = -numbers[i]
            elif change == 1:
                numbers[i] += self.random.choice([-1, 1, Fraction(1, 10), Fraction(-1, 100), Fraction(1, 10**6)])
            elif change == 2:
                self.random.shuffle(numbers)
            elif change == 3:
                digits = list(decimal(numbers[i], 3))
                places = [at for at, c in enumerate(digits) if c.isdigit()]
                digits[self.random.choice(places)] = self.random.choice("0123456789")
                numbers[i] = Fraction("".join(digits))
            elif change == 4:
                numbers = [-x for x in numbers]
            else:  # just on the wrong side of the tolerance, or just on the right one
                numbers[i] += (part.slacks[i] or 0) + Fraction(self.random.choice([-1, 1, 0]), 10**9)
            answers[part.name] = self.literal(part, numbers, lambda x, _: self.exactly(x))
        return self.document(answers)

    def make_carried(self):
        """An early error and everything after it recomputed, exactly or rounded."""
        given = {}
        for _ in range(self.random.choice([1, 1, 2])):
            part = self.some_part()
            off = self.random.choice([0, 1, -1, Fraction(1, 2), 2, Fraction(1, 7)])
            numbers = tuple(x + off if self.random.random() < 0.7 else self.random.choice([0 * x, x, -x]) for x in part.right)
            if part.kind == "integer":
                numbers = (part.right[0] + self.random.choice([-1, 1]),)
            given[part.name] = ([str(x) for x in numbers], numbers, False)
        return self.recomputed(given, RULES)

    def make_wrong_rule(self):
        """One rule applied wrongly, throughout."""
        rules = dict(RULES)
        present = sorted({value.rule for value in self.exercise.order} & set(WRONG_RULES))
        if present:
            name = self.random.choice(present)
            rules[name] = self.random.choice(WRONG_RULES[name])
        return self.recomputed({}, rules)

    def recomputed(self, given, rules):
        replay = recount.Replay(self.exercise, given, set(), rules)
        places = self.random.choice([None, None, 2, 3, 4, 6])
        answers = {}
        for part in self.exercise.parts:
            own = replay.own[part.name]
            typed = part.as_typed(own) if own is not None else None
            if typed is None:
                continue
            write = lambda x, _: self.exactly(x) if places is None else decimal(x, places)
            answers[part.name] = self.literal(part, typed, write)
        return self.document(answers)

    def make_missing(self):
        answers = self.right_answers()
        for name in self.random.sample(sorted(answers), self.random.randint(1, len(answers))):
            del answers[name]
        return self.document(answers)

    def make_extra(self):
        answers = self.right_answers()
        for _ in range(self.random.choice([1, 3, 40])):
            key = self.random.choice([v for v in self.exercise.values] + ATTACKS + [f"P[{self.random.randrange(9)}][9]", "", "C "])
            if key not in answers:
                answers[key] = self.random.choice(["1", "[0, 0]", '"x"', "null", "{}"])
        return self.document(answers)

    def make_mangled_names(self):
        answers = {}
        for name, literal in self.right_answers().items():
            mangle = self.random.choice([str, str.lower, str.upper, lambda s: s.replace("][", ","), lambda s: s + " ",
                                         lambda s: s.replace("[", "(").replace("]", ")"), lambda s: s.replace("[1]", "[01]")])
            answers[mangle(name)] = literal
        return self.document(answers)

    def make_wrong_types(self):
        answers = self.right_answers()
        for _ in range(self.random.choice([1, 2, 5])):
            answers[self.some_part().name] = self.random.choice(
                ["null", "true", "[]", "{}", '""', "[[]]", '[["1", 2]]', '{"set": 1}', '{"set": [1], "x": 2}', '["1", null]',
                 "[1]", "[1, 2, 3, 4, 5]", '"one"', json.dumps(self.random.choice(ATTACKS)), "[" * 20 + "]" * 20])
        return self.document(answers)

    def make_huge_numbers(self):
        answers = self.right_answers()
        for _ in range(self.random.choice([1, 2, 20])):
            part = self.some_part()
            huge = lambda x, _: json.dumps(self.random.choice(HUGE))
            answers[part.name] = self.literal(part, part.right, huge)
        return self.document(answers)

    def make_wrong_exercise(self):
        return self.document(self.right_answers(), self.random.choice(["nothing", "", "de-casteljau ", "DE-BOOR"] + ATTACKS))

    def make_duplicate_keys(self):
        text = self.make_right()
        part = self.some_part()
        at = text.index('"answers": {') + len('"answers": {')
        return text[:at] + f"{json.dumps(part.name)}: 0, " + text[at:]

    def make_attack(self):
        answers = self.right_answers()
        attack = json.dumps(self.random.choice(ATTACKS))
        answers[self.some_part().name] = attack
        text = self.document(answers)
        return text[:-1] + f', {attack}: {attack}}}' if self.random.random() < 0.5 else text

    def make_deep(self):
        depth = self.random.choice([28, 40, 1000, 20000])
        return self.document({self.some_part().name: "[" * depth + "]" * depth})

    def make_many_values(self):
        return self.document({self.some_part().name: "[" + "0," * self.random.choice([100, 4085, 5000]) + "0]"})

    def make_half_a_file(self):
        text = self.make_right()
        return text[: self.random.randrange(len(text))]

    def make_garbage(self):
        data = bytearray(self.make_right().encode())
        for _ in range(self.random.choice([1, 1, 2, 10])):
            at = self.random.randrange(len(data))
            change = self.random.randrange(4)
            if change == 0:
                data[at] = self.random.randrange(256)
            elif change == 1:
                del data[at]
            elif change == 2:
                data.insert(at, self.random.randrange(256))
            else:
                data[at:at] = data[at : at + self.random.randrange(60)]
        return bytes(data)

    def make_noise(self):
        return bytes(self.random.randrange(256) for _ in range(self.random.randrange(200)))

    KINDS = {
        "right": 20, "changed_number": 18, "carried": 14, "wrong_rule": 10, "missing": 4, "extra": 4, "mangled_names": 3,
        "wrong_types": 5, "huge_numbers": 4, "wrong_exercise": 2, "duplicate_keys": 2, "attack": 3, "deep": 1,
        "many_values": 1, "half_a_file": 3, "garbage": 5, "noise": 1,
    }  # fmt: skip
    READABLE = {"right", "changed_number", "carried", "wrong_rule", "missing", "mangled_names"}

    def make(self):
        kind = self.random.choices(list(self.KINDS), list(self.KINDS.values()))[0]
        text = getattr(self, "make_" + kind)()
        return kind, text.encode("utf-8", "surrogatepass") if isinstance(text, str) else text
