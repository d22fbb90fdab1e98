"""What the window says: all texts in the sources that are to be translated, and those that have been.

A text has one translation wherever it stands: the files know no contexts (see ui/text/language.h)."""
import json
import re
import xml.etree.ElementTree as ElementTree

DESKTOP = ("desktop", "document", "jobs", "looks", "output", "plan", "presenters", "rendering", "scan")
ROOMS = ("ui/**/*.cpp", "ui/**/*.h", *(f"app/{room}/*.{end}" for room in DESKTOP for end in ("cpp", "h")))
# Sentences of rooms that know no Qt: the patterns of phrase(...), see render/base/text.h.
ROOMS_BELOW = ("render/**/*.cpp", "render/**/*.h", "render/**/*.cu", "dicom/**/*.cpp", "dicom/**/*.h",
               *(f"app/{room}/*.cpp" for room in (*DESKTOP, "coordinator", "remote", "node", "wire")))
PHRASE = re.compile(r"\bphrase\s*\(")
UNMARKED = re.compile(r'\b(?:Error|FieldError\{|VpError\{|fail\()\s*\{\s*"([^"]+ [^"]*)"')
# Other words of theirs: file, and where in it they stand.
WORDS = (("render/scene/edit/tissue_bands.h", r'\{"([^"]+)"'), ("render/scene/named_look.cpp", r'[?:] "([^"]+)"'),
         ("render/film/health_text.cpp", r'return "([^"]+)"'), ("dicom/read/jpeg_scan.cpp", r'(?:return|[?=]) "([^"]+)"'),
         ("app/wire/map_reader.cpp", r'"(\w+ [^"]+)"'), ("app/wire/payload.cpp", r'(?:return|\?) "([^"]+)"'))
# What a long step does, as its Progress says it (render/base/progress.h).
STEPS = re.compile(r'(?:\bprogress_?\([^;"]*,|\bonAllCores\([^;"]*,|\bstring_view kStep =)\s*"([^"]+)"')
# What the window says of the looks that the program carries.
LOOKS, SAID_OF_LOOKS = "resources/looks/*.json", ("name", "doesNotShow")
CALL = re.compile(r"\b(?:(QT_TRANSLATE_NOOP|QCoreApplication::translate)|tr|translated|QT_TR_NOOP)\s*\(")
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')


def unescaped(text):
    pieces = re.split(r"(\\u[0-9A-Fa-f]{4}|\\.)", text)
    known = {"\\n": "\n", "\\t": "\t", '\\"': '"', "\\\\": "\\"}
    return "".join(chr(int(p[2:], 16)) if p.startswith("\\u") else known.get(p, p) for p in pieces)


def arguments(source, begin):
    """Of the call whose parenthesis ends before `begin`: per argument the literals that may stand there. Adjacent
    literals are one; those of a condition are several."""
    lists, depth, at, last_end = [[]], 0, begin, None
    while at < len(source):
        literal = LITERAL.match(source, at)
        if literal:
            joined = last_end is not None and not source[last_end:at].strip()
            if joined:
                lists[-1][-1] += literal[1]
            elif depth == 0:
                lists[-1].append(literal[1])
            last_end = at = literal.end()
            continue
        character = source[at]
        if character in "([{":
            depth += 1
        elif character in ")]}":
            if depth == 0:
                break
            depth -= 1
        elif character == "," and depth == 0:
            lists.append([])
            last_end = None
        at += 1
    return [[unescaped(text) for text in texts] for texts in lists]


def in_rooms_below(root):
    """{pattern: the first file that says it}"""
    found = {}
    for path in sorted({path for pattern in ROOMS_BELOW for path in root.glob(pattern)}):
        source = re.sub(r"//[^\n]*", "", path.read_text(encoding="utf-8"))
        for call in PHRASE.finditer(source):
            for text in arguments(source, call.end())[0]:
                found.setdefault(text, path.relative_to(root))
        for step in STEPS.findall(source):
            found.setdefault(step, path.relative_to(root))
    return found


def unmarked(root):
    """What would stay English: (file, text) of errors whose sentence is no phrase(...)."""
    for path in sorted({path for pattern in ROOMS_BELOW for path in root.glob(pattern)}):
        source = re.sub(r"//[^\n]*", "", path.read_text(encoding="utf-8"))
        for error in UNMARKED.finditer(source):
            yield path.relative_to(root), error[1]


def in_sources(root):
    """{text: the first file that says it}"""
    found = in_rooms_below(root)
    files = sorted({path for pattern in ROOMS for path in root.glob(pattern)})
    for path in files:
        source = re.sub(r"//[^\n]*", "", path.read_text(encoding="utf-8"))
        for call in CALL.finditer(source):
            place = 1 if call[1] else 0
            lists = arguments(source, call.end())
            for text in lists[place] if place < len(lists) else []:
                found.setdefault(text, path.relative_to(root))
    for file, pattern in WORDS:
        for text in re.findall(pattern, (root / file).read_text(encoding="utf-8")):
            found.setdefault(text, file)
    for path in sorted(root.glob(LOOKS)):
        look = json.loads(path.read_text(encoding="utf-8"))
        for field in SAID_OF_LOOKS:
            found.setdefault(look[field], path.relative_to(root))
    return found


def in_translation(path):
    """{text: its forms, or None where it is not finished}"""
    texts = {}
    for message in ElementTree.parse(path).getroot().iter("message"):
        translation = message.find("translation")
        forms = [form.text or "" for form in translation.iter("numerusform")] or [translation.text or ""]
        texts[message.find("source").text] = forms if translation.get("type") is None and all(forms) else None
    return texts


def places(text):
    """The numbers and words that are put into it."""
    return sorted(re.findall(r"%(?:L?\d|n)", text))
