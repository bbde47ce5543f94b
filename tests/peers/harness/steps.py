"""The steps of run.py, one after another, with what they find kept in a file."""

import importlib.util
import os
from dataclasses import dataclass

from . import alone, large, rays, renders, report, scenes
from .store import Progress, Store, busy, digest, machine


@dataclass
class Plan:
    """How much is measured."""
    size: int  # pixels along a side
    turns: int
    budget: float  # seconds of a render at most
    agree: tuple  # pixels along a side, and along a block's; seeds; samples
    rays: tuple  # primary rays along a side; turns
    alone: int  # samples


PLANS = {
    "full": Plan(512, 7, 20, (128, 8, 16, 64), (700, 11), 64),
    "quick": Plan(512, 3, 5, (64, 4, 12, 64), (500, 5), 16),
    "tiny": Plan(64, 2, 0.2, (16, 4, 6, 16), (50, 3), 4),
}


def programs():
    """The peers there are, and those left out with the reason."""
    found, absent = ["mitsuba scalar"], {}
    if os.environ.get("DRJIT_LIBLLVM_PATH"):
        found.insert(0, "mitsuba llvm")
    else:
        absent["mitsuba llvm"] = "no libLLVM; say DRJIT_LIBLLVM_PATH"
    for program, module in [("cycles", "bpy"), ("luxcore", "pyluxcore")]:
        if importlib.util.find_spec(module):
            found.append(program)
        else:
            absent[program] = f"pip has no {module} for this Python"
    return found, absent


def run(asked):
    name = "tiny" if asked.tiny else "quick" if asked.quick else "full"
    plan = PLANS[name]
    there, absent = programs()
    for program, why in absent.items():
        print(f"without {program}: {why}")
    timed = [name for name in scenes.TIMED if not asked.only or name in asked.only]
    compared = [name for name in scenes.SCENES if not asked.only or name in asked.only]
    bench = renders.Bench(asked.scn, asked.work, there)
    store = Store(asked.work / f"{name}.json", {
        "plan": repr(plan), "scn": digest(asked.scn), "programs": there, "only": asked.only},
        anew=asked.steps != ["report"])
    store.data["machine"] = machine()
    store.data["scn"] = bench.scn.version()
    store.data["absent"] = absent
    store.data["size"], store.data["turns"] = plan.size, plan.turns
    store.data.setdefault("busy", []).append(busy())

    starts = [(name, p) for name in timed for p in bench.of(name) if p not in renders.OTHERS]
    seconds = {
        "agree": len(compared) * plan.agree[2] * 1.0,
        "start": len(starts) * plan.turns * 0.7,
        "renders": sum(len(bench.of(name)) for name in timed) * plan.turns * plan.budget,
        "rays": 60.0,
        "large": len(large.SCENES) * large.SECONDS,
        "alone": len(alone.WAYS) * plan.turns * 2.0 + 10,
    }
    progress = Progress(sum(seconds.get(step, 0) for step in asked.steps))

    if "agree" in asked.steps:
        for name in compared:
            found, each = store.at("agree", name), seconds["agree"] / len(compared)
            if found:
                progress.skip(each)
                continue
            progress.step(each, f"{name}: do the means agree?")
            renders.agree(bench, name, *plan.agree, found)
            store.save()
    references = {}
    if "references" in asked.steps or "renders" in asked.steps:
        for name in timed:
            references[name] = renders.reference(
                bench, name, plan.size, asked.reference_error,
                lambda text, name=name: print(f"{name}: reference, {text}", flush=True))
            print(f"{name}: reference of {references[name].told()}", flush=True)
    if "start" in asked.steps:
        for turn in range(plan.turns):
            for name, program in starts:
                kept = store.at("start", name).setdefault(program, [])
                if len(kept) > turn:
                    progress.skip(0.7)
                    continue
                progress.step(0.7, f"{name}: {program}, one sample")
                kept.append(renders.start(bench, name, plan.size, program))
                store.save()
    if "renders" in asked.steps:
        for name in timed:
            found = store.at("renders", name)
            found["reference"] = references[name].told()
            renders.measure(
                bench, name, plan.size, plan.turns, plan.budget, references[name], found,
                lambda what: progress.step(plan.budget, what), store.save)
    if "rays" in asked.steps:
        rays.measure(asked.work, plan.rays, store, progress)
    if "large" in asked.steps:
        large.measure(
            bench, asked.work, asked.tiny, store.at("large"), progress, store.save)
    if "alone" in asked.steps:
        alone.ways(bench, plan.size, plan.alone, plan.turns, store.at("ways"),
                   lambda what: progress.step(2, what), store.save)
        alone.previews(bench, store.at("previews"),
                       lambda what: progress.step(2, what), store.save)
    store.data["busy"].append(busy())
    store.data["complete"] = store.data["complete"] or asked.steps == asked.all_steps
    store.save()
    if "report" in asked.steps:
        report.write(store.data, asked)
    return 0
