#!/usr/bin/env python3
"""check_marks.py: reads the files to which measurements are exported, those in the tree, as other programs do.

CSV by Python's csv: every record is complete, and lengths and angles follow from the places. 3D Slicer's markups by
jsonschema, against what schema 1.0.3 requires of the fields that are written, and every place against the CSV's. Ends
with 77 where the Python package jsonschema is not installed.
"""
import csv
import json
import math
import pathlib
import sys

try:
    import jsonschema
except ImportError as missing:
    print(f"SKIP   : CheckMarks::filesAreThoseOfOtherPrograms() the Python package {missing.name} is not installed")
    sys.exit(77)

GOLDEN = pathlib.Path(__file__).resolve().parents[2] / "app" / "plan" / "golden"
NUMBER, TEXT, YES_OR_NO = {"type": "number"}, {"type": "string"}, {"type": "boolean"}


def numbers(count):
    return {"type": "array", "items": NUMBER, "minItems": count, "maxItems": count}


def record(**fields):
    """An object that has these fields and no other: a field that Slicer does not know would be lost."""
    return {"type": "object", "properties": fields, "required": list(fields), "additionalProperties": False}


POINT = record(id=TEXT, label=TEXT, description=TEXT, associatedNodeID=TEXT, position=numbers(3),
               orientation=numbers(9), selected=YES_OR_NO, locked=YES_OR_NO, visibility=YES_OR_NO,
               positionStatus={"enum": ["undefined", "preview", "defined"]})
MEASURED = record(name=TEXT, enabled=YES_OR_NO, value=NUMBER, units=TEXT, description=TEXT)
MARKUP = record(type={"enum": ["Fiducial", "Line", "Angle", "Curve", "ClosedCurve", "Plane", "ROI"]}, name=TEXT,
                coordinateSystem={"enum": ["LPS", "RAS"]}, coordinateUnits={"enum": ["mm", "um"]}, locked=YES_OR_NO,
                fixedNumberOfControlPoints=YES_OR_NO, labelFormat=TEXT,
                lastUsedControlPointNumber={"type": "integer"}, controlPoints={"type": "array", "items": POINT},
                measurements={"type": "array", "items": MEASURED})
MARKUPS = record(**{"@schema": TEXT, "markups": {"type": "array", "items": MARKUP}})


TYPES = {"distance": ["Line"], "angle": ["Angle"], "lines": ["Line", "Line"], "point": ["Fiducial"],
         "ball": ["Fiducial"], "ellipse": ["ClosedCurve"], "polygon": ["ClosedCurve"]}


def places_of(row):
    if row["corners_mm_lps"]:
        return [tuple(float(number) for number in corner.split()) for corner in row["corners_mm_lps"].split("; ")]
    return [tuple(float(row[f"{axis}_mm_lps_{n}"]) for axis in "xyz") for n in range(1, 5) if row[f"found_{n}"]]


def angle_of(u, v):
    return math.degrees(math.acos(sum(x * y for x, y in zip(u, v)) / math.hypot(*u) / math.hypot(*v)))


def from_to(a, b):
    return [y - x for x, y in zip(a, b)]


def drawn(kind, places):
    """What a ruler or a protractor says of the places."""
    if kind == "distance":
        return math.dist(*places)
    if kind == "angle":
        return angle_of(from_to(places[1], places[0]), from_to(places[1], places[2]))
    return angle_of(from_to(*places[:2]), from_to(*places[2:]))


def aside(u, v):
    """How far v reaches across u."""
    along = sum(x * y for x, y in zip(u, v)) / math.hypot(*u)
    return math.sqrt(sum(x * x for x in v) - along**2)


def check_area(row):
    places = places_of(row)
    if row["kind"] == "polygon":  # those of the file lie on an axial slice
        truth = abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(places, places[1:] + places[:1]))) / 2
    else:
        u, v = from_to(*places[:2]), from_to(places[0], places[2])
        truth = math.pi * math.hypot(*u) * aside(u, v)
    assert abs(float(row["area_mm2"]) - truth) < 1e-3 * truth and float(row["area_plus_minus_95"]) > 0


def is_around(points, places):
    """Whether the points lie on the ellipse about the first place through the second, as far aside as the third."""
    u = from_to(places[0], places[1])
    other = aside(u, from_to(places[0], places[2]))
    for point in points:
        away = from_to(places[0], point)
        along = sum(x * y for x, y in zip(u, away)) / math.hypot(*u)
        across = sum(x * x for x in away) - along**2
        if abs(along**2 / math.hypot(*u) ** 2 + across / other**2 - 1) > 1e-6:
            return False
    return len(points) >= 12


def check_csv(rows):
    for row in rows:
        assert None not in row and None not in row.values(), f"an incomplete record: {row}"
        if not row["value"]:
            assert row["text"] and not row["plus_minus_95"] and not row["unit"]
            continue
        value, spread = float(row["value"]), float(row["plus_minus_95"] or 0)
        if row["area_mm2"]:
            check_area(row)
        if row["kind"] in ("point", "ball", "ellipse"):
            assert row["unit"] == "HU"
        elif row["kind"] == "polygon":
            assert row["unit"] == "mm2" and row["value"] == row["area_mm2"]
        else:
            truth = drawn(row["kind"], places_of(row))
            low = 0 if row["bound"] == "atMost" else value - spread
            high = 360 if row["bound"] == "atLeast" else value + spread
            assert low - 1e-4 <= truth <= high + 1e-4, f"{truth} is not in {low} to {high}"
            assert row["unit"] == ("mm" if row["kind"] == "distance" else "deg")
        assert ("±" in row["text"]) == bool(row["plus_minus_95"])
    assert {row["kind"] for row in rows} == set(TYPES)


def check_slicer(markups, rows):
    jsonschema.validate(markups, MARKUPS, jsonschema.Draft7Validator)
    assert markups["@schema"].endswith("/markups-schema-v1.0.3.json#")
    rest = iter(markups["markups"])
    for row in rows:
        parts = [next(rest) for _ in TYPES[row["kind"]]]
        assert [part["type"] for part in parts] == TYPES[row["kind"]]
        assert all(part["coordinateSystem"] == "LPS" for part in parts)
        positions = [point["position"] for part in parts for point in part["controlPoints"]]
        if row["kind"] == "ellipse":
            assert is_around(positions, places_of(row))
        else:
            assert len(positions) == len(places_of(row))
            assert all(math.dist(a, b) < 1e-4 for a, b in zip(positions, places_of(row)))
        stated = [measurement["value"] for part in parts for measurement in part["measurements"]]
        assert stated == [float(row[name]) for name in ("value", "plus_minus_95") if row[name]]
    assert next(rest, None) is None


def main():
    with open(GOLDEN / "marks.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file, strict=True))
    check_csv(rows)
    check_slicer(json.loads((GOLDEN / "marks.mrk.json").read_text(encoding="utf-8")), rows)
    print(f"{len(rows)} measurements, as CSV and as 3D Slicer's markups")


main()
