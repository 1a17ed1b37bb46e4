"""A data set of views for training: colour, depth, normals and ids of random cameras, and their poses.

    python3 examples/dataset.py scenes/cornell-box.glb views --views 100 --size 256

Each view is an EXR. views.json has the intrinsics, each pose from camera to world (OpenCV's axes), and names of ids.
"""
import argparse
import json
import os

import numpy as np

import manylight

LAYERS = ["beauty", "Z", "normal", "albedo", "id.node", "id.material"]


def random_pose(rng, center, radius):
    """A camera about the scene's centre that looks near it: x right, y down, z forward."""
    away = rng.normal(size=3)
    eye = center + radius * rng.uniform(.3, .6) * away / np.linalg.norm(away)
    forward = center + .2 * radius * rng.normal(size=3) - eye
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, [0, 1, 0])
    right /= np.linalg.norm(right)
    pose = np.eye(4)
    pose[:3, :3] = np.stack([right, np.cross(forward, right), forward], 1)
    pose[:3, 3] = eye
    return pose


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scene")
    parser.add_argument("folder")
    parser.add_argument("--views", type=int, default=100)
    parser.add_argument("--size", type=int, default=256)
    given = parser.parse_args()
    scene, rng = manylight.Scene(given.scene), np.random.default_rng(1)
    poses = [random_pose(rng, np.array(scene.info.center), scene.info.radius) for _ in range(given.views)]
    middle = (given.size - 1) / 2
    intrinsics = [[given.size, 0, middle], [0, given.size, middle], [0, 0, 1]]
    size = (given.size, given.size)
    cameras = [manylight.Camera.from_intrinsics(intrinsics, pose, size, convention="opencv") for pose in poses]
    os.makedirs(given.folder, exist_ok=True)
    with manylight.Device(allow_software=True) as device:
        for i, layers in enumerate(device.render_batch(scene, size, cameras, layers=LAYERS)):
            layers["normal"] = layers["normal"] @ cameras[i].axes.T  # right, up, back
            manylight.write(os.path.join(given.folder, f"{i:04}.exr"), layers)
    with open(os.path.join(given.folder, "views.json"), "w", encoding="utf-8") as file:
        json.dump({"intrinsics": intrinsics, "poses": [pose.tolist() for pose in poses],
                   "nodes": scene.names("node"), "materials": scene.names("material")}, file)


main()
