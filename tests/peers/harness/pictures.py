"""Pictures read and written: arrays of rows, columns, and three channels of linear light."""

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")


def read(path):
    bitmap = mi.Bitmap(str(path))
    layers = {name: np.array(layer) for name, layer in bitmap.split()}
    return layers["<root>"][..., :3]


def write(path, values):
    mi.Bitmap(np.ascontiguousarray(values, dtype=np.float32)).write(str(path))
