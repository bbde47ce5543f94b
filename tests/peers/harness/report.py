"""The measurements as a page of Markdown and a plot."""

import statistics as middle

from . import scenes
from .renders import GOAL
from .statistics import mean_error

BEGIN, END = "<!-- peers: begin -->", "<!-- peers: end -->"
PLOT = "pictures/peers.svg"
NAMES = {"scn": "scn", "mitsuba llvm": "Mitsuba llvm", "mitsuba scalar": "Mitsuba scalar",
         "cycles": "Cycles", "luxcore": "LuxCore"}


def median(values):
    return middle.median(values) if values else None


def figure(value, digits=2):
    """A number with so many digits that matter, without exponent."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    places = max(0, digits - 1 - int(f"{abs(value):e}".split("e")[1]))
    return f"{value:.{places}f}"


class Row:
    """A program on a scene."""

    def __init__(self, data, scene, program):
        self.program = program
        runs = data["renders"][scene]["runs"][program]
        starts = data.get("start", {}).get(scene, {}).get(program, [])
        self.start = median([run["wall"] for run in starts])
        self.memory = median([run["peak"] for run in starts if run["peak"]])
        self.samples = runs[0]["samples"]
        self.wall = [run["wall"] for run in runs]
        self.cpu = [self.rendering(run, starts) for run in runs]
        million = [run["samples"] * data["size"] ** 2 / 1e6 for run in runs]
        self.rate = median([of / wall for of, wall in zip(million, self.wall)])
        self.rate_cpu = median([of / cpu for of, cpu in zip(million, self.cpu)])
        # Both factors vary from turn to turn, the error by chance, the time by what else runs.
        self.relmse, self.relmse_error = mean_error([run["relmse"] for run in runs])
        self.to_goal = median(self.wall) * self.relmse / GOAL
        self.to_goal_cpu = median(self.cpu) * self.relmse / GOAL

    def rendering(self, run, starts):
        """The processor's seconds of rendering alone. Scn's are a whole process's: what one that
        renders a single sample needs is taken off."""
        if self.program != "scn" or run["samples"] < 2 or not starts:
            return run["cpu"]
        one = median([start["cpu"] for start in starts])
        share = run["samples"] / (run["samples"] - 1)
        return max(run["cpu"] - one, 1e-3) * share


def renders_table(data):
    yield ("| scene | program | samples | million samples a second | the same a CPU second "
           "| relMSE there | seconds to .01 | CPU seconds to .01 | × scn's | whole process, 1 sample "
           "| its memory |")
    yield "|" + " --- |" * 11
    for scene, found in data["renders"].items():
        rows = [Row(data, scene, program) for program in found["runs"]]
        ours = rows[0]
        for row in rows:
            spread = "" if row.relmse_error is None else f" ± {figure(row.relmse_error, 1)}"
            times = f"{figure(row.to_goal / ours.to_goal)} ({figure(row.to_goal_cpu / ours.to_goal_cpu)})"
            memory = "–" if row.memory is None else f"{row.memory / 1e6:.0f} MB"
            start = "–" if row.start is None else f"{figure(row.start)} s"
            title = scenes.scene(scene).title if row is ours else ""
            yield (f"| {title} | {NAMES[row.program]} | {row.samples} | {figure(row.rate)} "
                   f"| {figure(row.rate_cpu)} | {figure(row.relmse)}{spread} "
                   f"| {figure(row.to_goal)} | {figure(row.to_goal_cpu)} | {times} "
                   f"| {start} | {memory} |")


def agree_table(data):
    yield "| scene | peer | mean, scn's over the peer's | worst block | bound | agree |"
    yield "|" + " --- |" * 6
    for scene, found in data["agree"].items():
        for program, a in found.items():
            yield (f"| {scenes.scene(scene).title} | {NAMES[program]} "
                   f"| {100 * a['relative']:+.3f} ± {100 * a['error']:.3f} % "
                   f"| {a['worst']:.2f} | {a['bound']:.2f} | {'yes' if a['agree'] else 'NO'} |")


def ratio(one, other):
    """Median over the turns of one's rays a second over the other's."""
    return median([theirs / ours for ours, theirs in zip(one["seconds"], other["seconds"])])


def rays_table(data):
    yield ("| scene | rays | scn, million a second | Embree | Embree robust | scn over Embree "
           "| over robust | hits apart |")
    yield "|" + " --- |" * 8
    for name, found in data["rays"].items():
        for kind in found["sets"]:
            programs = kind["programs"]
            scn, fast, robust = (programs[p] for p in ("scn", "embree", "embree robust"))
            rates = [figure(kind["rays"] / 1e6 / min(p["seconds"]), 3) for p in (scn, fast, robust)]
            apart = (scn["hits"] - robust["hits"]) / max(1, kind["rays"])
            yield (f"| {name}, {found['triangles']:,} triangles | {kind['set']} | {rates[0]} "
                   f"| {rates[1]} | {rates[2]} | {ratio(scn, fast):.2f} | {ratio(scn, robust):.2f} "
                   f"| {1e6 * apart:+.0f} ppm |")


def page(data, asked):
    """The part of the page between its marks."""
    machine = data["machine"]
    versions = {}
    for found in data.get("renders", {}).values():
        versions.update(found.get("versions", {}))
    lines = [
        f"By `python tests/peers/run.py{' --quick' if asked.quick else ''} --publish`, "
        f"{data['size']} × {data['size']} pixels, {data['turns']} turns. "
        f"{machine['processor']}, {machine['cores']} cores, {machine['vectors']}"
        f"{', a virtual machine' if machine['virtual'] else ''}; {machine['system']}. "
        f"{data['scn']}, {', '.join(versions.values()) or 'no peers'}. "
        f"Processes that wanted to run, before and after: "
        f"{', '.join(str(load) for load in data['busy'])} (besides what is measured, 0 is quiet).",
    ]
    for peer, why in data.get("absent", {}).items():
        lines.append(f"Without {NAMES.get(peer, peer)}: {why}.")
    if data.get("renders"):
        lines += ["", *renders_table(data), "", f"![Time to a relMSE of .01]({PLOT})", ""]
        own = [f"{scenes.scene(name).title}, {found['reference']}"
               for name, found in data["renders"].items()]
        lines += ["References: " + "; ".join(own) + ". Their errors are taken off."]
    if data.get("agree"):
        lines += ["", *agree_table(data)]
    if data.get("rays"):
        lines += ["", *rays_table(data)]
    return "\n".join(lines) + "\n"


def plot(data, path):
    """Seconds to the goal, a group of bars a scene."""
    import matplotlib
    matplotlib.use("svg")
    from matplotlib import pyplot
    pyplot.rcParams["svg.hashsalt"] = "peers"
    colours = dict(zip(NAMES, ["#1b6ca8", "#d1495b", "#e8a0a8", "#8d99ae", "#c9b458"]))
    figure_, axes = pyplot.subplots(figsize=(8, 3.6))
    seen, at, ticks = set(), 0.0, []
    for scene, found in data["renders"].items():
        rows = [Row(data, scene, program) for program in found["runs"]]
        for i, row in enumerate(rows):
            label = None if row.program in seen else NAMES[row.program]
            seen.add(row.program)
            axes.bar(at + i, row.to_goal, 0.9, color=colours[row.program], label=label)
            axes.text(at + i, row.to_goal, figure(row.to_goal), ha="center", va="bottom", fontsize=8)
        ticks.append((at + (len(rows) - 1) / 2, scenes.scene(scene).title))
        at += len(rows) + 1
    axes.set_yscale("log")
    axes.margins(y=0.12)
    axes.set_ylabel(f"seconds to a relMSE of {GOAL}")
    axes.set_xticks([tick for tick, _ in ticks], [title for _, title in ticks], fontsize=8)
    axes.legend(fontsize=8, frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    figure_.tight_layout()
    figure_.savefig(path, metadata={"Date": None})


def write(data, asked):
    """Prints the page; it and the plot go to the folder of work, and into docs/ if asked for."""
    text = page(data, asked)
    print(text)
    (asked.work / "peers.md").write_text(text)
    if data.get("renders"):
        plot(data, asked.work / "peers.svg")
    if not asked.publish:
        return
    docs = scenes.ROOT / "docs"
    where = docs / "performance.md"
    before, _, rest = where.read_text().partition(BEGIN)
    _, end, after = rest.partition(END)
    if not end:
        raise SystemExit(f"{where} has no lines `{BEGIN}` and `{END}`")
    where.write_text(f"{before}{BEGIN}\n{text}{END}{after}")
    if data.get("renders"):
        plot(data, docs / PLOT)
