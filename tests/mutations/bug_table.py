"""The table of bugs in bugs/*.toml: read, checked against the source, and planted in a copy of it."""

import re
import tomllib
import zlib
from dataclasses import dataclass, field
from pathlib import Path

INCLUDE = '#include "tests/mutations/planted.h"\n'


@dataclass
class Place:
    """A piece of a source file that occurs once there, and what a bug makes of it."""

    file: str  # or a folder that ends in "/": the piece then occurs once in all of it
    was: str
    becomes: str
    within: str = ""  # the piece is looked for inside this text, which occurs once in the file


@dataclass
class Bug:
    name: str
    breaks: str  # one sentence: what a user would get
    seen_by: list[str]  # test programs, each with the functions to run: every one must turn red
    places: list[Place] = field(default_factory=list)

    @property
    def number(self) -> int:
        """Stays the same when other bugs come and go, so that what is compiled stays so too."""
        return zlib.crc32(self.name.encode())


class TableError(Exception):
    pass


def read_bugs(folder: Path) -> list[Bug]:
    """All bugs, file by file. Raises TableError for what is not understood."""
    bugs = []
    for path in sorted(folder.glob("*.toml")):
        try:
            entries = tomllib.loads(path.read_text())["bug"]
            bugs += [_bug(dict(entry)) for entry in entries]
        except (tomllib.TOMLDecodeError, KeyError, TypeError) as error:
            raise TableError(f"{path}: {error}") from error
    for what, values in {"name": [b.name for b in bugs], "number": [b.number for b in bugs]}.items():
        doubled = {value for value in values if values.count(value) > 1}
        if doubled:
            raise TableError(f"two bugs have the same {what}: {doubled}")
    return bugs


def _bug(entry: dict) -> Bug:
    further = entry.pop("also", [])
    bug = Bug(entry.pop("name"), entry.pop("breaks"), entry.pop("seen_by"))
    bug.places = [Place(**entry)] + [Place(**{"file": entry["file"], **more}) for more in further]
    return bug


def _span(text: str, place: Place) -> tuple[int, int]:
    """Where the piece lies in the text of its file."""
    begin, end = 0, len(text)
    for wanted in filter(None, [place.within, place.was]):
        count = text.count(wanted, begin, end)
        if count != 1:
            raise TableError(f"{place.file}: occurs {count} times, must occur once: {wanted!r}")
        begin = text.index(wanted, begin, end)
        end = begin + len(wanted)
    return begin, end


def _file_of(source: Path, place: Place) -> str:
    """The file that the piece lies in."""
    if not place.file.endswith("/"):
        return place.file
    files = [path for path in (source / place.file).rglob("*") if path.suffix in (".h", ".cpp")]
    found = [path for path in files if (place.within or place.was) in path.read_text()]
    if len(found) != 1:
        raise TableError(f"{place.file}: {len(found)} files hold it, must be one: {place.within or place.was!r}")
    return str(found[0].relative_to(source))


def _has_place(source: Path, place: Place) -> bool:
    try:
        _span((source / _file_of(source, place)).read_text(), place)
        return True
    except (TableError, OSError):
        return False


def moved_places(source: Path, bugs: list[Bug]) -> list[tuple[Bug, Place, str]]:
    """Pieces whose file has gone or holds them no more, each with the one other file that holds it now: what a renamed
    file, or code that has moved to another room, leaves behind."""
    lost = [(bug, place) for bug in bugs for place in bug.places if not _has_place(source, place)]
    files = [path for room in ("app", "dicom", "render", "ui") for path in sorted((source / room).rglob("*"))
             if path.suffix in (".h", ".cpp", ".cu", ".cuh")] if lost else []
    texts = {str(path.relative_to(source)): path.read_text() for path in files}
    found = []
    for bug, place in lost:
        holders = [file for file, text in texts.items() if text.count(place.within or place.was) == 1]
        if len(holders) == 1:
            found.append((bug, place, holders[0]))
    return found


