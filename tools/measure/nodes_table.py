#!/usr/bin/env python3
"""nodes_table.py PROGRAMS [FOLDER] [--size 128x128] [--samples 256] [--only WORD...]: images by render nodes beside the same
images by this machine alone, one row each: whether all pixels have the same bits, results, the share of the samples that were
checked, what chance a result had to be found that was wrong at every 20th or 200th, and processor seconds of all processes
beside those of this machine alone. FOLDER: a CT; none: the example. Nodes are processes of one thread on this machine; some are
killed, stopped, late, behind a relay or many. Ends with 1 where bits differ. By hand, on Linux."""
import argparse
import json
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
TICKS = os.sysconf("SC_CLK_TCK")


def processor_seconds(pid):
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Node:
    """A render node, or a relay, that listens on a port of its own or dials what `dials` says."""

    def __init__(self, programs, *options, dials=None):
        self.command = [programs / "pdrender-node", "--threads", "1", *options]
        self.dials, self.port, self.seconds = dials, 0, 0.0
        self.start()

    def start(self):
        where = ["--coordinator", self.dials] if self.dials else ["--listen", f"127.0.0.1:{self.port}"]
        self.process = subprocess.Popen([*self.command, *where], stderr=subprocess.PIPE, text=True)
        if not self.dials:
            self.port = self.listened_port()
        threading.Thread(target=self.process.stderr.read, daemon=True).start()  # it must not wait for its reader

    def listened_port(self):
        said = ""
        for said in self.process.stderr:
            if found := re.search(r"listening at .*:(\d+)\s*$", said):
                return int(found[1])
        raise SystemExit(f"a node ended: {said}")

    def end(self, how=signal.SIGTERM):
        self.seconds += processor_seconds(self.process.pid)
        self.process.send_signal(signal.SIGCONT)
        self.process.send_signal(how)
        self.process.wait()

    def killed_and_started(self):
        self.end(signal.SIGKILL)
        self.start()

    def halted(self, seconds):
        self.process.send_signal(signal.SIGSTOP)
        time.sleep(seconds)
        self.process.send_signal(signal.SIGCONT)


def kill_two(nodes):
    time.sleep(1)
    nodes[0].killed_and_started()
    time.sleep(0.5)
    nodes[1].killed_and_started()


def halt_one(nodes):
    time.sleep(1)
    nodes[0].halted(3)


RELAY = "relay"  # the nodes are below one
# Name, number of nodes, options of the image, options with nodes only, what happens meanwhile
ROWS = [
    ("one node", 1, [], [], None),
    ("two nodes", 2, [], [], None),
    ("eight nodes", 8, [], [], None),
    ("nodes alone", 2, [], ["--nodes-only"], None),
    ("shared out by samples", 2, [], ["--split", "samples"], None),
    ("all is checked", 2, [], ["--check", "all"], None),
    *[(model, 2, ["--model", model], [], None) for model in
      ("absorption", "emission", "emissionAbsorption", "multipleScattering", "maximumIntensity")],
    ("march of Exposure Render", 2, ["--estimator", "kroesMarch"], [], None),
    ("a lens", 2, ["--aperture", "4"], [], None),
    ("skin taken off", 2, ["--peel", "5"], [], None),
    ("from the left, odd size", 2, ["--view", "left", "--size", "123x77"], [], None),
    ("denoised CT", 2, ["--ct-denoised"], [], None),
    ("parts that were found", 2, ["--find", "shells", "--part", "muscle=Muscles"], [], None),
    ("until 8 levels", 2, ["--levels", "8"], [], None),
    ("until an error of 5 %", 2, ["--error", "5%"], [], None),
    ("two killed and started again", 3, [], ["--nodes-only"], kill_two),
    ("one stands still for 3 s", 3, [], ["--nodes-only"], halt_one),
    ("a relay with two below", 2, [], ["--nodes-only"], RELAY),
]


class Images:
    def __init__(self, options, folder):
        self.options, self.folder, self.known = options, folder, {}

    def image(self, name, words):
        """Renders; returns its file, what it says of itself, and its processor and wall seconds."""
        file, start = self.folder / f"{name}.exr", time.monotonic()
        stop = [] if {"--levels", "--error"} & set(words) else ["--samples", str(self.options.samples)]
        size = [] if "--size" in words else ["--size", self.options.size]
        program = subprocess.Popen([self.options.programs / "pdrender-cli", "render", self.options.scan, "-o", file, "--json",
                                    "--device", "cpu", "--threads", "1", *size, *stop, *words],
                                   stdout=subprocess.PIPE, stderr=(self.folder / "said").open("w"), text=True)
        said = program.stdout.read()
        _, status, usage = os.wait4(program.pid, 0)
        if status != 0:
            raise SystemExit((self.folder / "said").read_text())
        return file, json.loads(said), usage.ru_utime + usage.ru_stime, time.monotonic() - start

    def alone(self, words):
        key = tuple(words)
        if key not in self.known:
            self.known[key] = self.image(f"alone{len(self.known)}", words)
        return self.known[key]

    def row(self, name, count, words, with_nodes, meanwhile):
        alone, _, alone_seconds, _ = self.alone(words)
        programs, port = self.options.programs, free_port()
        relays = [Node(programs, "--relay", f"127.0.0.1:{port}")] if meanwhile == RELAY else []
        nodes = relays + [Node(programs, dials=f"127.0.0.1:{port}" if relays else None) for _ in range(count)]
        dialled = relays or nodes
        happens = threading.Thread(target=meanwhile, args=(nodes,)) if callable(meanwhile) else None
        if happens:
            happens.start()
        there = [word for node in dialled for word in ("--node", f"127.0.0.1:{node.port}")]
        file, said, seconds, wall = self.image("nodes", [*words, *with_nodes, *there, "--await", str(len(dialled))])
        if happens:
            happens.join()
        for node in nodes:
            node.end()
        seconds += sum(node.seconds for node in nodes)
        same = subprocess.run([sys.executable, SOURCE / "tests/slurm/same_image.py", alone, file]).returncode == 0
        share = said.get("nodes", {})
        print(f"{name:30} {count:5}  {'same' if same else 'OTHER':5} {share.get('tiles', 0):7} "
              f"{100 * share.get('checkedShare', 0):8.1f} {100 * share.get('foundOneIn20', 0):9.1f} "
              f"{100 * share.get('foundOneIn200', 0):8.1f} {alone_seconds:9.2f} {seconds:8.2f} {wall:7.2f}", flush=True)
        return same


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=Path)
    parser.add_argument("scan", type=Path, nargs="?")
    parser.add_argument("--size", default="128x128")
    parser.add_argument("--samples", type=int, default=256)
    parser.add_argument("--only", nargs="+", default=[""], help="rows whose names hold one of these words")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if not options.scan:
            options.scan = folder / "ct"
            subprocess.run([options.programs / "pdrender-cli", "example", options.scan], check=True, capture_output=True)
        print(f"{'image':30} {'nodes':>5}  bits  results checked% 1in20 % 1in200 %   alone s  nodes s  wall s")
        images = Images(options, folder)
        same = [images.row(*row) for row in ROWS if any(word in row[0] for word in options.only)]
    return 0 if all(same) else 1


if __name__ == "__main__":
    sys.exit(main())
