"""Renders a GLB or an OBJ from four sides with Cycles: blender -b --factory-startup --python THIS -- FILE FOLDER"""

import math
import os
import sys

import bpy
import numpy

# Importers of older releases use a name that newer ones of numpy lack.
if not hasattr(numpy, "bool"):
    numpy.bool = bool

SIDE = 320
SAMPLES = 24

source, folder = sys.argv[sys.argv.index("--") + 1 :]
bpy.ops.wm.read_factory_settings(use_empty=True)
if source.endswith(".obj"):
    bpy.ops.wm.obj_import(filepath=source)
    # Older releases take all images of an OBJ for colours.
    for image in bpy.data.images:
        if "diffuse" not in image.name:
            image.colorspace_settings.name = "Non-Color"
else:
    bpy.ops.import_scene.gltf(filepath=source)

scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.cycles.samples = SAMPLES
scene.cycles.seed = 1
scene.cycles.use_denoising = False
scene.render.film_transparent = True
scene.render.resolution_x = scene.render.resolution_y = SIDE
scene.render.image_settings.file_format = "PNG"
scene.render.image_settings.color_mode = "RGBA"
scene.view_settings.view_transform = "Standard"

world = bpy.data.worlds.new("world")
world.use_nodes = True
world.node_tree.nodes["Background"].inputs[0].default_value = (0.6, 0.7, 0.8, 1)
scene.world = world
sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
sun.data.energy = 3
sun.rotation_euler = (0.6, 0.3, 0.4)
scene.collection.objects.link(sun)

camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
scene.collection.objects.link(camera)
scene.camera = camera
for view in range(4):
    turn, tilt = math.pi * (0.1 + view / 2), 0.9 if view % 2 == 0 else -0.5
    camera.location = [
        5 * math.cos(tilt) * math.cos(turn),
        5 * math.cos(tilt) * math.sin(turn),
        5 * math.sin(tilt),
    ]
    camera.rotation_euler = (math.pi / 2 - tilt, 0, turn + math.pi / 2)
    scene.render.filepath = os.path.join(folder, f"{view}.png")
    bpy.ops.render.render(write_still=True)