def mend_places(folder: Path, moved: list[tuple[Bug, Place, str]]) -> None:
    """Writes the new files into the table's rows. A row whose pieces went to several files is left to its author."""
    for bug, place, file in moved:
        for path in sorted(folder.glob("*.toml")):
            text = path.read_text()
            row = re.search(rf'\[\[bug\]\]\nname = "{re.escape(bug.name)}"\n(?:(?!\[\[bug\]\]).*\n?)*', text)
            if row:
                mended = row[0].replace(f'file = "{place.file}"', f'file = "{file}"')
                path.write_text(text[:row.start()] + mended + text[row.end():])


def _is_list(text: str) -> bool:
    """Whether a comma stands outside of all brackets: `a, b` is no expression that a switch may stand around."""
    depth = 0
    for letter in text:
        depth += (letter in "([{") - (letter in ")]}")
        if depth == 0 and letter == ",":
            return True
    return False


def _is_closed(text: str) -> bool:
    """Whether it closes as many brackets as it opens."""
    return all(text.count(opened) == text.count(closed) for opened, closed in ("()", "[]", "{}"))


def _is_expression(text: str) -> bool:
    """Whether nothing speaks against it: no list, no open bracket, at its begin no keyword of a statement, nor an operator
    of what stands before it, nor braces or a line of the preprocessor's, and at its end no operator."""
    begins = r"[#{]|(if|for|while|switch|return)\b|&& |\|\| "
    ends = r".*(\s[<>]|[^<>\s&|]=|[|&^+\-*/%?:,])\s*$"
    return (text.strip() != "" and _is_closed(text) and not _is_list(text) and not re.match(begins, text)
            and not re.match(ends, text, re.DOTALL))


def _is_declaration(text: str) -> bool:
    """Whether the statement declares something: what follows would not see it from within the switch's branch."""
    first = r"(?!return\b|throw\b|delete\b|goto\b|else\b|if\b|for\b|while\b|switch\b|case\b|emit\b|using\b)"
    return re.match(first + r"[A-Za-z_][\w:]*(<[^;=()]*>)?[&*]*\s+[&*]?[A-Za-z_]\w*\s*[=({;,]", text.strip()) is not None


def _begins_statement(text: str, begin: int) -> bool:
    """Whether a statement can begin there, and not the rest of one."""
    before = re.sub(r"//[^\n]*", "", text[:begin]).rstrip()
    return before.endswith((";", "{", "}", ")", ":", "else"))


# Binary operators as clang-format writes them, those that bind least first.
BINDING = (("?", ":"), ("||",), ("&&",), ("|",), ("^",), ("&",), ("==", "!="), ("<", ">", "<=", ">="), ("<<", ">>"), ("+", "-"),
           ("*", "/", "%"))
OPERATOR = r"(\|\||&&|==|!=|<=|>=|<<|>>|[?:|^&<>+\-*/%])"


def _binds(operator: str) -> int:
    return next(i for i, row in enumerate(BINDING) if operator in row)


def _loses_an_operand(text: str, begin: int, end: int) -> bool:
    """Whether an operator beside the expression text[begin:end] binds a part of it, so that brackets around it change what is
    computed: `a && b` in `a && b < c`."""
    outermost, depth = "", 0
    for letter in text[begin:end]:
        depth -= letter in ")]}"
        outermost += letter if depth == 0 else "_"
        depth += letter in "([{"
    inside = [_binds(found) for found in re.findall(rf"\s{OPERATOR}(?=\s)", outermost)]
    if not inside:
        return False
    if text[begin - 1] in "!~-*&":
        return True
    before, after = re.search(rf"\s{OPERATOR}\s+$", text[:begin]), re.match(rf"\s+{OPERATOR}\s", text[end:])
    left, right = (_binds(found[1]) if found else -1 for found in (before, after))
    return max(left, right) > min(inside) or (left == min(inside) and before[1] in "-*/%")


