#!/usr/bin/env python3
"""Bytes that one render node sends and gets for a pixel: a program renders through a relay that counts.

node_bytes.py FOLDER|SCENE [--build build/release] [--size 256] [--samples 256] [--window [--edits N] [--faster N]]
              [--option=--levels=4]...
The image is one for a file, by pdrender-cli with these options; with --window, one on the screen, frame by frame
(tools/measure/shared_window), and so many edits of it; --faster: by a clock that is so many times slower, as if as many nodes of
this speed shared the work.
The node has one thread and takes all samples; the program's own checks them.
Prints what the program says, bytes a pixel of each way, without the scan, by kind of message, and what a frame of 1920 x 1080 would come to."""
import argparse
import collections
import pathlib
import re
import socket
import struct
import subprocess
import tempfile
import threading

# Types of messages, from 1 (app/wire/messages.h)
KINDS = ("Hello Welcome Refused Ping Pong SceneOrder Need Chunk SceneReady SceneRefused Lease Result Abandoned Draining "
         "Forget Bye").split()
SCAN = {"Chunk", "SceneOrder"}


class Frames:
    """Counts messages and their bytes in a stream of frames (app/wire/frame_header.h)."""

    def __init__(self):
        self.count, self.bytes = collections.Counter(), collections.Counter()
        self.head, self.left = b"", 0

    def add(self, data):
        while data:
            if self.left == 0:
                taken = 32 - len(self.head)
                self.head, data = self.head + data[:taken], data[taken:]
                if len(self.head) < 32:
                    return
                kind, map_bytes, payload_bytes = struct.unpack_from("<H4xIQ", self.head, 6)
                name = KINDS[kind - 1] if kind <= len(KINDS) else "?"
                self.left, self.head = map_bytes + payload_bytes, b""
                self.count[name] += 1
                self.bytes[name] += 32 + self.left
            taken = min(self.left, len(data))
            self.left, data = self.left - taken, data[taken:]

    def all_but_scan(self):
        return sum(size for name, size in self.bytes.items() if name not in SCAN)


def relay(source, sink, frames):
    try:
        while data := source.recv(1 << 18):
            frames.add(data)
            sink.sendall(data)
    except OSError:
        pass
    try:
        sink.shutdown(socket.SHUT_WR)
    except OSError:
        pass


def serve(listener, port, ways):
    client, _ = listener.accept()
    node = socket.create_connection(("127.0.0.1", port))
    relays = [threading.Thread(target=relay, args=args, daemon=True)
              for args in ((client, node, ways[0]), (node, client, ways[1]))]
    for one in relays:
        one.start()
    for one in relays:
        one.join()


def command(options, address, folder):
    if options.window:
        return [options.build / "tools/shared_window", options.scene, address, "--size", str(options.size), "--samples",
                str(options.samples), "--edits", str(options.edits), "--faster", str(options.faster)]
    return [options.build / "bin/pdrender-cli", "render", options.scene, "-o", f"{folder}/image.exr", "--threads", "1",
            "--device", "cpu", "--size", f"{options.size}x{options.size}", "--samples", str(options.samples),
            "--nodes-only", "--await", "1", "--node", address, *options.option]


def counted(options):
    """The messages to the node and from it, of one image."""
    ways = [Frames(), Frames()]
    node = subprocess.Popen([options.build / "bin/pdrender-node", "--listen", "127.0.0.1:0", "--threads", "1"],
                            stderr=subprocess.PIPE, text=True)
    try:
        port = int(re.search(r":(\d+)\s*$", node.stderr.readline())[1])
        listener = socket.create_server(("127.0.0.1", 0))
        threading.Thread(target=serve, args=(listener, port, ways), daemon=True).start()
        address = f"127.0.0.1:{listener.getsockname()[1]}"
        with tempfile.TemporaryDirectory() as folder:
            said = subprocess.run(command(options, address, folder), check=True, capture_output=True, text=True)
        print(said.stdout.strip())
    finally:
        node.terminate()
        node.wait()
    return ways


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--samples", type=int, default=256)
    parser.add_argument("--option", action="append", default=[], help="of pdrender-cli render, as --option=--seconds=5")
    parser.add_argument("--window", action="store_true")
    parser.add_argument("--edits", type=int, default=0, help="after the image on the screen")
    parser.add_argument("--faster", type=int, default=1)
    options = parser.parse_args()
    ways = counted(options)
    pixels = options.size ** 2
    for way, name in zip(ways, ("to the node", "from the node")):
        for kind, size in sorted(way.bytes.items(), key=lambda one: -one[1]):
            print(f"{name:>13}: {way.count[kind]:6} {kind:12} {size / pixels:9.2f} bytes a pixel")
    both = sum(way.all_but_scan() for way in ways) / pixels
    print(f"{options.samples} samples: {both:.1f} bytes a pixel both ways without the scan; 1920 x 1080: "
          f"{both * 1920 * 1080 / 1e9:.2f} GB")


if __name__ == "__main__":
    main()
