"""The measurements as a page of Markdown and a plot."""

from . import large, scenes
from .aims import aims
from .programs import VARIANTS
from .renders import GOAL
from .rows import ratio, rows

BEGIN, END = "<!-- peers: begin -->", "<!-- peers: end -->"
PLOT = "pictures/peers.svg"
NAMES = {"scn": "scn", **{program: title for program, (title, _, _) in VARIANTS.items()},
         "mitsuba llvm": "Mitsuba llvm", "mitsuba scalar": "Mitsuba scalar",
         "cycles": "Cycles", "luxcore": "LuxCore"}
COLOURS = ["#0b3c5d", "#1b6ca8", "#5aa9d6", "#9ccfe8", "#d1495b", "#e8a0a8", "#8d99ae", "#c9b458"]


def figure(value, digits=2):
    """A number with so many digits that matter, without exponent."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    places = max(0, digits - 1 - int(f"{abs(value):e}".split("e")[1]))
    return f"{value:.{places}f}"


def renders_table(data):
    yield ("| scene | program | samples | million samples a second | the same a CPU second "
           "| relMSE there | seconds to .01 | CPU seconds to .01 | × scn's | whole process, "
           "1 sample | its memory |")
    yield "|" + " --- |" * 11
    for scene in data["renders"]:
        all_rows = rows(data, scene)
        ours = all_rows[0]
        for row in all_rows:
            spread = "" if row.relmse_error is None else f" ± {figure(row.relmse_error, 1)}"
            by_cpu = figure(row.to_goal_cpu / ours.to_goal_cpu)
            times = f"{figure(row.to_goal / ours.to_goal)} ({by_cpu})"
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


def rays_table(data):
    yield ("| scene | rays | scn meet, million a second | in streams | all of a hit | in streams "
           "| Embree | packets of 8 | Embree robust | meet over Embree | in streams | over robust "
           "| in streams | all over Embree | in streams | hits apart |")
    yield "|" + " --- |" * 16
    columns = ("scn meet", "scn streams meet", "scn", "scn streams", "embree", "embree packets",
               "embree robust")
    for name, found in data["rays"].items():
        for kind in found["sets"]:
            programs = kind["programs"]
            rates = " | ".join(
                figure(kind["rays"] / 1e6 / min(programs[p]["seconds"]), 3) if p in programs
                else "-" for p in columns)
            ratios = " | ".join(
                f"{ratio(programs, other, ours):.2f}" if ours in programs else "-"
                for other, ours in [
                    ("embree", "scn meet"), ("embree", "scn streams meet"),
                    ("embree robust", "scn meet"), ("embree robust", "scn streams meet"),
                    ("embree", "scn"), ("embree", "scn streams")])
            apart = programs["scn"]["hits"] - programs["embree robust"]["hits"]
            apart /= max(1, kind["rays"])
            yield (f"| {name}, {found['triangles']:,} triangles | {kind['set']} | {rates} "
                   f"| {ratios} | {1e6 * apart:+.0f} ppm |")


def aims_table(data):
    yield "| what | aim | found | reached |"
    yield "|" + " --- |" * 4
    for what, aim, from_above, found in aims(data):
        reached = found >= aim if from_above else found <= aim
        yield (f"| {what} | at {'least' if from_above else 'most'} {round(aim, 3):g} "
               f"| {figure(found)} | {'yes' if reached else 'no'} |")


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
        f"{data['scn']} (binary {data['settings']['scn']}), {', '.join(versions.values()) or 'no peers'}. "
        f"Processes that wanted to run, at the beginning and the end: "
        f"{', '.join(str(load) for load in data['busy'])} (0 is quiet).",
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
    if data.get("large"):
        lines += ["", *large.table(data["large"])]
    lines += ["", *aims_table(data)]
    return "\n".join(lines) + "\n"


def plot(data, path):
    """Seconds to the goal, a group of points a scene."""
    import matplotlib
    matplotlib.use("svg")
    from matplotlib import pyplot
    pyplot.rcParams["svg.hashsalt"] = "peers"
    colours = dict(zip(NAMES, COLOURS, strict=True))
    figure_, axes = pyplot.subplots(figsize=(8, 3.6))
    seen, at, ticks = set(), 0.0, []
    for scene in data["renders"]:
        all_rows = rows(data, scene)
        for i, row in enumerate(all_rows):
            label = None if row.program in seen else NAMES[row.program]
            seen.add(row.program)
            axes.plot(at + i, row.to_goal, "o", color=colours[row.program], label=label)
            axes.annotate(figure(row.to_goal), (at + i, row.to_goal), (0, 6),
                          textcoords="offset points", ha="center", fontsize=8)
        ticks.append((at + (len(all_rows) - 1) / 2, scenes.scene(scene).title))
        at += len(all_rows) + 1
    axes.set_yscale("log")
    axes.margins(y=0.2)
    axes.grid(axis="y", alpha=0.3)
    axes.set_ylabel(f"seconds to a relMSE of {GOAL}")
    axes.set_xticks([tick for tick, _ in ticks], [title for _, title in ticks], fontsize=8)
    axes.legend(fontsize=8, frameon=False, ncols=4, loc="lower center", bbox_to_anchor=(0.5, 1.0))
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
