"""Writes the rooms of "Globillum", on which Radiance was first compared with other programs (1992), as scenes.

    PYTHONPATH=build/python python3 bench/rooms.py FOLDER

A room of 10 x 6 x 3 m with a lamp of .5 x .5 m in the middle of its ceiling, of radiance 10. Albedos are .7 of the
ceiling, .5 of the walls, .3 of the floor. `obstructed` has two partitions, the others have mirrors of .75.
"""
import math
import os
import sys

from glb import glb, quad

FLOOR, WALLS, CEILING, LAMP, MIRROR = range(5)


def partition(x, near, far):
    """A wall of full height, .1 m thick, between two depths."""
    depth = far - near
    return [quad((x - .05, 0, -far), (0, 0, depth), (0, 3, 0), WALLS), quad((x + .05, 0, -near), (0, 0, -depth), (0, 3, 0), WALLS),
            quad((x - .05, 0, -near), (.1, 0, 0), (0, 3, 0), WALLS), quad((x + .05, 0, -far), (-.1, 0, 0), (0, 3, 0), WALLS)]


def room(mirrors=(), more=()):
    def wall(name):
        return MIRROR if name in mirrors else WALLS
    return [quad((0, 0, 0), (10, 0, 0), (0, 0, -6), FLOOR), quad((0, 3, -6), (10, 0, 0), (0, 0, 6), CEILING),
            quad((0, 0, -6), (10, 0, 0), (0, 3, 0), wall("far")), quad((10, 0, 0), (-10, 0, 0), (0, 3, 0), wall("near")),
            quad((0, 0, 0), (0, 0, -6), (0, 3, 0), wall("left")), quad((10, 0, -6), (0, 0, 6), (0, 3, 0), WALLS),
            quad((4.75, 2.999, -3.25), (.5, 0, 0), (0, 0, .5), LAMP), *more]


ROOMS = {
    "plain": room(),
    "obstructed": room(more=partition(3, 3, 6) + partition(7, 0, 3)),
    "mirror-side": room(["near"]),
    "mirror-end": room(["left"]),
    "mirrors-facing": room(["near", "far"]),
}


def material(albedo, **more):
    surface = {"baseColorFactor": [albedo, albedo, albedo, 1], "metallicFactor": 0, "roughnessFactor": 1}
    return {"pbrMetallicRoughness": surface, **more}


def main():
    mirror = material(.75)
    mirror["pbrMetallicRoughness"].update(metallicFactor=1, roughnessFactor=0)
    lamp = material(0, emissiveFactor=[1, 1, 1], extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 10}})
    # From the right end, towards the left one and a little down.
    turn, tilt = math.radians(45), math.radians(-5)
    rotation = [math.cos(turn) * math.sin(tilt), math.sin(turn) * math.cos(tilt), -math.sin(turn) * math.sin(tilt),
                math.cos(turn) * math.cos(tilt)]
    camera = {"type": "perspective", "perspective": {"yfov": 1, "aspectRatio": 1.5, "znear": .01}}
    os.makedirs(sys.argv[1], exist_ok=True)
    for name, meshes in ROOMS.items():
        data = glb(meshes, [material(.3), material(.5), material(.7), lamp, mirror], cameras=[camera],
                   nodes=[{"mesh": 0}, {"camera": 0, "translation": [9.5, 1.6, -3], "rotation": rotation}],
                   scenes=[{"nodes": [0, 1]}])
        with open(os.path.join(sys.argv[1], name + ".glb"), "wb") as file:
            file.write(data)


main()
