"""Makes recorded.rs: what flip-evaluator and scikit-image say of the pairs in pairs.rs.

    pip install flip-evaluator==1.7 scikit-image==0.26.0 numpy
    python tests/peers/measure.py > tests/peers/recorded.rs
    cargo fmt

Not needed to build or to test.
"""

import os
import subprocess
import tempfile
from importlib.metadata import version

import flip_evaluator
import numpy as np
from skimage.metrics import structural_similarity

WIDTH, HEIGHT = 96, 64
NAMES = ["noise", "blur", "hue", "shift", "sun", "night", "exposure"]


def read(folder, name, side):
    values = np.fromfile(os.path.join(folder, f"{name}.{side}.f32"), dtype="<f4")
    return values.reshape(HEIGHT, WIDTH, 3)


def flip(reference, test, mode):
    # A copy each: the evaluator may work in place.
    return flip_evaluator.evaluate(
        reference.copy(), test.copy(), mode, inputsRGB=False, applyMagma=False)


def luma(linear):
    x = np.clip(linear.astype(np.float64), 0, 1)
    encoded = np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)
    return encoded @ [0.2126, 0.7152, 0.0722]


def ssim(reference, test):
    return structural_similarity(
        luma(reference), luma(test), gaussian_weights=True, sigma=1.5,
        use_sample_covariance=False, data_range=1.0)


def main():
    fields = ["ldr_mean", "ldr_max", "hdr_mean", "hdr_max", "start", "stop"]
    print("//! Made by measure.py with flip-evaluator", version("flip-evaluator"), "and scikit-image",
          version("scikit-image") + ".")
    print("\npub struct Values {\n    pub name: &'static str,")
    for field in fields:
        print(f"    pub {field}: f64,")
    print("    pub exposures: u32,\n    pub ssim: f64,\n}\n")
    print("pub const VALUES: &[Values] = &[")
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(
            ["cargo", "test", "-q", "--test", "peers", "--", "--ignored", "write_pairs"],
            env=os.environ | {"SCN_PAIRS": folder}, check=True, stdout=subprocess.DEVNULL)
        for name in NAMES:
            reference, test = read(folder, name, "reference"), read(folder, name, "test")
            ldr_map, ldr_mean, _ = flip(
                np.clip(reference, 0, 1), np.clip(test, 0, 1), "LDR")
            hdr_map, hdr_mean, used = flip(
                np.maximum(reference, 0), np.maximum(test, 0), "HDR")
            found = [ldr_mean, ldr_map.max(), hdr_mean, hdr_map.max(),
                     used["startExposure"], used["stopExposure"]]
            print(f'    Values {{ name: "{name}",')
            for field, value in zip(fields, found):
                print(f"{field}: {float(value):.6f},")
            print(f"exposures: {used['numExposures']}, ssim: {ssim(reference, test):.6f} }},")
    print("];")


main()
