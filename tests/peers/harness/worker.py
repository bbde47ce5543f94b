"""One peer, with one scene loaded, that renders when asked: a line of JSON in, a line of JSON out.

    python -m harness.worker KIND SCENE SIZE

KIND is a word of KINDS; SCENE the file of a scene for Mitsuba, the name of one for the others.
Asked `{"samples": 16, "seed": 1, "file": "a.npy"}` it answers `{"samples": …, "wall": …, "cpu": …,
"peak": …}`: samples that were taken, seconds of rendering alone, by the clock and of the processor,
and the process's peak memory in bytes.
"""

import json
import os
import resource
import sys
import time

import numpy as np

from .memory import peak_memory

KINDS = {
    "mitsuba llvm": lambda: ("mitsuba_peer", "llvm_ad_rgb"),
    "mitsuba scalar": lambda: ("mitsuba_peer", "scalar_rgb"),
    "cycles": lambda: ("cycles_peer",),
    "luxcore": lambda: ("luxcore_peer",),
}


def cpu():
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def main():
    kind, scene, size = sys.argv[1:]
    # Peers write to stdout as they please: the answers go past them.
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    module, *more = KINDS[kind]()
    peer = __import__(f"harness.{module}", fromlist=["Peer"]).Peer(scene, int(size), *more)
    print(json.dumps({"version": peer.version}), file=answers, flush=True)
    for line in sys.stdin:
        asked = json.loads(line)
        wall, used = time.perf_counter(), cpu()
        values, samples = peer.render(asked["samples"], asked["seed"])
        wall, used = time.perf_counter() - wall, cpu() - used
        np.save(asked["file"], np.asarray(values, dtype=np.float32))
        told = {"samples": samples, "wall": wall, "cpu": used, "peak": peak_memory("self")}
        print(json.dumps(told), file=answers, flush=True)
    # Some peers crash while their libraries are taken down; what was asked is answered.
    os._exit(0)


if __name__ == "__main__":
    main()
