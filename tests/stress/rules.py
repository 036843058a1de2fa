"""The rules by which algorithms make their values, once more and in fractions: from what a rule is said to do, nothing
of the engine.

Operands and results are tuples of numbers: a number alone is a tuple of one, a point or a vector is (wx, wy, wz, w), a
list of knots is as long as it is. None, or a division by zero, says that a rule cannot be applied to these operands.
"""

from bisect import bisect_left, bisect_right
from fractions import Fraction
from math import cos, isqrt, radians

MOST_COPIES = 26  # of a knot
MOST_DEGREE = 25
LARGEST_ANGLE = 10**6  # of degrees, in size: of larger ones there is no cosine


class Rounded(Fraction):
    """A number that is no fraction, but near the one meant: what is made of it is known in double precision only."""


def root(x):
    """The square root: exact where it is a fraction."""
    if x < 0:
        return None
    above, below = isqrt(x.numerator), isqrt(x.denominator)
    if above * above == x.numerator and below * below == x.denominator:
        return Fraction(above, below)
    return Rounded(isqrt(x.numerator * x.denominator * 10**40), x.denominator * 10**20)


def number(made):
    return None if made is None else (made,)


def whole(a):
    """The integer that a number is, or None: somebody may have typed a fraction for a count."""
    return int(a[0]) if a[0].denominator == 1 and abs(a[0]) <= 10**9 else None


## Points and vectors


def plus(A, B, times=1):
    """A + times B, weights like coordinates."""
    return tuple(x + times * y for x, y in zip(A, B))


def scaled(A, factor):
    return tuple(factor * x for x in A)


def weighing(A, w):
    """The coordinates of A over the weight w."""
    return (*A[:3], Fraction(w))


def dot(A, B):
    return sum(x * y for x, y in zip(A[:3], B[:3]))


def length(A):
    return number(root(dot(A, A)))


def unit(A):
    """A made one long."""
    size = root(dot(A, A))
    return weighing([type(size)(x / size) for x in A[:3]], 0)


def cross(A, B):
    (a, b, c), (x, y, z) = A[:3], B[:3]
    return (b * z - c * y, c * x - a * z, a * y - b * x, Fraction(0))


def project(A):
    return scaled(A, 1 / A[3])


def blend(a, A, B):
    return plus(scaled(A, 1 - a[0]), B, a[0])


def same(A):
    return A


def sum_of(A, a, B):
    """One term more of a sum of points by their shares."""
    return plus(A, B, a[0])


def times(a, A):
    return scaled(A, a[0])


def over(A, a):
    return scaled(A, 1 / a[0])


def difference(A, B):
    return plus(A, B, -1)


def half_way(A, B):
    return scaled(plus(A, B), Fraction(1, 2))


def without(A, m, B):
    return plus(A, B, -m[0])


def distance(A, B):
    return length(difference(project(A), project(B)))


def gap(A, B):
    """The distance of two points of four coordinates."""
    way = difference(A, B)
    return number(root(sum(x * x for x in way)))


def side_of(A, B, Q):
    """Twice the area of the triangle A, B, Q, with its sign, for A and B with the weight 1."""
    return (cross(difference(B, A), difference(project(Q), A))[2],)


## Numbers


def ratio(u, a, b):
    return ((u[0] - a[0]) / (b[0] - a[0]),)


def blend_numbers(u, a, b):
    return (a[0] + u[0] * (b[0] - a[0]),)


def product(a, b):
    return (a[0] * b[0],)


def quotient(a, b):
    return (a[0] / b[0],)


def minus(a, b):
    return (a[0] - b[0],)


def sign_changes(*numbers):
    """How often the sign changes along the numbers. What is a billionth of the largest one or less has none."""
    values = [a[0] for a in numbers]
    least = max(abs(x) for x in values) / 10**9
    signs = [x > 0 for x in values if abs(x) > least]
    return (Fraction(sum(a != b for a, b in zip(signs, signs[1:]))),)


def product_sum(*pairs):
    return (sum(a[0] * b[0] for a, b in zip(pairs[::2], pairs[1::2])),)


def share_of(a, b):
    return (a[0] / (a[0] + b[0]),)


def span_share(i, m, a, b):
    """The i-th of the points that cut [a, b] into m equal parts."""
    return ((a[0] * (m[0] - i[0]) + b[0] * i[0]) / m[0],)


