#!/usr/bin/env python3
"""How much of the fine lines of a reference a denoised image shows: of small vessels, above all.

    tools/measure/lines_kept.py CLI FOLDER|SCENE.json [--look L] [--size WxH] [--samples 16,32,64] [--reference N] [--seeds N]

CLI is a pdrender-cli. A line is 9 pixels long and differs from what lies 3 pixels to either side by 10 of 255 levels in the
reference, which has other random numbers and is not denoised. Kept is the share of that contrast, all lines together: 1 is
all of it. Beside it: within how many levels 95 % of the reference's lit pixels are shown, its own noise included."""

import argparse
import pathlib
import struct
import subprocess
import tempfile
import zlib

import numpy

REACH, SIDE, CLEAR, WAYS = 4, 3, 10, 16


def levels_of(path: pathlib.Path) -> numpy.ndarray:
    """Grey levels of an 8-bit RGB or RGBA file, row by row."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    channels = 4 if colour == 6 else 3
    rows = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).reshape(height, 1 + width * channels)
    image = numpy.zeros((height + 1, width + 1, channels), numpy.int64)  # with a black pixel before each row
    for y in range(height):
        method, row = rows[y, 0], rows[y, 1:].reshape(width, channels).astype(numpy.int64)
        for x in range(width):
            left, up, corner = image[y + 1, x], image[y, x + 1], image[y, x]
            image[y + 1, x + 1] = (row[x] + predicted(method, left, up, corner)) % 256
    return image[1:, 1:, :3] @ numpy.array([0.2126, 0.7152, 0.0722])


def predicted(method, left, up, corner):
    if method == 0:
        return 0
    if method < 4:
        return (left, up, (left + up) // 2)[method - 1]
    guess = left + up - corner
    off = numpy.abs(numpy.stack([guess - left, guess - up, guess - corner]))
    return numpy.choose(numpy.argmin(off, axis=0), [left, up, corner])


def along(image: numpy.ndarray, way: int, aside: float) -> numpy.ndarray:
    """The mean along a line through each pixel but those near the edges, so many pixels beside it."""
    angle, edge = numpy.pi * way / WAYS, REACH + SIDE + 1
    x, y = numpy.cos(angle), numpy.sin(angle)
    height, width = image.shape
    total = 0
    for i in range(-REACH, REACH + 1):
        dx, dy = round(i * x - aside * y), round(i * y + aside * x)
        total = total + image[edge + dy:height - edge + dy, edge + dx:width - edge + dx]
    return total / (2 * REACH + 1)


def kept(image: numpy.ndarray, reference: numpy.ndarray) -> float:
    shown = whole = 0.0
    for way in range(WAYS):
        def sides(of):
            own = along(of, way, 0)
            return own - along(of, way, -SIDE), own - along(of, way, SIDE)
        left, right = sides(reference)
        is_line = (left * right > 0) & (numpy.minimum(abs(left), abs(right)) >= CLEAR)
        truth, seen = (left + right) / 2, sum(sides(image)) / 2
        shown += float((truth * seen)[is_line].sum())
        whole += float((truth * truth)[is_line].sum())
    return shown / whole if whole else 0.0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cli"), parser.add_argument("source")
    parser.add_argument("--look"), parser.add_argument("--size", default="240x180")
    parser.add_argument("--samples", default="16,32,64")
    parser.add_argument("--reference", type=int, default=1024), parser.add_argument("--seeds", type=int, default=1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        def render(samples, seed, *more):
            path = pathlib.Path(folder) / "image.png"
            command = [options.cli, "render", options.source, "-o", str(path), "--size", options.size, "--samples",
                       str(samples), "--seed", str(seed), *(("--look", options.look) if options.look else ()), *more]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            return levels_of(path)
        reference = render(options.reference, 90001)
        print("samples  raw kept  denoised kept  raw within  denoised within")
        for samples in map(int, options.samples.split(",")):
            columns = []
            for seed in range(1, options.seeds + 1):
                images = render(samples, 1000 * seed), render(samples, 1000 * seed, "--denoised")
                off = [numpy.quantile(abs(image - reference)[reference > 0], 0.95) for image in images]
                columns.append([kept(images[0], reference), kept(images[1], reference), *off])
            mean = numpy.mean(columns, axis=0)
            print(f"{samples:7} {mean[0]:9.2f} {mean[1]:14.2f} {mean[2]:11.1f} {mean[3]:16.1f}")


if __name__ == "__main__":
    main()
