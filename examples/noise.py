"""Noise of a reference: its error falls with the root of the samples, and standard_error tells it.

    python3 examples/noise.py scenes/cornell-box.glb --size 64 --samples 4 16 64
"""
import argparse

import manylight


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scene")
    parser.add_argument("--size", type=int, default=64)
    parser.add_argument("--samples", type=int, nargs="+", default=[4, 16, 64])
    given = parser.parse_args()
    scene, size = manylight.Scene(given.scene), (given.size, given.size)
    best = manylight.reference(scene, size, samples=8 * max(given.samples), seed=1)
    print("samples  relative RMSE  estimated")
    for samples in given.samples:
        layers = manylight.reference(scene, size, samples=samples, seed=2)
        error = manylight.compare(layers, best, layer="indirect")
        estimated = (layers["standard_error"] ** 2).mean() ** .5 / best["indirect"].mean()
        print(f"{samples:7}  {error:13.4f}  {estimated:9.4f}")


main()
