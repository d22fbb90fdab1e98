#!/usr/bin/env python3
"""Processor seconds that an image costs with render nodes of one thread beside one thread, and with the thread alone.

As many images are rendered alone at once as there are threads with nodes, so that both ways keep as many cores busy: a core is
slower beside a busy one.

node_overhead.py FOLDER|SCENE [--build build/release] [--base FOLDER] [--size 512] [--samples 64] [--rounds 5] [--nodes 1] [--seconds S]
Both ways alternate, so that load on the machine affects both; nodes run on, and their seconds of each image count. Seconds of the
clock are those of one image, of images at once that of all divided by their number.
--base: a build to compare with, whose ways alternate with the others. --seconds: no further round after so many. Prints seconds of
each round, medians, and what nodes add: the median of the rounds' ratios, with its quartiles. Wall seconds likewise, for a machine
with a core for each."""
import argparse
import os
import pathlib
import re
import statistics
import subprocess
import tempfile
import time


def seconds_of(process):
    """Processor seconds of a process so far."""
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def spread(ratios):
    """Their median in per cent more than 1, with its quartiles."""
    more = [100 * (ratio - 1) for ratio in ratios]
    low, middle, high = statistics.quantiles(more, method="inclusive") if len(more) > 1 else more * 3
    return f"{middle:.1f} % ({low:.1f} to {high:.1f})"


class Build:
    def __init__(self, programs, nodes):
        self.programs = programs
        self.nodes = [subprocess.Popen([programs / "pdrender-node", "--listen", "127.0.0.1:0", "--threads", "1"],
                                       stderr=subprocess.PIPE, text=True) for _ in range(nodes)]
        self.ports = [int(re.search(r":(\d+)\s*$", node.stderr.readline())[1]) for node in self.nodes]
        self.ways = {"alone": [], "with nodes": []}

    def node_seconds(self):
        return sum(seconds_of(node) for node in self.nodes)

    def images(self, options, way):
        is_alone = way == "alone"
        there = [word for port in self.ports for word in ("--node", f"127.0.0.1:{port}")] + ["--await", str(len(self.ports))]
        count = 1 + len(self.ports) if is_alone else 1
        with tempfile.TemporaryDirectory() as folder:
            before, start = self.node_seconds(), time.monotonic()
            programs = [subprocess.Popen(
                [self.programs / "pdrender-cli", "render", options.scene, "-o", f"{folder}/image{each}.exr", "--threads", "1",
                 "--device", "cpu", "--size", f"{options.size}x{options.size}", "--samples", str(options.samples),
                 *([] if is_alone else there), *options.option], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                for each in range(count)]
            ended = [os.wait4(program.pid, 0) for program in programs]
            if any(status != 0 for _, status, _ in ended):
                raise SystemExit("an image failed")
            wall = time.monotonic() - start
            node = self.node_seconds() - before
        own = sum(usage.ru_utime + usage.ru_stime for _, _, usage in ended)
        self.ways[way].append(((own + node) / count, wall / count))

    def tell(self, name):
        for way, rounds in self.ways.items():
            cpus, walls = zip(*rounds)
            print(f"{name:>8} {way:12} {' '.join(f'{cpu:7.2f}' for cpu in cpus)}   median {statistics.median(cpus):7.2f} s of the "
                  f"processor, {statistics.median(walls):6.2f} s")
        pairs = list(zip(*self.ways.values()))
        processor, clock = ([there[i] / alone[i] for alone, there in pairs] for i in (0, 1))
        print(f"{name:>8} nodes add {spread(processor)} of the processor, {spread(clock)} of the clock")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--base", type=pathlib.Path)
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--nodes", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=float("inf"))
    parser.add_argument("--option", action="append", default=[], help="of pdrender-cli render, as --option=--look=bones")
    options = parser.parse_args()
    builds = {name: Build(build / "bin", options.nodes) for name, build in (("this", options.build), ("base", options.base)) if build}
    try:
        began = time.monotonic()
        for _ in range(options.rounds):
            if time.monotonic() - began > options.seconds:
                break
            for way in ("alone", "with nodes"):
                for build in builds.values():
                    build.images(options, way)
    finally:
        for build in builds.values():
            for node in build.nodes:
                node.terminate()
                node.wait()
    for name, build in builds.items():
        build.tell(name)


if __name__ == "__main__":
    main()
