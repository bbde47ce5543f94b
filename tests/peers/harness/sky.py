"""The sky of scenes.scn as an image: the sides of a cube around the eye, rendered by scn, sampled
by direction. Mitsuba has no such sky (its own is by another model)."""

import numpy as np

from . import pictures

WIDTH, HEIGHT = 2048, 1024

# Renders of scenes.scn: where each looks, and what is up there.
SIDES = {
    "sky_up": ((0, 1, 0), (0, 0, 1)),
    "sky_x": ((1, 0, 0), (0, 1, 0)),
    "sky_nx": ((-1, 0, 0), (0, 1, 0)),
    "sky_z": ((0, 0, 1), (0, 1, 0)),
    "sky_nz": ((0, 0, -1), (0, 1, 0)),
}

# The sky is smooth within a pixel.
SAMPLES = 4

# Rows below the horizon that repeat it, so that interpolation finds no black there. The plane hides
# them.
BELOW = 2


def image(scn, path):
    """Writes the image, in the layout of Mitsuba's `envmap`."""
    sides = scn.pictures(list(SIDES), SAMPLES)
    u = (np.arange(WIDTH) + 0.5) / WIDTH * 2 * np.pi
    # Mitsuba's columns are centred, its rows reach from pole to pole.
    theta = np.arange(HEIGHT) / (HEIGHT - 1) * np.pi
    horizon = HEIGHT // 2
    theta[horizon:horizon + BELOW] = theta[horizon - 1]
    sin = np.sin(theta)[:, None]
    towards = np.stack(np.broadcast_arrays(
        sin * np.sin(u), np.cos(theta)[:, None], -sin * np.cos(u)), axis=-1)
    values = np.zeros((HEIGHT, WIDTH, 3), dtype=np.float32)
    nearest = np.full((HEIGHT, WIDTH), -1.0)
    for name, (forward, up) in SIDES.items():
        if up == (0, 1, 0):
            # Its lower half is black, and no neighbour of the sky.
            half = len(sides[name]) // 2
            sides[name][half:] = sides[name][half - 1]
        depth = towards @ np.array(forward, dtype=float)
        here = depth > nearest
        nearest[here] = depth[here]
        values[here] = lookup(sides[name], towards[here], forward, up)
    values[horizon + BELOW:] = 0
    pictures.write(path, values)


def lookup(side, towards, forward, up):
    """Radiance in directions, between the four pixels around each."""
    size = len(side)
    depth = towards @ np.array(forward, dtype=float)
    right = np.cross(forward, up)
    x = (towards @ right / depth + 1) / 2 * size - 0.5
    y = (1 - towards @ np.array(up, dtype=float) / depth) / 2 * size - 0.5
    x, y = np.clip(x, 0, size - 1.001), np.clip(y, 0, size - 1.001)
    column, row = x.astype(int), y.astype(int)
    x, y = (x - column)[:, None], (y - row)[:, None]
    above = side[row, column] * (1 - x) + side[row, column + 1] * x
    below = side[row + 1, column] * (1 - x) + side[row + 1, column + 1] * x
    return above * (1 - y) + below * y
