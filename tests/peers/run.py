"""How scn stands against its peers, by one command. README.md beside this file tells the rest.

    cargo build --release
    python tests/peers/run.py --quick
"""

import argparse
import glob
import hashlib
import os
import re
import subprocess
import sys
import venv
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
STEPS = ["agree", "references", "start", "renders", "rays", "large", "alone", "report"]


def options():
    parser = argparse.ArgumentParser(description="How scn stands against its peers.")
    parser.add_argument(
        "steps", nargs="*", metavar="STEP",
        help=f"what to do: {', '.join(STEPS)}; without any, all")
    parser.add_argument(
        "--quick", action="store_true", help="fewer and shorter renders: 10 minutes")
    parser.add_argument("--tiny", action="store_true", help="whether it works at all: no figures")
    parser.add_argument(
        "--scn", type=Path, default=os.environ.get("SCN", ROOT / "target" / "release" / "scn"),
        help="the binary; also by the variable SCN")
    parser.add_argument(
        "--work", type=Path, default=ROOT / "out" / "peers",
        help="folder of what is made on the way: environment, scenes, references, measurements")
    parser.add_argument("--only", nargs="*", metavar="SCENE", help="these scenes alone")
    parser.add_argument(
        "--reference-error", type=float, metavar="RELMSE",
        help="how good references must be (0.001; with --quick 0.004)")
    parser.add_argument("--publish", action="store_true", help="write table and plot into docs/")
    found = parser.parse_args()
    found.reference_error = found.reference_error or (0.004 if found.quick else 0.001)
    found.all_steps, found.steps = STEPS, found.steps or STEPS
    for step in found.steps:
        if step not in STEPS:
            parser.error(f"no step `{step}`; there are {', '.join(STEPS)}")
    found.scn, found.work = Path(found.scn).resolve(), found.work.resolve()
    if not found.scn.exists():
        parser.error(f"{found.scn} is not there: cargo build --release, or say --scn")
    return found


def environment(work):
    """Goes on in an environment of its own, which is made if requirements.txt is new."""
    home, wanted = work / "venv", HERE / "requirements.txt"
    stamp, python = home / "made-of", home / "bin" / "python"
    made_of = hashlib.sha256(wanted.read_bytes()).hexdigest()
    if not stamp.exists() or stamp.read_text() != made_of:
        print(f"making {home}", flush=True)
        venv.create(home, with_pip=True, clear=True)
        subprocess.run([python, "-m", "pip", "install", "-q", "-r", wanted], check=True)
        stamp.write_text(made_of)
    if Path(sys.prefix) != home:
        os.execv(python, [python, *sys.argv])
    if "DRJIT_LIBLLVM_PATH" not in os.environ:
        there = glob.glob("/usr/lib/*/libLLVM*.so*") + glob.glob("/usr/lib/llvm*/lib/libLLVM*.so*")
        if there:
            # The newest: libLLVM-19.so.1, libLLVM.so.19.1.
            newest = max(there, key=lambda path: [int(n) for n in re.findall(r"\d+", path)])
            os.environ["DRJIT_LIBLLVM_PATH"] = newest


if __name__ == "__main__":
    asked = options()
    environment(asked.work)
    sys.path.insert(0, str(HERE))
    from harness import steps
    try:
        sys.exit(steps.run(asked))
    except KeyboardInterrupt:
        sys.exit("\nbroken off; the same command goes on from here")
