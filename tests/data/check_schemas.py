"""Checks the published JSON Schemas: check_schemas.py ROOT BLOSSOM BLOSSOM-GRADE

Every shipped lesson, exercise and answers file, and every trace and grade the two programs write of them, must be valid;
a file with a mistake must not be; every key must have a description, for editors; nothing may need a network.
Needs Debian's python3-jsonschema.
"""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import warnings

try:
    import jsonschema
except ImportError:
    sys.exit("the Python module jsonschema is missing; on Debian: apt-get install python3-jsonschema")
warnings.filterwarnings("ignore", category=DeprecationWarning)

root, blossom, blossom_grade = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
mistakes = []


def schema_of(kind):
    folder = "exercises" if kind in ("exercise", "answers", "grade", "assignment", "result") else "lessons"
    return root / folder / f"{kind}.schema.json"


def validator(kind):
    path = schema_of(kind)
    schema = json.loads(path.read_text())
    resolver = jsonschema.RefResolver(base_uri=path.as_uri(), referrer=schema)
    return jsonschema.Draft202012Validator(schema, resolver=resolver)


KINDS = ("lesson", "exercise", "answers", "grade", "assignment", "result", "trace", "geometry", "algorithms", "scene")
validators = {kind: validator(kind) for kind in KINDS}


def must_be_valid(kind, name, document):
    for error in validators[kind].iter_errors(document):
        mistakes.append(f"{name}: {'/'.join(map(str, error.path))}: {error.message[:200]}")


def run(*command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, cwd=root)
    # 1: an input is at fault, which some of the sample answers are.
    if done.returncode not in (0, 1):
        mistakes.append(f"{' '.join(map(str, command))} ended with {done.returncode}: {done.stderr[:200]}")
    return done.stdout


def files(folder):
    return [path for path in sorted((root / folder).glob("*.json")) if not path.name.endswith(".schema.json")]


# A change to a document, as what it is and how to do it: set what stands at a path, or leave the path's last key out.
def changed(document, path, value):
    document = copy.deepcopy(document)
    at = document
    for step in path[:-1]:
        at = at[step]
    if value is LEFT_OUT:
        del at[path[-1]]
    else:
        at[path[-1]] = value
    return document


LEFT_OUT = object()
SPELLED_WRONG = {"spelled_wrong": 1}


def must_be_invalid(kind, name, document, changes):
    for path, value in changes:
        if validators[kind].is_valid(changed(document, path, value)):
            what = "left out" if value is LEFT_OUT else f"= {json.dumps(value)}"
            mistakes.append(f"{name} is valid although {'/'.join(map(str, path))} is {what}")


RUN_CHANGES = [
    (["algorithm"], "de_bor"),
    (["algorithm"], LEFT_OUT),
    (["inputs"], LEFT_OUT),
    (["inputs"], []),
    (["inputs", "spelled_wrong"], 1),
]
CURVE_CHANGES = [
    (["degree"], 0),
    (["degree"], 26),
    (["degree"], "3"),
    (["degree"], LEFT_OUT),
    (["points"], LEFT_OUT),
    (["points"], [[0, 0]]),
    (["points", 0], [0]),
    (["points", 0], [0, 0, 0, 1]),
    (["points", 0, 0], "2/0"),
    (["points", 0, 0], "a half"),
    (["points", 0, 0], "1e"),
    (["points", 0, 0], None),
    (["knot"], [0, 0, 1, 1]),
    (["knots"], "0 0 1 1"),
    (["weights"], 1),
]


ALGORITHMS = json.loads(schema_of("algorithms").read_text())


# A note in every object there is, but in those of names that somebody else chose (answers, texts by language).
def commented(node, key=""):
    if isinstance(node, list):
        return [commented(item) for item in node]
    if not isinstance(node, dict):
        return node
    members = {name: commented(member, name) for name, member in node.items()}
    return members if key == "answers" else {"$comment": ["a note", {"to": "whom"}], **members}


# The runs of a lesson: itself, or its scenes.
def scenes_of(lesson):
    return [([], lesson)] if "scenes" not in lesson else [(["scenes", i], scene) for i, scene in enumerate(lesson["scenes"])]


def run_changes(document):
    needed = ALGORITHMS["$defs"][document["algorithm"]]["required"]
    changes = RUN_CHANGES + [(["inputs", key], LEFT_OUT) for key in document["inputs"] if key in needed]
    changes += [(["inputs", key], "no such thing") for key in document["inputs"]]
    if "curve" in document["inputs"]:
        changes += [(["inputs", "curve"] + path, value) for path, value in CURVE_CHANGES]
    return changes


