"""What pictures are measured against: many batches by scn and by Mitsuba, of seeds that no
measurement uses, averaged; kept in a file named after the scene's hash, and gone on with."""

import time

import numpy as np

from . import statistics

# Samples of a pixel in a batch: a round of scn's sampler.
BATCH = 64
# Seeds from here on are the reference's.
SEEDS = 4096
# With fewer batches the error is not known well.
FEWEST = 8


class Reference:
    """The mean of all batches, each worth the same; its error is known by their spread."""

    def __init__(self, path):
        self.path = path
        self.sum, self.squares, self.counts = 0.0, 0.0, {}
        if path.exists():
            with np.load(path) as kept:
                self.sum, self.squares = kept["sum"], kept["squares"]
                self.counts = dict(zip(kept["programs"].tolist(), kept["counts"].tolist()))

    @property
    def batches(self):
        return sum(self.counts.values())

    @property
    def mean(self):
        return self.sum / self.batches

    @property
    def error(self):
        """relMSE of the mean; infinite while little is known."""
        if self.batches < FEWEST:
            return float("inf")
        of_one = (self.squares - self.sum ** 2 / self.batches) / (self.batches - 1)
        return statistics.relvar(np.maximum(of_one, 0) / self.batches, self.mean)

    def add(self, program, values):
        values = np.asarray(values, dtype=np.float64)
        self.sum, self.squares = self.sum + values, self.squares + values ** 2
        self.counts[program] = self.counts.get(program, 0) + 1
        partial = self.path.with_suffix(".part.npz")
        np.savez(partial, sum=self.sum, squares=self.squares, programs=list(self.counts),
                 counts=list(self.counts.values()))
        partial.replace(self.path)

    def told(self):
        of = [f"{count * BATCH} samples by {name}" for name, count in self.counts.items()]
        return f"{' and '.join(of)}, relMSE {self.error:.5f}"


def improve(reference, renderers, wanted, say):
    """Adds batches until the error is as wanted. `renderers`: functions of a seed, by the names of
    programs; who has taken the least time is next."""
    taken, done = dict.fromkeys(renderers, 0.0), 0
    while (error := reference.error) > wanted:
        name = min(taken, key=taken.get)
        begun = time.monotonic()
        reference.add(name, renderers[name](SEEDS + reference.counts.get(name, 0)))
        taken[name] += time.monotonic() - begun
        done += 1
        if done % 8 == 0 and reference.batches > FEWEST:
            # The error falls as the number of batches grows.
            more = reference.batches * (error / wanted - 1) * sum(taken.values()) / done
            say(f"relMSE {error:.5f} after {reference.batches} batches, about {more:.0f} s more")
