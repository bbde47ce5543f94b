"""How far pictures are from a reference, and whether two sets of them have the same means."""

import math

import numpy as np

# Added to the square of the reference: dark pixels count by their difference, not its ratio.
EPSILON = 0.01
# How far blocks may be apart without noise, as a part of the picture's mean and counted as a
# standard error: edges that fall between two pixels are moved by rounding, and show a sliver of
# what is behind.
SLIVER = 2e-4


def relmse(values, reference):
    """Mean of (x - r)^2 / (r^2 + EPSILON) over pixels and channels."""
    return float(np.mean((values - reference) ** 2 / (reference ** 2 + EPSILON)))


def relvar(variance, reference):
    """The same of a picture whose pixels have this variance, and the reference as their mean."""
    return float(np.mean(variance / (reference ** 2 + EPSILON)))


def mean_error(values):
    """Mean, and its standard error; without one of a single value."""
    values = np.array(values, dtype=float)
    if len(values) < 2:
        return float(values.mean()), None
    return float(values.mean()), float(values.std(ddof=1) / math.sqrt(len(values)))


def blocks(values, side):
    """Means of square blocks of pixels."""
    count = len(values) // side
    return values.reshape(count, side, count, side, 3).mean(axis=(1, 3))


def normal_quantile(p):
    """Upper quantile of the normal distribution, by bisection."""
    low, high = 0.0, 40.0
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if math.erfc(middle / math.sqrt(2)) / 2 > p else (low, middle)
    return low


def student_quantile(p, freedom):
    """Upper quantile of Student's t by its Cornish-Fisher expansion; ten degrees of freedom or
    more."""
    z = normal_quantile(p)
    return (z + (z ** 3 + z) / (4 * freedom)
            + (5 * z ** 5 + 16 * z ** 3 + 3 * z) / (96 * freedom ** 2))


def agreement(mine, theirs):
    """Whether two sets of pictures, a picture of block means a seed, have the same expectation.

    Welch's t of each block and channel; with so many comparisons one is expected to be far off by
    chance, so the bound is Sidak's: 1 - (1 - 0.01)^(1/N). And of the whole pictures' means: four
    standard errors."""
    mine, theirs = np.array(mine, dtype=float), np.array(theirs, dtype=float)
    seeds = len(mine)
    error_2 = (mine.var(axis=0, ddof=1) + theirs.var(axis=0, ddof=1)) / seeds
    apart = np.abs(mine.mean(axis=0) - theirs.mean(axis=0))
    scores = apart / np.sqrt(error_2 + (SLIVER * theirs.mean()) ** 2)
    bound = student_quantile((1 - 0.99 ** (1 / scores.size)) / 2, 2 * (seeds - 1))
    whole = mine.mean(axis=(1, 2, 3)), theirs.mean(axis=(1, 2, 3))
    relative = whole[0].mean() / whole[1].mean() - 1
    error = math.sqrt(sum(w.var(ddof=1) / seeds for w in whole)) / whole[1].mean()
    return {"relative": float(relative), "error": float(error), "worst": float(scores.max()),
            "bound": bound, "agree": bool(scores.max() <= bound and abs(relative) <= 4 * error)}
