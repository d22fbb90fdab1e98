#!/usr/bin/env python3
"""same_image.py A.exr B.exr: whether two OpenEXR files hold the same pixels, bit by bit, whatever else they say. Ends with 1
where they do not."""

import struct
import sys
from pathlib import Path

# What says how pixels lie in the file; the rest of the header says how the image came about.
LAYOUT = {"channels", "compression", "dataWindow", "displayWindow", "lineOrder"}


def text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def parts(path):
    data, at, layout = path.read_bytes(), 8, {}
    assert data[:4] == b"\x76\x2f\x31\x01", f"{path} is no OpenEXR file"
    while data[at] != 0:
        name, at = text(data, at)
        _, at = text(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        if name in LAYOUT:
            layout[name] = data[at + 4 : at + 4 + size]
        at += 4 + size
    (first,) = struct.unpack_from("<Q", data, at + 1)  # of the table of places, by lines
    return layout, data[first:]


sys.exit(parts(Path(sys.argv[1])) != parts(Path(sys.argv[2])))
