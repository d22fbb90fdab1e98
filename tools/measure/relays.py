#!/usr/bin/env python3
"""relays.py PROGRAMS [--relays 8] [--below 7] [--kills 0]: renders one image by two levels, relays and the nodes below each, all of
them processes of one thread with certificates of two authorities, and compares its bits with those of this machine alone.
With --kills N, N processes chosen at random are killed while the image is made, each started again at once.
Prints bytes of the coordinator's connections (TLS and all; without the scan, unless a relay was killed), what was checked, seconds.
By hand, on Linux; cores may be fewer."""

import argparse
import random
import re
import socket
import struct
import subprocess
import tempfile
import time
from pathlib import Path


def free_port():
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        return found.getsockname()[1]


def pixels_of(path):
    """All bytes of an OpenEXR file behind its header and table of offsets, as they are: the header states who took part."""
    data = path.read_bytes()
    at = 8
    while data[at]:
        at = data.index(0, data.index(0, at) + 1) + 1
        at += 4 + struct.unpack_from("<i", data, at)[0]
    return data[struct.unpack_from("<Q", data, at + 1)[0]:]


class Traffic:
    """Bytes of all connections of a port of this machine from now on, those that have ended meanwhile included."""

    def __init__(self, port):
        self.port, self.seen = port, {}
        self.look()
        self.first = self.sums()

    def look(self):
        shown = subprocess.run(["ss", "-tinH", "state", "established", f"( sport = :{self.port} )"],
                               capture_output=True, text=True).stdout
        for peer, facts in re.findall(r"^\d+\s+\d+\s+\S+\s+(\S+).*\n\s+(.*)$", shown, re.M):
            self.seen[peer] = [int(found[1]) if (found := re.search(rf"{word}:(\d+)", facts)) else 0
                               for word in ("bytes_received", "bytes_acked")]

    def sums(self):
        return [sum(column) for column in zip(*self.seen.values())] or [0, 0]

    def since(self):
        return [now - then for now, then in zip(self.sums(), self.first)]


class Process:
    def __init__(self, command, log):
        self.command, self.log = [str(word) for word in command], log
        log.write_text("")
        self.start()

    def start(self):
        self.process = subprocess.Popen(self.command, stdout=subprocess.DEVNULL, stderr=self.log.open("a"))

    def start_again(self):
        self.process.kill()
        self.process.wait()
        self.start()

    def wait_for(self, pattern, times=1):
        while len(found := re.findall(pattern, self.log.read_text(), re.M)) < times:
            if self.process.poll() is not None:
                raise SystemExit(f"{self.command}\n{self.log.read_text()}")
            time.sleep(0.05)
        return found


def start_nodes(arguments, folder, port):
    node = [arguments.programs / "pdrender-node", "--device", "cpu", "--threads", "1"]
    ports = [free_port() for _ in range(arguments.relays)]
    relays = [Process([*node, "--name", f"relay-{i}", "--coordinator", f"127.0.0.1:{port}", "--bundle", folder / "above/node",
                       "--relay", f"127.0.0.1:{own}", "--relay-bundle", folder / "below/coordinator"], folder / f"relay-{i}")
              for i, own in enumerate(ports)]
    below = [Process([*node, "--name", f"node-{i}-{j}", "--coordinator", f"127.0.0.1:{own}", "--bundle", folder / "below/node"],
                     folder / f"node-{i}-{j}") for i, own in enumerate(ports) for j in range(arguments.below)]
    for relay in relays:
        relay.wait_for(r"is there$", arguments.below)
    return relays, below


def render(arguments, folder, name, more):
    command = [arguments.programs / "pdrender-cli", "render", folder / "ct", "-o", folder / f"{name}.exr", "--size", arguments.size,
               "--samples", arguments.samples, "--device", "cpu", "--threads", "1", *more]
    return Process(command, folder / name)


def together(arguments, folder):
    port, chance, kills = free_port(), random.Random(arguments.seed), 0
    relays, below = start_nodes(arguments, folder, port)
    try:
        coordinator = render(arguments, folder, "together", [
            "--listen", f"127.0.0.1:{port}", "--bundle", folder / "above/coordinator", "--await", arguments.relays,
            "--nodes-only", "--check", arguments.check])
        coordinator.wait_for(r"rendering: ")
        traffic = Traffic(port)
        began = last = time.monotonic()
        while coordinator.process.poll() is None:
            traffic.look()
            if kills < arguments.kills and time.monotonic() - last > arguments.pause:
                chance.choice(relays + below).start_again()
                kills, last = kills + 1, time.monotonic()
            time.sleep(0.05)
        took = time.monotonic() - began
    finally:
        for process in relays + below:
            process.process.terminate()
        for process in relays + below:
            process.process.wait()
    if coordinator.process.returncode != 0:
        raise SystemExit(coordinator.log.read_text())
    said = coordinator.log.read_text()
    caught = sum("a tile of it was not" in relay.log.read_text() for relay in relays)
    tiles, checked = (sum(map(int, column)) for column in zip(*re.findall(r"(\d+) tiles, (\d+) checked", said)))
    return took, traffic.since(), tiles, checked, kills, caught


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=Path)
    parser.add_argument("--relays", type=int, default=8)
    parser.add_argument("--below", type=int, default=7)
    parser.add_argument("--kills", type=int, default=0)
    parser.add_argument("--pause", type=float, default=0.5, help="seconds between two kills")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--size", default="240x180")
    parser.add_argument("--samples", type=int, default=1024)
    parser.add_argument("--check", default="some", choices=["some", "all"])
    arguments = parser.parse_args()
    width, height = (int(side) for side in arguments.size.split("x"))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for level in ("above", "below"):
            subprocess.run([arguments.programs / "pdrender-node", "--make-certificates", folder / level], check=True,
                           stdout=subprocess.DEVNULL)
        subprocess.run([arguments.programs / "pdrender-cli", "example", folder / "ct"], check=True, capture_output=True)
        began = time.monotonic()
        if render(arguments, folder, "alone", []).process.wait() != 0:
            raise SystemExit((folder / "alone").read_text())
        alone = time.monotonic() - began
        took, (received, sent), tiles, checked, kills, caught = together(arguments, folder)
        same = pixels_of(folder / "alone.exr") == pixels_of(folder / "together.exr")
    processes = arguments.relays * (1 + arguments.below)
    print(f"{processes} processes, {arguments.relays} relays, {arguments.size}, {arguments.samples} samples, --check {arguments.check}: "
          f"{kills} kills, {'the same bits' if same else 'OTHER BITS'}, {caught} caught; one thread alone {alone:.1f} s, "
          f"together {took:.1f} s; coordinator received {received / width / height:.1f} and sent {sent / width / height:.1f} "
          f"bytes a pixel; {tiles} tiles, {checked} checked")
    raise SystemExit(0 if same else 1)


main()
