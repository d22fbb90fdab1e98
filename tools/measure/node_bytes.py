#!/usr/bin/env python3
"""Bytes that one render node sends and gets for a pixel: pdrender-cli renders through a relay that counts.

node_bytes.py FOLDER|SCENE [--build build/release] [--size 256] [--samples 256]
Prints bytes a pixel of each way, without the scan, and what a frame of 1920 x 1080 would come to. The busier the machine,
the smaller the orders, and the more often the sums of a block travel."""
import argparse
import pathlib
import re
import socket
import subprocess
import tempfile
import threading


def relay(source, sink, counts, way):
    try:
        while data := source.recv(1 << 18):
            counts[way] += len(data)
            sink.sendall(data)
    except OSError:
        pass
    try:
        sink.shutdown(socket.SHUT_WR)
    except OSError:
        pass


def serve(listener, port, counts):
    client, _ = listener.accept()
    node = socket.create_connection(("127.0.0.1", port))
    ways = [threading.Thread(target=relay, args=args, daemon=True)
            for args in ((client, node, counts, 0), (node, client, counts, 1))]
    for way in ways:
        way.start()
    for way in ways:
        way.join()


def counted(options, samples):
    """Bytes to the node and from it, of one image."""
    programs, counts = options.build / "bin", [0, 0]
    node = subprocess.Popen([programs / "pdrender-node", "--listen", "127.0.0.1:0", "--threads", "1"],
                            stderr=subprocess.PIPE, text=True)
    try:
        port = int(re.search(r":(\d+)\s*$", node.stderr.readline())[1])
        listener = socket.create_server(("127.0.0.1", 0))
        threading.Thread(target=serve, args=(listener, port, counts), daemon=True).start()
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([programs / "pdrender-cli", "render", options.scene, "-o", f"{folder}/image.exr", "--threads",
                            "1", "--device", "cpu", "--size", f"{options.size}x{options.size}", "--samples",
                            str(samples), "--nodes-only", "--await", "1", "--node",
                            f"127.0.0.1:{listener.getsockname()[1]}"], check=True, capture_output=True)
    finally:
        node.terminate()
        node.wait()
    return counts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--samples", type=int, default=256)
    options = parser.parse_args()
    scan, _ = counted(options, 1)
    to_node, from_node = counted(options, options.samples)
    pixels = options.size ** 2
    sums = to_node - scan + from_node
    print(f"{options.samples} samples: {from_node / pixels:.0f} bytes a pixel from the node, {(to_node - scan) / pixels:.0f} "
          f"to it beside the scan ({scan / 1e6:.1f} MB); 1920 x 1080: {sums / pixels * 1920 * 1080 / 1e9:.2f} GB")


if __name__ == "__main__":
    main()
