#!/usr/bin/env python3
"""What GDCM makes of the files that damaged_streams --keep FOLDER left: refused, warned about, unchanged or silent.

    damaged_streams --keep FOLDER
    damaged_streams_gdcm.py FOLDER      (needs python-gdcm)
"""
import collections
import os
import sys
import tempfile

try:
    import gdcm
except ImportError:
    sys.exit("GDCM is not there (pip install python-gdcm): nothing was compared.")


def pixels(path):
    reader = gdcm.ImageReader()
    reader.SetFileName(path)
    if not reader.Read():
        return None
    try:
        return reader.GetImage().GetBuffer()
    except Exception:
        return None


def heard(path):
    """The pixels, and whether anything was said on the way (libraries write to the descriptors)."""
    with tempfile.TemporaryFile() as said:
        kept = [os.dup(1), os.dup(2)]
        sys.stdout.flush()
        os.dup2(said.fileno(), 1)
        os.dup2(said.fileno(), 2)
        try:
            data = pixels(path)
        finally:
            os.dup2(kept[0], 1)
            os.dup2(kept[1], 2)
            os.close(kept[0])
            os.close(kept[1])
        return data, said.seek(0, 2) > 0


def main(folder):
    gdcm.Trace.WarningOn()
    gdcm.Trace.ErrorOn()
    counts = collections.defaultdict(collections.Counter)
    sound = {}
    for line in open(os.path.join(folder, "list.txt"), encoding="utf-8"):
        coding, kind, name, source = line.rstrip("\n").split("\t")
        if source not in sound:
            sound[source], noisy = heard(source)
            if sound[source] is None:
                print(f"GDCM does not read the sound file of {coding}")
            elif noisy:
                print(f"GDCM warns about the sound file of {coding} too")
        data, said = heard(os.path.join(folder, name))
        if data is None:
            verdict = "refused"
        elif said:
            verdict = "warned"
        else:
            verdict = "unchanged" if data == sound[source] else "silent"
        for row in (coding, "all"):
            counts[row, kind][verdict] += 1
    print(f"{'coding':22} {'damage':9} {'refused':>8} {'warned':>7} {'unchanged':>10} {'silent':>7}")
    for (coding, kind), count in counts.items():
        print(f"{coding:22} {kind:9} {count['refused']:8} {count['warned']:7} {count['unchanged']:10} {count['silent']:7}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