# The schemas themselves: sound, no host in them, and every key described.
for kind in KINDS:
    text = schema_of(kind).read_text()
    schema = json.loads(text)
    jsonschema.Draft202012Validator.check_schema(schema)

    def check(node, where, kind=kind):
        if isinstance(node, list):
            for i, item in enumerate(node):
                check(item, f"{where}/{i}")
        if not isinstance(node, dict):
            return
        for key in ("$id", "$ref"):
            if isinstance(node.get(key), str) and "://" in node[key]:
                mistakes.append(f"{kind}.schema.json{where}: {key} names a host")
        for key, member in node.get("properties", {}).items() if "type" in node else []:
            described = member
            while "description" not in described and "$ref" in described:
                described = validators[kind].resolver.resolve(described["$ref"])[1]
            if "description" not in described:
                mistakes.append(f"{kind}.schema.json{where}: the key {key} has no description")
        for key, member in node.items():
            check(member, f"{where}/{key}")

    check(schema, "")

# Lessons, and the traces of them in both kinds of numbers.
lessons = files("lessons")
PLACES = ["P[1", "", 3, {}, {"step": -1}, {"step": 0, "phase": "knots"}, {"last": "P["}, {"every": 1}, {"level": "2"}, {"after": ""}, {"evry": "P"}]
BEAT_CHANGES = [
    (["say"], LEFT_OUT),
    (["say"], " "),
    (["say"], {}),
    (["say"], {"en": ""}),
    (["say"], {"English": "Look."}),
    (["at"], LEFT_OUT),
    (["highlight"], "P[0][0]"),
    (["highlight"], []),
    (["spelled_wrong"], 1),
    (["pause"], "long"),
    (["pause"], 0),
    (["pause"], 61),
    (["camera"], {"fit": []}),
    (["camera"], {"azimut": 1}),
    (["camera"], []),
    (["sliders"], []),
    (["sliders"], [{"input": "u", "from": 0}]),
    (["sliders"], [{"input": "", "from": 0, "to": 1}]),
    (["sliders"], [{"input": "u", "from": "zero", "to": 1}]),
    (["sliders"], [{"input": "u", "from": 0, "to": 1, "label": ""}]),
    (["sliders"], [{"input": "u", "from": 0, "to": 1}] * 5),
] + [(["at"], place) for place in PLACES]
CHOICES = [{"text": "a"}, {"text": "b", "right": True}]
CHECKPOINTS = [  # what is right, with changes that are not
    ({"id": "c", "kind": "predict", "ask": "?", "value": "C", "decimals": 2, "points": "1/2", "right": "Yes.", "wrong": "No."},
     [(["id"], "C"), (["id"], LEFT_OUT), (["kind"], "guess"), (["kind"], LEFT_OUT), (["ask"], LEFT_OUT), (["value"], LEFT_OUT),
      (["decimals"], 13), (["points"], "many"), (["choices"], CHOICES), (["items"], ["a", "b"]), (["right"], ""), (["spelled_wrong"], 1)]),
    ({"id": "c", "kind": "span", "ask": "?"}, [(["decimals"], 2), (["items"], ["a", "b"])]),
    ({"id": "c", "kind": "line", "ask": "?"}, [(["value"], "k"), (["choices"], CHOICES)]),
    ({"id": "c", "kind": "order", "ask": "?", "items": ["a", "b"]}, [(["items"], LEFT_OUT), (["items"], ["a"]), (["items"], ["a"] * 9), (["value"], "k")]),
    ({"id": "c", "kind": "choice", "ask": "?", "choices": CHOICES},
     [(["choices"], LEFT_OUT), (["choices"], CHOICES[:1]), (["choices", 0], "a"), (["choices", 0, "text"], LEFT_OUT),
      (["choices", 0, "right"], "yes"), (["choices", 0, "feedback"], ""), (["choices", 0, "spelled_wrong"], 1)]),
]
for path in lessons:
    lesson = json.loads(path.read_text())
    must_be_valid("lesson", path.name, lesson)
    must_be_valid("lesson", f"{path.name} with comments", commented(lesson))
    changes = [([key], LEFT_OUT) for key in ("schema", "id", "title")] + [
        (["spelled_wrong"], 1),
        (["schema"], "blossom.lesson/2"),
        (["id"], "Not an id"),
        (["title"], []),
        (["minutes"], 0),
        (["objectives"], []),
        (["objectives"], "Know it."),
        (["prerequisites"], ["Not an id"]),
        (["prerequisites"], ["a", "a"]),
        (["exercises"], []),
        (["language"], "English"),
        (["languages"], ["en-GB"]),
        (["colors"], {"crve": "#000"}),
        (["colors"], {"curve": "red"}),
        (["colors"], {"curve": {"night": "#fff"}}),
        (["colors"], {"curve": {}}),
        (["scenes"], []),
        (["scenes"], [{"id": "a", "title": "A"}]),
    ]
    if "scenes" in lesson:
        changes += [(["algorithm"], "de_boor"), (["inputs"], {}), (["beats"], lesson["scenes"][0]["beats"]), (["predict"], {})]
    for where, scene in scenes_of(lesson):
        changes += [(where + change, value) for change, value in run_changes(scene) + [
            (["beats"], LEFT_OUT),
            (["beats"], []),
            (["predict"], {"ask": []}),
            (["predict"], {"ask": ["P[1"]}),
            (["predict"], {"marking": "never"}),
            (["spelled_wrong"], 1),
        ]]
        if "scenes" not in lesson and path not in lessons[:3]:
            continue  # what is in beats is alike in all of them
        changes += [(where + ["beats", 0] + change, value) for change, value in BEAT_CHANGES]
        for checkpoint, wrong in CHECKPOINTS:
            must_be_valid("lesson", path.name, changed(lesson, where + ["beats", 0, "checkpoint"], checkpoint))
            changes += [(where + ["beats", 0, "checkpoint"], changed(checkpoint, change, value)) for change, value in wrong]
    must_be_invalid("lesson", path.name, lesson, changes)
    for exact in ([], ["--exact"]):
        trace = json.loads(run(blossom, "trace", path, "--format", "json", *exact))
        must_be_valid("trace", f"the trace of {path.name} {' '.join(exact)}", trace)
    required = ("schema", "exact", "dimension", "rational", "phases", "steps", "values", "result")
    must_be_invalid("trace", f"the trace of {path.name}", trace, run_changes(trace) + [([key], LEFT_OUT) for key in required] + [
        (["spelled_wrong"], 1),
        (["dimension"], 4),
        (["steps"], []),
        (["steps", 0, "index"], -1),
        (["steps", 0, "text"], LEFT_OUT),
        (["values", 0, "kind"], "number"),
        (["values", 0, "value"], "one"),
        (["values", 0, "from"], LEFT_OUT),
        (["values", 0, "spelled_wrong"], 1),
        (["result"], {}),
        (["result", "spelled_wrong"], 1),
    ])

