#!/usr/bin/env python3
"""nodes_scaling.py PROGRAMS OUT.json: renders one image by 1, 2, 4, 8 and 16 render nodes (--nodes), each a process with one thread,
and writes what `pdrender-bench scale --measured OUT.json` compares. By hand, on Linux. Cores may be fewer than nodes.

nodes_scaling.py PROGRAMS --counts: renders one image by 1 to 16 such nodes, in blocks of samples, and compares the messages of
orders and results with what the model has for them: two for each block. Cores may be fewer than nodes.

The clock is the nodes' own processor time while the image is made, the mean of the nodes, so that what the coordinator and
others take of the cores does not count; nor does what a node waits for: the time on the wall is printed beside it. What a piece
of work costs a node beside its samples (leaseSeconds) follows from the runs of 1, 2 and 4 nodes, which take the same samples in more
and more pieces; those of 8 and 16 nodes are then foretold. Runs alternate, and the middle of each kind counts. Messages are orders
and results; bytes are those from the nodes, TLS and all."""

import argparse
import json
import math
import os
import re
import signal
import subprocess
import tempfile
import time
from pathlib import Path

BLOCK = 64  # samples
CHECKED = 0.02  # part of the samples that another node takes again
FEW = 4  # nodes whose runs say what a piece of work costs; those of more are foretold


def processor_seconds(pid):
    return time.clock_gettime(~pid << 3 | 2)  # as clock_getcpuclockid() has it


def received(port):
    """Bytes that came in on all connections of that port of this machine, as far as they are open."""
    shown = subprocess.run(["ss", "-tinH", "state", "established", f"( sport = :{port} )"], capture_output=True, text=True)
    return sum(int(count) for count in re.findall(r"bytes_received:(\d+)", shown.stdout))


class Coordinator:
    """pdrender-cli that waits for nodes; its words are read from a file as they come."""

    def __init__(self, arguments, folder, nodes, size, samples):
        self.said = folder / "said"
        command = [arguments.programs / "pdrender-cli", "render", folder / "ct", "-o", folder / "image.exr",
                   "--size", size, "--samples", str(samples), "--threads", "1", "--nodes-only",
                   "--split", arguments.split, "--listen", "127.0.0.1:0", "--bundle", folder / "certificates/coordinator",
                   "--await", str(nodes)]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=self.said.open("w"))

    def wait_for(self, pattern):
        while not (found := re.search(pattern, self.said.read_text(), re.M)):
            if self.process.poll() is not None:
                raise SystemExit(self.said.read_text())
            time.sleep(0.005)
        return found

    def tiles(self):
        return sum(int(count) for count in re.findall(r"([\d]+) tiles, [\d]+ checked", self.said.read_text()))


def start_node(arguments, folder, address, core):
    command = [arguments.programs / "pdrender-node", "--coordinator", address, "--bundle", folder / "certificates/node",
               "--name", f"core-{core}", "--device", "cpu", "--threads", "1"]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                            preexec_fn=lambda: os.sched_setaffinity(0, {core}))


def image(arguments, folder, nodes, size, samples):
    coordinator = Coordinator(arguments, folder, nodes, size, samples)
    address = coordinator.wait_for(r"^waiting for nodes at (\S+)$")[1]
    cores = sorted(os.sched_getaffinity(0))
    processes = [start_node(arguments, folder, address, cores[i % len(cores)]) for i in range(nodes)]
    try:
        coordinator.wait_for(r"rendering: ")
        before, began = [processor_seconds(node.pid) for node in processes], time.monotonic()
        count = 0
        while coordinator.process.poll() is None:
            count = max(count, received(address.rpartition(":")[2]))
            worked = [processor_seconds(node.pid) - then for node, then in zip(processes, before)]
            took = time.monotonic() - began
            time.sleep(0.05)
    finally:
        for node in processes:
            node.send_signal(signal.SIGTERM)
            node.wait()
    return {"nodes": nodes, "iterations": samples, "iterationsPerSecond": samples * nodes / sum(worked),
            "messages": 2 * coordinator.tiles(), "bytes": count, "wallSeconds": took, "nodeSeconds": worked}


def compare_counts(arguments, folder):
    arguments.split = "samples"
    foretold = 2 * math.ceil(arguments.samples / BLOCK)
    print("nodes  messages  foretold")
    for nodes in (1, 2, 4, 8, 16):
        messages = image(arguments, folder, nodes, arguments.size, arguments.samples)["messages"]
        print(f"{nodes:5}  {messages:8}  {foretold:8}  {100 * (foretold / messages - 1):+.1f} %", flush=True)


def lease_seconds(runs):
    """Processor seconds of a piece of work beside its samples. All runs have the same samples, those that are checked apart: what
    few nodes take longer than one is the time of the pieces that they have more; by least squares."""
    one = runs[1]
    few = [(run["messages"] - one["messages"], sum(run["nodeSeconds"]) - (1 + CHECKED) * sum(one["nodeSeconds"]))
           for nodes, run in runs.items() if 1 < nodes <= FEW]
    return max(0.0, 2 * sum(more * longer for more, longer in few) / sum(more * more for more, _ in few))


def middle(runs):
    return sorted(runs, key=lambda run: run["iterationsPerSecond"])[len(runs) // 2]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=Path)
    parser.add_argument("out", type=Path, nargs="?")
    parser.add_argument("--counts", action="store_true")
    parser.add_argument("--size", default="240x180")
    parser.add_argument("--samples", type=int, default=1024)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--nodes", default="1,2,4,8,16")
    parser.add_argument("--split", default="tiles", choices=["tiles", "samples"])
    arguments = parser.parse_args()
    if arguments.counts == (arguments.out is not None):
        parser.error("give the file to write, or --counts")
    width, height = (int(side) for side in arguments.size.split("x"))
    counts = [int(nodes) for nodes in arguments.nodes.split(",")]
    if not arguments.counts and (1 not in counts or not any(1 < nodes <= FEW for nodes in counts)):
        parser.error(f"--nodes needs 1 and one of 2 to {FEW}: what a piece of work costs follows from them")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        subprocess.run([arguments.programs / "pdrender-node", "--make-certificates", folder / "certificates"], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([arguments.programs / "pdrender-cli", "example", folder / "ct"], check=True, capture_output=True)
        if arguments.counts:
            return compare_counts(arguments, folder)
        rounds = []
        for _ in range(arguments.rounds):
            rounds.append({nodes: image(arguments, folder, nodes, arguments.size, arguments.samples) for nodes in counts})
            print(f"a round: {1000 * lease_seconds(rounds[-1]):.2f} ms a piece", flush=True)
    for nodes in counts:
        for run in rounds:
            print(json.dumps(run[nodes]))
    runs = {nodes: middle([run[nodes] for run in rounds]) for nodes in counts}
    lease = lease_seconds(runs)
    print(f"leaseSeconds {lease:.6f}")
    arguments.out.write_text(json.dumps({
        "format": "pdrender-scale-runs", "formatVersion": 1, "width": width, "height": height, "clock": "processor",
        "cores": len(os.sched_getaffinity(0)),
        "leaseSeconds": lease, "machine": f"nodes of one core, {arguments.split}, medians of {arguments.rounds}",
        "runs": list(runs.values())}, indent=1) + "\n")


main()
