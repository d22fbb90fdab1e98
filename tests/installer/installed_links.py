#!/usr/bin/env python3
"""installed_links.py CMAKE BUILD: every link in the documents of an installation leads to a file of it."""
import pathlib
import re
import subprocess
import sys
import tempfile


def links(text):
    """Targets within the installation; what stands in code is no link."""
    found = re.findall(r"\]\(([^)#\s]+)[^)]*\)", re.sub(r"`[^`\n]*`", "", text))
    return [link for link in found if "://" not in link and not link.startswith("mailto:")]


def main():
    cmake, build = sys.argv[1:]
    with tempfile.TemporaryDirectory() as there:
        subprocess.run([cmake, "--install", build, "--prefix", there], check=True, stdout=subprocess.DEVNULL)
        documents = sorted(pathlib.Path(there, "share/doc/pdrender").rglob("*.md"))
        seen = [(document, link) for document in documents for link in links(document.read_text(encoding="utf-8"))]
        dead = [f"{document.relative_to(there)}: {link}" for document, link in seen
                if not (document.parent / link).exists()]
    print("\n".join(dead) or f"{len(seen)} links lead somewhere")
    return 1 if dead or len(seen) < 60 else 0


if __name__ == "__main__":
    sys.exit(main())