def count_arcs(angle):
    """The fewest arcs of no more than a right angle, up to a whole turn."""
    return (Fraction(min(max(-(-angle[0] // 90), 1), 4)),)


def half_arc(angle, arcs):
    n = whole(arcs)
    return None if n is None or not 0 < n < 1000 else (angle[0] / n / 2,)


def cosine(degrees):
    """Exact where it is a fraction: at the multiples of 60 and of 90 degrees (Niven)."""
    if abs(degrees) >= LARGEST_ANGLE:
        return None
    near = cos(radians(degrees % 360))
    is_exact = degrees % 60 == 0 or degrees % 90 == 0
    return Fraction(round(2 * near), 2) if is_exact else Rounded(near)


## Knots


def is_ascending(U):
    return all(a <= b for a, b in zip(U, U[1:]))


def span(p, u, U):
    """Of the spans in the domain, the one that u lies in or begins; at the domain's end the last that is not empty."""
    p, u, n = int(p[0]), u[0], len(U) - int(p[0]) - 2
    if p < 1 or n < p or u < U[p] or U[n + 1] < u:
        return None
    k = min(bisect_right(U, u) - 1, n)
    while k > p and not U[k] < U[k + 1]:
        k -= 1
    return (Fraction(k),)


def piece_of(p, t, U):
    """The span of t, or of the end of the domain that is nearer to it."""
    first, last = U[int(p[0])], U[len(U) - int(p[0]) - 1]
    return span(p, (min(max(t[0], first), last),), U) if first < last else None


def insert_knot(u, count, U):
    if whole(count) is None or not 0 <= count[0] <= MOST_COPIES:
        return None
    at = bisect_right(U, u[0])
    return tuple(U[:at]) + tuple(u) * int(count[0]) + tuple(U[at:])


def remove_knot(u, U):
    """The knots without the last one that is not above u."""
    at = bisect_right(U, u[0])
    return tuple(U[: max(at - 1, 0)]) + tuple(U[at:])


def elevate_knots(p, more, U):
    p, more = int(p[0]), int(more[0])
    V = []
    for knot in sorted(set(U)):
        V += [knot] * (U.count(knot) + more)
    q, a, b = p + more, U[p], U[len(U) - p - 1]
    begin, end = bisect_right(V, a) - 1, bisect_left(V, b)
    return tuple(V[begin - q : end + q + 1])


def unite_knots(U, V):
    """Each knot as often as the one of the two lists has it that has it more often."""
    if not is_ascending(U) or not is_ascending(V):
        return None
    return tuple(knot for knot in sorted({*U, *V}) for _ in range(max(U.count(knot), V.count(knot))))


def bump(j, q, u, V):
    """The basis function j of degree q at u, by its definition (The NURBS Book, 2.5) with 0/0 = 0: the limit from the
    right at a knot, and from the left at the last one."""
    if not V[j] <= u <= V[j + q + 1]:
        return Fraction(0)
    if q == 0:
        ends_here = u == V[-1] and V[j] < V[j + 1] == V[-1]
        return Fraction(V[j] <= u < V[j + 1] or ends_here)
    rises, falls = V[j + q] - V[j], V[j + q + 1] - V[j + 1]
    up = (u - V[j]) / rises * bump(j, q - 1, u, V) if rises else 0
    down = (V[j + q + 1] - u) / falls * bump(j + 1, q - 1, u, V) if falls else 0
    return Fraction(up + down)


def is_a_basis(j, q, v, V):
    j, degree = whole(j), whole(q)
    fits = j is not None and degree is not None and 1 <= degree <= MOST_DEGREE and 0 <= j < len(V) - degree - 1
    return fits and span(q, v, V) is not None


def basis(j, q, v, V):
    return (bump(int(j[0]), int(q[0]), v[0], V),) if is_a_basis(j, q, v, V) else None


def basis_slope(j, q, v, V):
    """The derivative of a basis function (The NURBS Book, 2.7)."""
    if not is_a_basis(j, q, v, V):
        return None
    j, q, slope = int(j[0]), int(q[0]), Fraction(0)
    for i, sign in ((j, 1), (j + 1, -1)):
        if V[i + q] != V[i]:
            slope += sign * q * bump(i, q - 1, v[0], V) / (V[i + q] - V[i])
    return (slope,)


def cox_rising(u, a, b, N):
    return (ratio(u, a, b)[0] * N[0],)


def cox_falling(u, a, b, N):
    return (ratio(u, b, a)[0] * N[0],)


def cox_de_boor(u, a, b, N, c, d, M):
    return (cox_rising(u, a, b, N)[0] + cox_falling(u, c, d, M)[0],)


def slope_factor(p, a, b):
    return (p[0] / (b[0] - a[0]),)


## Points that are made of others in a way of their own


def unblend_end(a, C, A):
    """X such that C = (1 - a) A + a X."""
    return plus(A, difference(C, A), 1 / a[0])


def unblend_begin(a, C, B):
    """X such that C = (1 - a) X + a B."""
    return plus(B, difference(C, B), 1 / (1 - a[0]))


def control_slope(q, a, b, A, B):
    return scaled(difference(B, A), slope_factor(q, a, b)[0])


def take_product(X, b, w, D):
    return plus(X, D, -b[0] * w[0])


def move_along(P, T):
    """The sum of two points in space, with the product of their weights."""
    return weighing(plus(scaled(P, T[3]), T, P[3]), P[3] * T[3])


def swing(P, T, a):
    """P, whose x is its distance from the z-axis, in the direction and at a times the distance of T; at P's height."""
    return (a[0] * P[0] * T[0], a[0] * P[0] * T[1], P[2] * T[3], P[3] * T[3])


def foot(P, A, B):
    """The point of the line A B, given by points of weight 1, that is nearest to P; weighed like P."""
    if A[3] != 1 or B[3] != 1:
        return None
    way = difference(B, A)
    return plus(scaled(A, P[3]), way, dot(difference(P, scaled(A, P[3])), way) / dot(way, way))


def quarter_turn(A, B, L, X):
    if A[3] != 1 or B[3] != 1:
        return None
    return scaled(cross(difference(B, A), X), 1 / L[0])


def on_circle(O, X, Y, c, s):
    return weighing(plus(plus(O, X, c[0]), Y, s[0]), O[3])


def tangent_corner(O, r, c, s, w):
    return (w[0] * O[0] + r[0] * c[0], w[0] * O[1] + r[0] * s[0], w[0] * O[2], w[0] * O[3])


def unit_tangent(C, E):
    """The direction of the derivative of C / w, where E is the derivative of C."""
    return unit(difference(scaled(E, C[3]), scaled(C, E[3]))) if C[3] else None


def first_normal(t):
    """Level and at right angles to t, to its left; the x-axis where t is upright but for rounding."""
    upright = dot(t[:2], t[:2]) < Fraction(1, 10**20)
    return unit((Fraction(1), Fraction(0), Fraction(0)) if upright else (-t[1], t[0], Fraction(0)))


def mirror_vector(a, d):
    """a mirrored in the plane that d is at right angles to; a itself where d is nothing but rounding."""
    square = dot(d, d)
    return a if square < Fraction(1, 10**24) else weighing(plus(a, d, -2 * dot(a, d) / square), 0)


def place_in_frame(P, X, t, n, b):
    """The coordinates of P along the frame's n, b and t, counted from X."""
    made = scaled(X, P[3])
    for along, axis in zip(P[:3], (n, b, t)):
        made = plus(made, axis, along)
    return weighing(made, P[3])


RULES = {
    # copies under another name
    **dict.fromkeys(["same", "same_number", "same_vector", "elevate_end", "relabel", "reparametrize", "renumber"], same),
    **dict.fromkeys(["put_into_net", "tensor_whole_sum"], same),
    # means of two points
    **dict.fromkeys(["blend", "between_points", "middle_of", "blend_slopes"], blend),
    "elevate": lambda a, A, B: blend(a, B, A),
    **dict.fromkeys(["midpoint", "half_way"], half_way),
    # sums of points by their shares, and elimination
    **dict.fromkeys(["share", "multiple", "weigh_point"], times),
    **dict.fromkeys(["add_share", "add_multiple", "add_weighed"], sum_of),
    "reduce": without,
    **dict.fromkeys(["divide", "divide_vector"], over),
    "add_net": plus,
    "subtract_net": difference,
    "boolean_sum": lambda A, B, C: difference(plus(A, B), C),
    "unblend_begin": unblend_begin,
    "unblend_end": unblend_end,
    # a curve in powers of u: only its first coefficient is a point
    "leading_vector": lambda A: weighing(A, 0),
    "horner_vector": lambda A, u, B: weighing(plus(A, B, u[0]), 0),
    "horner_point": lambda A, u, B: weighing(plus(A, B, u[0]), 1),
    # derivatives
    "slope_factor": slope_factor,
    "velocity": lambda c, A, B: weighing(scaled(difference(B, A), c[0]), 1),
    "control_slope": control_slope,
    "take_product": take_product,
    "chord_slope": lambda A, B, w: weighing(scaled(difference(A, B), 1 / w[0]), 0),
    "continue_slope": lambda A, B: weighing(difference(scaled(A, 2), B), 0),
    "third_ahead": lambda A, w, V: weighing(plus(A, V, w[0] / 3), A[3]),
    "third_back": lambda A, w, V: weighing(plus(A, V, -w[0] / 3), A[3]),
    # weights
    "project": project,
    "weight_of": lambda A: A[3:],
    "lift": lambda A, w: weighing(scaled(A, w[0]), A[3]),
    "shadow": lambda A: weighing(scaled(A, 1 / A[2]), A[3]),
    # angles
    "cosine": lambda angle: number(cosine(angle[0])),
    "sine": lambda angle: number(cosine(angle[0] - 90)),
    # lengths and sides
    "distance": distance,
    "gap": gap,
    "length": length,
    "root": lambda a: number(root(a[0])),
    "side_of": side_of,
    "sign_changes": sign_changes,
    # numbers
    "ratio": ratio,
    "blend_numbers": blend_numbers,
    "rest_of": lambda u, a: ((1 - u[0]) * a[0],),
    **dict.fromkeys(["part_of", "part_of_gap", "basis_times_weight", "tensor_product", "angle_times"], product),
    **dict.fromkeys(["fraction", "quotient"], quotient),
    "sum": lambda a, b: (a[0] + b[0],),
    "total": lambda *a: (sum(x[0] for x in a),),
    "mean": lambda *a: (sum(x[0] for x in a) / len(a),),
    "largest": lambda *a: max(a),
    "smallest": lambda *a: min(a),
    **dict.fromkeys(["step_back", "step_width"], minus),
    **dict.fromkeys(["sweep", "span_length"], lambda a, b: minus(b, a)),
    "product_sum": product_sum,
    "reduce_number": lambda a, m, b: (a[0] - m[0] * b[0],),
    "share_of": share_of,
    "span_share": span_share,
    "nearest_knot": lambda u, a, b: (min(u[0] - a[0], b[0] - u[0]),),
    **dict.fromkeys(["spread_knot", "arc_angle"], lambda u, t, h: (u[0] + t[0] * h[0],)),
    "mirror": lambda a, b, u: (a[0] + b[0] - u[0],),
    "within": lambda e, tolerance, rounding: (Fraction(e[0] <= tolerance[0] + rounding[0]),),
    # knots and basis functions
    "span": span,
    "piece_of": piece_of,
    "multiplicity": lambda u, U: (Fraction(U.count(u[0])),),
    "last_knot": lambda u, U: (Fraction(bisect_right(U, u[0]) - 1),),
    "gather": lambda *a: tuple(x for numbers in a for x in numbers),
    "insert_knot": insert_knot,
    "remove_knot": remove_knot,
    "inner_knots": lambda U: U[1:-1],
    "elevate_knots": elevate_knots,
    "unite_knots": unite_knots,
    "basis_start": lambda k: None if whole(k) is None else (Fraction(1),),
    "cox_rising": cox_rising,
    "cox_falling": cox_falling,
    "cox_de_boor": cox_de_boor,
    "basis": basis,
    "basis_slope": basis_slope,
    # surfaces made of curves
    "stand_up": lambda A: (A[0], Fraction(0), A[1], A[3]),
    "move_along": move_along,
    "swing": swing,
    "count_arcs": count_arcs,
    "half_arc": half_arc,
    "foot": foot,
    "spoke": lambda P, O: weighing(difference(P, O), 0),
    "quarter_turn": quarter_turn,
    "on_circle": on_circle,
    "circle_corner": lambda O, X, Y, c, s, w: on_circle(scaled(O, w[0]), X, Y, c, s),
    "circle_point": lambda O, r, c, s: (O[0] + r[0] * c[0], O[1] + r[0] * s[0], O[2], O[3]),
    "tangent_corner": tangent_corner,
    "unit_tangent": unit_tangent,
    "first_normal": first_normal,
    "towards": lambda A, B: weighing(difference(B, A), 0),
    "cross_product": cross,
    "mirror_vector": mirror_vector,
    "place_in_frame": place_in_frame,
}
