#!/usr/bin/env python3
"""Fails where the window says something that a translation lacks, has left over, or says with other numbers in it.

check.py --source FOLDER [--write LANGUAGE TABLE]: with --write the file of that language is made anew from what it
holds and from TABLE, lines of "text<TAB>translation" in which several forms are parted by "|||"."""
import argparse
import pathlib
import re
import sys
import xml.sax.saxutils

import texts

LANGUAGES = ("de", "es")
# A clinician reads a lymph node or a nodule.
MISREAD = {"en": re.compile(r"^(No )?[Nn]odes?\b|^a node\b"), "de": re.compile(r"[Kk]noten"),
           "es": re.compile(r"\b[Nn]odos?\b")}


# Words that are the same in another language.
SYMBOLS = {"TE %1 ms", "b %1"}
ALIKE = {"de": {"Ellipse %1", *SYMBOLS}, "es": SYMBOLS}


def file_of(root, language):
    return root / "resources" / "translations" / f"pdrender_{language}.ts"


def same_everywhere(pattern):
    """Whether it has no words, but for the name of a unit."""
    return not re.sub(r"%\d|\b(?:MB|GB|mm²|mm|HU|ml|l|x|s|ms)\b|[^A-Za-z]", "", pattern)


def complaints(root, language):
    said, translated = texts.in_sources(root), texts.in_translation(file_of(root, language))
    for text, where in said.items():
        if MISREAD["en"].search(text):
            yield f"{where}: reads as a nodule, say render node: {text!r}"
        if translated.get(text) is None:
            yield f"{where}: not translated: {text!r}"
    for text, where in texts.in_rooms_below(root).items():
        if translated.get(text) == [text] and text not in ALIKE[language] and not same_everywhere(text):
            yield f"{where}: English is no translation: {text!r}"
    for text, forms in translated.items():
        if text not in said:
            yield f"nobody says any more: {text!r}"
        for form in forms or []:
            if MISREAD[language].search(form):
                yield f"reads as a nodule: {text!r}: {form!r}"
            if texts.places(form) != texts.places(text):
                yield f"other numbers in it: {text!r}: {form!r}"
            if text.startswith(" ") != form.startswith(" ") or ("&" in text) != ("&" in form):
                yield f"a space or mnemonic differs: {text!r}: {form!r}"


def write(root, language, table):
    known = {}
    path = file_of(root, language)
    if path.exists():
        known = {text: forms for text, forms in texts.in_translation(path).items() if forms}
    for line in pathlib.Path(table).read_text(encoding="utf-8").splitlines():
        if "\t" in line:
            text, translation = line.split("\t")
            known[text.replace("\\n", "\n")] = translation.replace("\\n", "\n").split("|||")
    escape = xml.sax.saxutils.escape
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>", f'<TS version="2.1" language="{language}">',
             "<context>", "    <name>PD-Render</name>"]
    for text in sorted(texts.in_sources(root)):
        forms = known.get(text)
        plural = "%n" in text
        lines.append('    <message numerus="yes">' if plural else "    <message>")
        lines.append(f"        <source>{escape(text)}</source>")
        mark = "" if forms else ' type="unfinished"'
        body = "".join(f"<numerusform>{escape(form)}</numerusform>" for form in forms or ["", ""]) if plural else \
            escape((forms or [""])[0])
        lines += [f"        <translation{mark}>{body}</translation>", "    </message>"]
    path.write_text("\n".join(lines + ["</context>", "</TS>", ""]), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--write", nargs=2, metavar=("LANGUAGE", "TABLE"))
    options = parser.parse_args()
    if options.write:
        return write(options.source, *options.write)
    found = [f"{where}: is no phrase(...), so stays English: {text!r}" for where, text in texts.unmarked(options.source)]
    found += [f"{language}: {complaint}" for language in LANGUAGES for complaint in complaints(options.source, language)]
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
