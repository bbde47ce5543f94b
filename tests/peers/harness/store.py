"""What was measured, kept as it is found: a run that is broken off goes on where it was."""

import hashlib
import json
import os
import platform
import re
import time
from pathlib import Path


class Store:
    """A tree of measurements in a JSON file."""

    def __init__(self, path, settings, anew):
        """What is kept is gone on with if it was measured by the same settings; if it is complete,
        unless it is measured anew."""
        self.path = path
        self.data = {"settings": settings, "complete": False}
        if path.exists():
            kept = json.loads(path.read_text())
            if kept["settings"] == settings and not (kept["complete"] and anew):
                self.data = kept

    def at(self, *keys):
        """The branch of these names, made if there is none."""
        branch = self.data
        for key in keys:
            branch = branch.setdefault(key, {})
        return branch

    def save(self):
        partial = self.path.with_suffix(".part")
        partial.write_text(json.dumps(self.data, indent=1))
        partial.replace(self.path)


class Progress:
    """Tells what is done now, and about how long the rest takes."""

    def __init__(self, planned):
        self.planned, self.done, self.begun = planned, 0.0, time.monotonic()

    def step(self, seconds, what):
        """A step begins that was planned to take so long."""
        gone = time.monotonic() - self.begun
        slower = gone / self.done if self.done else 1.0
        left = (self.planned - self.done) * slower
        print(f"[{clock(gone)} gone, about {clock(left)} left] {what}", flush=True)
        self.done += seconds

    def skip(self, seconds):
        """A step that was done before."""
        self.planned -= seconds


def clock(seconds):
    return f"{int(max(0, seconds)) // 60}:{int(max(0, seconds)) % 60:02}"


def machine():
    """The processor, how many, and their widest vectors."""
    try:
        text = Path("/proc/cpuinfo").read_text()
        model = re.search(r"model name\s*: (.*)", text)
        flags = re.search(r"flags\s*: (.*)", text)
        flags = flags[1].split() if flags else []
    except OSError:
        model, flags = None, []
    widest = next((name for flag, name in [
        ("avx512f", "AVX-512"), ("avx2", "AVX2"), ("avx", "AVX")] if flag in flags), "unknown")
    return {
        "processor": model[1] if model else platform.processor() or platform.machine(),
        "cores": os.cpu_count(),
        "vectors": widest,
        "virtual": "hypervisor" in flags,
        "system": f"{platform.system()} {platform.machine()}",
    }


def busy():
    """Processes that wanted to run, on average over a minute; None where the system does not tell.
    """
    try:
        return round(os.getloadavg()[0], 2)
    except OSError:
        return None


def digest(path):
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()[:16]