# Scenes.
scenes = files("lessons/scenes")
for path in scenes:
    scene = json.loads(path.read_text())
    must_be_valid("scene", path.name, scene)
    must_be_valid("scene", f"{path.name} with comments", commented(scene))
    must_be_invalid("scene", path.name, scene, [([key], LEFT_OUT) for key in ("schema", "objects")] + [
        (["spelled_wrong"], 1),
        (["schema"], "blossom.scene/2"),
        (["id"], "Not an id"),
        (["look"], {"from": "above"}),
        (["objects"], {}),
        (["objects", 0, "name"], LEFT_OUT),
        (["objects", 0, "name"], ""),
        (["objects", 0, "name"], " blank"),
        (["objects", 0, "color"], 8),
        (["objects", 0, "shows"], ["pionts"]),
        (["objects", 0, "map"], "mein"),
        (["objects", 0, "spelled_wrong"], 1),
        (["objects", 0], {"name": "nothing"}),
        (["objects", 0], {"name": "odd", "made": {"algorithm": "de_bor", "inputs": {}}}),
        (["objects", 0], {"name": "odd", "made": {"algorithm": "de_boor"}}),
        (["objects", 0], {"name": "odd", "made": {"algorithm": "de_boor", "inputs": {"curve": {"object": ""}}}}),
        (["objects", 0], {"name": "odd", "made": {"algorithm": "de_boor", "inputs": {"curve": {"object": "a", "turn": 90}}}}),
    ])

