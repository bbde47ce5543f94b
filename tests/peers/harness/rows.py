"""What measurements come to: a row of figures for a program on a scene, ratios of rays."""

import statistics as middle

from .programs import OURS
from .renders import GOAL
from .statistics import mean_error


def median(values):
    values = list(values)
    return middle.median(values) if values else None


class Row:
    """A program on a scene."""

    def __init__(self, data, scene, program):
        self.program = program
        runs = data["renders"][scene]["runs"][program]
        starts = data.get("start", {}).get(scene, {})
        # What is no rendering: the same whatever is set.
        alone = starts.get("scn", [])
        starts = starts.get(program, [])
        self.start = median(run["wall"] for run in starts)
        self.memory = median(run["peak"] for run in starts if run["peak"])
        self.samples = runs[0]["samples"]
        wall = [run["wall"] for run in runs]
        cpu = [self.rendering(run, alone) for run in runs]
        million = [run["samples"] * data["size"] ** 2 / 1e6 for run in runs]
        self.rate = median(of / seconds for of, seconds in zip(million, wall))
        self.rate_cpu = median(of / seconds for of, seconds in zip(million, cpu))
        # Both factors vary from turn to turn: the error by chance, the time by what else runs.
        self.relmse, self.relmse_error = mean_error([run["relmse"] for run in runs])
        self.to_goal = median(wall) * self.relmse / GOAL
        self.to_goal_cpu = median(cpu) * self.relmse / GOAL

    def rendering(self, run, starts):
        """The processor's seconds of rendering alone. Scn's are a whole process's: what one that
        renders a single sample needs is taken off."""
        if self.program not in OURS or run["samples"] < 2 or not starts:
            return run["cpu"]
        one = median(start["cpu"] for start in starts)
        share = run["samples"] / (run["samples"] - 1)
        return max(run["cpu"] - one, 1e-3) * share


def rows(data, scene):
    """All programs on a scene, scn first."""
    return [Row(data, scene, program) for program in data["renders"][scene]["runs"]]


def ratio(programs, other, ours="scn"):
    """Median over the turns of scn's rays a second over another program's."""
    turns = zip(programs[ours]["seconds"], programs[other]["seconds"])
    return median(theirs / ours for ours, theirs in turns)
