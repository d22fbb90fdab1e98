#!/usr/bin/env python3
"""Processor seconds that an image costs with one render node beside one thread, and with the thread alone.

node_overhead.py FOLDER|SCENE [--build build/release] [--base FOLDER] [--size 512] [--samples 64] [--rounds 5]
Both ways alternate, so that load on the machine affects both; the node runs on, and its seconds of each image count.
--base: a build to compare with, whose ways alternate with the others. Prints seconds of each round, medians, and the
medians' ratio: what nodes add. Wall seconds are printed beside, for a machine with a core for each."""
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


class Build:
    def __init__(self, programs):
        self.programs = programs
        self.node = subprocess.Popen([programs / "pdrender-node", "--listen", "127.0.0.1:0", "--threads", "1"],
                                     stderr=subprocess.PIPE, text=True)
        self.port = int(re.search(r":(\d+)\s*$", self.node.stderr.readline())[1])
        self.ways = {"alone": [], "with a node": []}

    def image(self, options, way):
        nodes = ["--node", f"127.0.0.1:{self.port}", "--await", "1"] if way == "with a node" else []
        with tempfile.TemporaryDirectory() as folder:
            before, start = seconds_of(self.node), time.monotonic()
            program = subprocess.Popen(
                [self.programs / "pdrender-cli", "render", options.scene, "-o", f"{folder}/image.exr", "--threads", "1",
                 "--device", "cpu", "--size", f"{options.size}x{options.size}", "--samples", str(options.samples),
                 *nodes, *options.option], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            _, status, usage = os.wait4(program.pid, 0)
            if status != 0:
                raise SystemExit("an image failed")
            wall = time.monotonic() - start
            node = seconds_of(self.node) - before
        self.ways[way].append((usage.ru_utime + usage.ru_stime + node, wall))

    def tell(self, name):
        medians = {}
        for way, rounds in self.ways.items():
            medians[way] = statistics.median(cpu for cpu, _ in rounds)
            walls = statistics.median(wall for _, wall in rounds)
            print(f"{name:>8} {way:12} {' '.join(f'{cpu:7.2f}' for cpu, _ in rounds)}   median {medians[way]:7.2f} s "
                  f"of the processor, {walls:6.2f} s")
        print(f"{name:>8} a node adds {100 * (medians['with a node'] / medians['alone'] - 1):.1f} %")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--base", type=pathlib.Path)
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--option", action="append", default=[], help="of pdrender-cli render, as --option=--look=bones")
    options = parser.parse_args()
    builds = {name: Build(build / "bin") for name, build in (("this", options.build), ("base", options.base)) if build}
    try:
        for _ in range(options.rounds):
            for way in ("alone", "with a node"):
                for build in builds.values():
                    build.image(options, way)
    finally:
        for build in builds.values():
            build.node.terminate()
            build.node.wait()
    for name, build in builds.items():
        build.tell(name)


if __name__ == "__main__":
    main()
