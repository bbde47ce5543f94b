"""Mitsuba 3, by the files that export.py writes."""

import mitsuba as mi
import numpy as np

# Samples of a pixel at a time where all pixels are one wavefront, which is kept in memory.
PASS = 16

# Seeds of passes lie between those of pictures.
APART = 1009


class Peer:
    def __init__(self, scene, size, variant):
        mi.set_variant(variant)
        self.version = f"Mitsuba {mi.__version__} {variant}"
        self.at_once = PASS if variant.startswith("llvm") else None
        self.scene = mi.load_file(scene, size=size)
        # Kernels are compiled when they are first needed.
        self.render(1, 0)
        self.render(PASS, 0)

    def render(self, samples, seed):
        at_once, total, done = self.at_once or samples, 0, 0
        while done < samples:
            now = min(at_once, samples - done)
            # Small numbers: the scalar variant takes them times the number of pixels, and keeps 32
            # bits of that.
            picture = mi.render(self.scene, spp=now, seed=seed * APART + done)
            total = total + now * np.array(picture, dtype=np.float64)
            done += now
        return (total / samples)[..., :3], samples
