"""What scn is to reach, and what it does: ratios to peers in the same run, by the clock."""

from .programs import OURS
from .rows import median, ratio, rows


def aims(data):
    """What, the aim as a number, whether it is to be reached from above, and what was found."""
    if data.get("rays"):
        yield from of_rays(data)
    if data.get("renders"):
        yield from of_renders(data)
    yield from of_scn(data)
    yield from of_large(data.get("large", {}))


def of_rays(data):
    """Against Embree's single rays: scn's one by one, and in streams, as renders ask."""
    for name in ("bunny", "dragon"):
        for kind in data["rays"].get(name, {}).get("sets", []):
            least = 1.4 if kind["set"] in ("primary", "shadow") else 1.3
            for way, ours in [("one by one", "scn meet"), ("in streams", "scn streams meet")]:
                if ours in kind["programs"]:
                    yield (f"{name}, {kind['set']} rays a second {way}, × Embree's one by one",
                           least, True, ratio(kind["programs"], "embree", ours))


def of_renders(data):
    for scene, peer, most in [
            ("cornell_blocks", "mitsuba llvm", 1 / 3), ("two_spheres", "mitsuba llvm", 1 / 2),
            ("gold_and_glass", "mitsuba llvm", 1 / 2), ("sun_and_sky", "mitsuba llvm", 1 / 3)]:
        found = {row.program: row for row in rows(data, scene)} if scene in data["renders"] else {}
        if scene == "cornell_blocks":
            for other, least in [("mitsuba llvm", 1.0), ("mitsuba scalar", 2.5)]:
                if other in found:
                    yield (f"{scene}, samples a second, × {other}'s",
                           least, True, found["scn"].rate / found[other].rate)
        for ours in OURS:
            if peer in found and ours in found:
                yield (f"{scene}, time to .01 by {ours}, × {peer}'s",
                       most, False, found[ours].to_goal / found[peer].to_goal)


def of_scn(data):
    starts = data.get("start", {}).get("cornell_blocks", {}).get("scn")
    if starts:
        yield ("cornell_blocks, one sample, whole process, s",
               0.15, False, median(run["wall"] for run in starts))
        memory = median(run["peak"] for run in starts if run["peak"])
        if memory is not None:
            yield "the same, memory, MB", 40, False, memory / 1e6
    if data.get("previews"):
        seconds = [one for sheet in data["previews"].values() for one in sheet.values()]
        yield "slowest preview of a worksheet, whole process, s", 0.25, False, max(seconds)
    ways = data.get("ways")
    if ways:
        wall, cpu = ({way: median(run[kind] for run in runs) for way, runs in ways.items()}
                     for kind in ("wall", "cpu"))
        yield ("two threads over one", 1.9, True, wall["one thread"] / wall["two threads"])
        yield ("their CPU seconds over one's", 1.05, False, cpu["two threads"] / cpu["one thread"])
        yield ("CPU seconds saved by what the blocks do not require, %", 25, True,
               100 * (1 - cpu["two threads"] / cpu["all forced"]))


def of_large(found):
    if "waves" in found:
        one = found["waves"]
        for what, key, most in [("resident", "geometry", 150), ("at the peak", "peak", 300)]:
            yield (f"{one['triangles']:,} triangles, bytes each {what}",
                   most, False, one[key] / one["triangles"])
    for name, one in found.items():
        yield (f"{name}, peak of memory over what `scn plan` said before",
               1, False, one["peak"] / one["stated"])