# Exercises.
exercises = files("exercises")
for path in exercises:
    exercise = json.loads(path.read_text())
    must_be_valid("exercise", path.name, exercise)
    must_be_valid("exercise", f"{path.name} with comments", commented(exercise))
    required = ("schema", "id", "title", "prompt", "ask")
    must_be_invalid("exercise", path.name, exercise, run_changes(exercise) + [([key], LEFT_OUT) for key in required] + [
        (["spelled_wrong"], 1),
        (["schema"], "blossom.exercise/2"),
        (["ask"], []),
        (["ask", 0, "value"], LEFT_OUT),
        (["ask", 0, "points"], LEFT_OUT),
        (["ask", 0, "spelled_wrong"], 1),
        (["tolerance"], "roughly"),
        (["tolerance"], {"decimals": "three"}),
        (["tolerance"], {"decimals": 3, "absolute": 1}),
        (["feedback"], "loud"),
        (["marking"], "never"),
    ])
    if "vary" in exercise:
        must_be_invalid("exercise", path.name, exercise, [(["vary"] + where, value) for where, value in (
            (["inputs"], []),
            (["inputs"], LEFT_OUT),
            (["inputs", 0, "at"], LEFT_OUT),
            (["inputs", 0, "spelled_wrong"], 1),
            (["inputs", 0], {"at": "u"}),
            (["inputs", 0], {"at": "u", "integers": [1, 2], "choose": [1]}),
            (["inputs", 0], {"at": "u", "integers": [1]}),
            (["inputs", 0], {"at": "u", "fractions": {"denominators": [0], "from": 0, "to": 1}}),
            (["inputs", 0], {"at": "u", "choose": [1], "not": "knot"}),
            (["require"], ["points nice"]),
            (["denominator"], 0),
            (["tolerance"], "roughly"),
            (["except"], [{"misconception": "swapped-weights"}]),
        )])

# Sample answers (two of the class are no JSON on purpose), and the grades of the whole class.
demo = files("exercises/demo-class")
good = {}
for path in demo:
    try:
        good[path] = json.loads(path.read_text())
    except json.JSONDecodeError:
        pass
for path, answers in good.items():
    must_be_valid("answers", path.name, answers)
    for letters in ("b", "cab", "C, A, B", ["c", "a", "b"], 4):
        must_be_valid("answers", "answers to a checkpoint", changed(answers, ["answers", "in-order"], letters))
    must_be_invalid("answers", path.name, answers, [([key], LEFT_OUT) for key in ("schema", "exercise", "answers")] + [
        (["spelled_wrong"], 1),
        (["schema"], "blossom.answer/1"),
        (["answers"], []),
        (["answers", "k"], True),
        (["answers", "k"], "four"),
        (["answers", "k"], "1/0"),
        (["answers", "k"], SPELLED_WRONG),
        (["answers", "P[1][2]"], [[0, 16]]),
        (["answers", "P[1"], 1),
    ])
asked = {answers["exercise"] for answers in good.values()}
exercise = next(path for path in exercises if json.loads(path.read_text())["id"] in asked)
grades = [json.loads(line) for line in run(blossom_grade, exercise, *demo, "--format", "json").splitlines()]
if len(grades) != len(demo) or len(demo) - len(good) < 2:
    mistakes.append(f"{len(demo)} sample answers, {len(good)} of them JSON, have {len(grades)} grades")
for grade in grades:
    name = f"the grade of {grade['student']}"
    must_be_valid("grade", name, grade)
    required = ("schema", "exercise", "score", "points", "max_points", "parts")
    must_be_invalid("grade", name, grade, [([key], LEFT_OUT) for key in required] + [
        (["spelled_wrong"], 1),
        (["score"], 1.5),
        (["points"], "1"),
        (["parts"], []),
        (["parts", 0, "verdict"], "great"),
        (["parts", 0, "feedback"], LEFT_OUT),
    ])

