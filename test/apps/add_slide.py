"""Gives lights of a GLB slides: add_slide.py SCENE.glb OUT.glb [PICTURE ...]

Each light has a picture of its own; without pictures the first one has a magenta pixel.
"""
import base64
import json
import struct
import sys

PIXEL = (
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4AWP4z/AfAAQAAf8wiYajAAAAAElFTkSuQmCC"
)


def embed(path):
    kind = "jpeg" if path.endswith(".jpg") else "png"
    with open(path, "rb") as file:
        return f"data:image/{kind};base64," + base64.b64encode(file.read()).decode()


def main(source, target, *pictures):
    with open(source, "rb") as file:
        data = file.read()
    size = struct.unpack_from("<I", data, 12)[0]
    scene, rest = json.loads(data[20 : 20 + size]), data[20 + size :]
    lights = scene["extensions"]["KHR_lights_punctual"]["lights"]
    for light, uri in zip(lights, [embed(path) for path in pictures] or [PIXEL]):
        scene.setdefault("images", []).append({"uri": uri})
        scene.setdefault("textures", []).append({"source": len(scene["images"]) - 1})
        light["extras"] = {"texture": {"index": len(scene["textures"]) - 1}}
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    with open(target, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 20 + len(text) + len(rest)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text + rest)


main(*sys.argv[1:])
