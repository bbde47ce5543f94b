"""How much memory a process had at most."""

import re
from pathlib import Path


def peak_memory(process):
    """Bytes of physical memory at the peak so far; None if the system does not tell, or if it has
    ended."""
    try:
        told = re.search(r"VmHWM:\s*(\d+) kB", Path(f"/proc/{process}/status").read_text())
    except OSError:
        return None
    return int(told[1]) * 1024 if told else None
