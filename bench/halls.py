"""Writes two scenes of a hall of 20 x 8 x 30 m: `lights` with 40 boxes below 1,000 point lights, and `spheres` with 505
copies of one displaced sphere of 19,800 triangles below one spot.

    PYTHONPATH=build/python python3 bench/halls.py FOLDER

All surfaces are diffuse, and double-sided: Blender's script draws others by a shader that slows shadow rays.
"""
import math
import os
import sys

import numpy as np

import manylight
from glb import glb

MATERIALS = [{"doubleSided": True, "pbrMetallicRoughness": {"baseColorFactor": [*color, 1], "metallicFactor": 0,
                                                            "roughnessFactor": 1}}
             for color in ((.7, .7, .7), (.6, .45, .3), (.3, .5, .65), (.5, .5, .5))]
CAMERA = {"type": "perspective", "perspective": {"yfov": .9, "aspectRatio": 1.5, "znear": .05}}


def box(low, high, material=0):
    corners = [[(low, high)[corner >> axis & 1][axis] for axis in range(3)] for corner in range(8)]
    sides = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    positions = [corners[i] for side in sides for i in side]
    return manylight.Mesh(positions, [[4 * i, 4 * i + k, 4 * i + k + 1] for i in range(6) for k in (1, 2)], material=material)


def sphere(random, count=100):
    """Parallels and meridians of radius 1, displaced by up to .3: 2 count (count - 1) triangles."""
    down, around = (np.arange(1, count) * math.pi / count)[:, None], np.arange(count) * 2 * math.pi / count
    rings = np.stack(np.broadcast_arrays(np.sin(down) * np.cos(around), np.cos(down), -np.sin(down) * np.sin(around)), -1)
    positions = np.vstack([[0, 1, 0], rings.reshape(-1, 3), [0, -1, 0]])
    waves, phases = random.normal(size=(6, 3)) * 5, random.uniform(0, 2 * math.pi, 6)
    positions *= 1 + .05 * np.sin(positions @ waves.T + phases).sum(1, keepdims=True)
    last = len(positions) - 1
    faces = []
    for a in range(count):
        b = (a + 1) % count
        faces += [[0, 1 + a, 1 + b], [last - count + a, last, last - count + b]]
        for ring in range(1, last - count, count):
            faces += [[ring + a, ring + count + a, ring + count + b], [ring + a, ring + count + b, ring + b]]
    return manylight.Mesh(positions, faces, material=1)


def pitched(degrees):
    return [math.sin(math.radians(degrees) / 2), 0, 0, math.cos(math.radians(degrees) / 2)]


def write(path, meshes, nodes, lights):
    """meshes: one list for each mesh. lights: places and lights of KHR_lights_punctual."""
    nodes = nodes + [{"camera": 0, "translation": [0, 4.5, -.7], "rotation": pitched(-9)}]
    for number, (place, _) in enumerate(lights):
        nodes.append({**place, "extensions": {"KHR_lights_punctual": {"light": number}}})
    data = glb(meshes, MATERIALS, nodes=nodes, scenes=[{"nodes": list(range(len(nodes)))}], cameras=[CAMERA],
               extensionsUsed=["KHR_lights_punctual"],
               extensions={"KHR_lights_punctual": {"lights": [light for _, light in lights]}})
    with open(path, "wb") as file:
        file.write(data)


def point(random):
    place = {"translation": random.uniform([-9.8, 5.5, -29.8], [9.8, 7.5, -.2]).tolist()}
    return place, {"type": "point", "color": random.uniform(.6, 1, 3).tolist(), "intensity": random.uniform(.05, .15)}


def block(random, material):
    x, z, width, depth, height = random.uniform([-9, -29, .5, .5, .5], [9, -6, 2, 2, 2.5])
    return box((max(x - width / 2, -9.9), .002, max(z - depth / 2, -29.9)), (min(x + width / 2, 9.9), height, z + depth / 2),
               material)


def copy(random):
    turn = random.normal(size=4)
    return {"mesh": 1, "translation": random.uniform([-9, .7, -29], [9, 7, -3]).tolist(),
            "rotation": (turn / np.linalg.norm(turn)).tolist(), "scale": [random.uniform(.15, .5)] * 3}


def main():
    os.makedirs(sys.argv[1], exist_ok=True)
    random, hall = np.random.default_rng(7), box((-10, 0, -30), (10, 8, 0))
    blocks = [block(random, 1 + i % 3) for i in range(40)]
    write(f"{sys.argv[1]}/lights.glb", [[hall] + blocks], [{"mesh": 0}], [point(random) for _ in range(1000)])
    spot = {"type": "spot", "intensity": 600, "spot": {"innerConeAngle": .5, "outerConeAngle": .7}}
    write(f"{sys.argv[1]}/spheres.glb", [[hall], [sphere(random)]], [{"mesh": 0}] + [copy(random) for _ in range(505)],
          [({"translation": [3, 7.5, -2], "rotation": pitched(-22)}, spot)])


main()