def _planted(was: str, bugs: list[tuple[Bug, Place]]) -> str:
    """What ends in a semicolon is a statement, all else an expression."""
    text = was
    statement = bugs[0][1].was.rstrip().endswith(";")
    for bug, place in bugs:
        if statement:
            text = f"if (pdr::planted({bug.number}ul)) {{ {place.becomes} }} else {{ {text} }}"
        else:
            text = f"(pdr::planted({bug.number}ul) ? ({place.becomes}) : ({text}))"
    return text


def plant(source: Path, bugs: list[Bug]) -> dict[str, str]:
    """The new text of every file that bugs lie in. Raises TableError with all pieces that are not there, or that overlap."""
    texts: dict[str, str] = {}
    pieces: dict[str, dict[tuple[int, int], list[tuple[Bug, Place]]]] = {}
    complaints = []
    for bug in bugs:
        for place in bug.places:
            try:
                if not place.was.rstrip().endswith(";") and not (_is_expression(place.was) and _is_expression(place.becomes)):
                    raise TableError(f"must be one expression or a whole statement: {place.was!r}, {place.becomes!r}")
                file = _file_of(source, place)
                if file not in texts:
                    texts[file] = (source / file).read_text()
                span = _span(texts[file], place)
                if place.was.rstrip().endswith(";") and not _begins_statement(texts[file], span[0]):
                    raise TableError(f"{file}: begins amid a statement: {place.was!r}")
                if place.was.rstrip().endswith(";") and _is_declaration(place.was):
                    raise TableError(f"{file}: declares what is needed behind it: {place.was!r}")
                if not place.was.rstrip().endswith(";") and _loses_an_operand(texts[file], *span):
                    raise TableError(f"{file}: an operator beside it binds a part of it: {place.was!r}")
                pieces.setdefault(file, {}).setdefault(span, []).append((bug, place))
            except (TableError, OSError) as error:
                complaints.append(f"{bug.name}: {error}")
    if complaints:
        raise TableError("\n  ".join(["these bugs have no place (run --mend finds what has moved to another file):", *complaints]))
    return {file: INCLUDE + _replaced(file, texts[file], 0, len(texts[file]), spans) for file, spans in pieces.items()}


def _replaced(file: str, text: str, begin: int, end: int, spans: dict[tuple[int, int], list[tuple[Bug, Place]]]) -> str:
    """text[begin:end] with the bugs in it; a piece may lie within another one."""
    result, at = "", begin
    for low, high in sorted(spans, key=lambda span: (span[0], -span[1])):
        if low < at or high > end or (low, high) == (begin, end):
            continue
        inner = {span: found for span, found in spans.items() if low <= span[0] and span[1] <= high and span != (low, high)}
        if any(span[0] < high < span[1] for span in spans):
            raise TableError(f"{file}: two bugs overlap: {text[low:high]!r}")
        result += text[at:low] + _planted(_replaced(file, text, low, high, inner), spans[low, high])
        at = high
    return result + text[at:end]


def missing_tests(source: Path, bugs: list[Bug]) -> list[str]:
    """Sentences about test programs and functions that are named but not there."""
    programs = {"pdrender-bench": None, "pdrender-cli": None}
    for lists in (source / "tests").rglob("CMakeLists.txt"):
        for name, file in re.findall(r"^\s*pdr_test\((\w+)\s+([\w./]+)", lists.read_text(), re.MULTILINE):
            programs[name] = lists.parent / file
    complaints = []
    for bug in bugs:
        if not bug.seen_by:
            complaints.append(f"{bug.name}: no test is named that is to see it")
        for command in bug.seen_by:
            program, *functions = command.split()
            if program not in programs:
                complaints.append(f"{bug.name}: there is no test program {program}")
            elif (file := programs[program]) is not None:
                text = file.read_text()
                complaints += [f"{bug.name}: {program} has no function {name}" for name in functions
                               if not re.search(rf"\bvoid {name.split(':')[0]}\(\)", text)]
    return complaints