# The sample course, and the results of its class as the instructor and as the students get them.
course = root / "exercises/demo-course/course.json"
assignment = json.loads(course.read_text())
must_be_valid("assignment", course.name, assignment)
must_be_valid("assignment", "an exercise inside", changed(assignment, ["exercises", 0], {"exercise": {"schema": "blossom.exercise/1"}}))
must_be_invalid("assignment", course.name, assignment, [([key], LEFT_OUT) for key in ("schema", "id", "title", "exercises")] + [
    (["spelled_wrong"], 1),
    (["schema"], "blossom.assignment/2"),
    (["id"], "Not an id"),
    (["exercises"], []),
    (["exercises", 0], {}),
    (["exercises", 0], {"file": "a.json", "exercise": {}}),
    (["exercises", 0, "points"], -1),
    (["exercises", 0, "spelled_wrong"], 1),
    (["due"], "tomorrow"),
    (["due"], LEFT_OUT),
    (["late", "per_day"], 2),
    (["late", "grace_minutes"], -1),
    (["late", "spelled_wrong"], 1),
    (["attempts"], "worst"),
    (["feedback"], "loud"),
])
with tempfile.TemporaryDirectory() as scratch:
    out = pathlib.Path(scratch) / "out"
    run(blossom_grade, "batch", course, course.parent / "submissions.jsonl", "--roster", course.parent / "roster.csv",
        "--out", out, "--now", "2026-10-10T00:00:00Z")
    results = [json.loads(line) for line in (out / "results.jsonl").read_text().splitlines()]
    if len(results) != 12:
        mistakes.append(f"the sample course has {len(results)} results")
    for result in results:
        must_be_valid("result", f"the result of {result['student']['id']}", result)
    for path in sorted((out / "students").glob("*.json")):
        must_be_valid("result", path.name, json.loads(path.read_text()))
    must_be_valid("assignment", "assignment.json", json.loads((out / "assignment.json").read_text()))
    required = ("schema", "assignment", "student", "score", "points", "max_points", "exercises", "incidents")
    must_be_invalid("result", "a result", results[4], [([key], LEFT_OUT) for key in required] + [
        (["spelled_wrong"], 1),
        (["student", "id"], LEFT_OUT),
        (["score"], 2),
        (["exercises", 0, "state"], "lost"),
        (["exercises", 0, "digest"], "x"),
        (["exercises", 0, "submitted"], "yesterday"),
        (["exercises", 0, "grade", "parts", 0, "verdict"], "great"),
        (["incidents", 0, "kind"], "odd"),
        (["incidents", 0, "text"], LEFT_OUT),
    ])

# Geometry on its own: a curve and a surface.
curve = {"degree": 2, "points": [[0, 0], [1, "1/2"], [2, 0]], "weights": [1, 0.5, "2"]}
surface = {"degree": [1, 1], "knots": [[0, 0, 1, 1]] * 2, "points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]}
must_be_valid("geometry", "a curve", curve)
must_be_valid("geometry", "a surface", surface)
must_be_invalid("geometry", "a curve", curve, CURVE_CHANGES)
must_be_invalid("geometry", "a surface", surface, [
    (["degree"], [1]),
    (["degree"], 1),
    (["knots"], [0, 0, 1, 1]),
    (["points", 0], [0, 0, 0]),
    (["weights"], [1, 1, 1, 1]),
    (["spelled_wrong"], 1),
])

# Starts for lessons and exercises are what the schemas say, and comments are what `blossom lint` takes everywhere.
with tempfile.TemporaryDirectory() as scratch:
    scratch = pathlib.Path(scratch)
    for kind, folder in (("lesson", "lessons"), ("exercise", "exercises")):
        (scratch / folder).mkdir()
        for algorithm in ("de_casteljau", "skinning", "surface_evaluation", "interpolation"):
            start = scratch / f"{kind}-{algorithm}.json"
            run(blossom, "new", kind, "--algorithm", algorithm, "--out", start)
            must_be_valid(kind, f"the start of a {kind} about {algorithm}", json.loads(start.read_text()))
    for path in lessons + exercises + scenes:
        folder = scratch / path.relative_to(root).parent
        folder.mkdir(exist_ok=True)
        (folder / path.name).write_text(json.dumps(commented(json.loads(path.read_text()))))
    mended = run(blossom, "lint", scratch / "lessons", scratch / "exercises", scratch / "lessons/scenes")
    if mended != f"{len(lessons) + len(exercises) + len(scenes)} files are in order\n":
        mistakes.append(f"blossom lint said of files with comments {mended!r}")

# What the schemas accept, `blossom lint` accepts too.
linted = run(blossom, "lint", *lessons, *scenes, *exercises, *good, course)
expected = f"{len(lessons) + len(scenes) + len(exercises) + len(good) + 1} files are in order\n"
if linted != expected:
    mistakes.append(f"blossom lint said {linted!r}")

print("\n".join(mistakes) or f"{len(lessons)} lessons, {len(scenes)} scenes, {len(exercises)} exercises, {len(good)} answers: all in order")
sys.exit(1 if mistakes or len(lessons) < 8 or len(exercises) < 12 else 0)
