"""Lays out OBJ files by Blender's Smart UV Project: blender -b --factory-startup --python THIS -- FROM TO [FROM TO ...]"""

import sys

import bpy

names = sys.argv[sys.argv.index("--") + 1 :]
for source, target in zip(names[::2], names[1::2]):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.obj_import(filepath=source)
    for thing in list(bpy.data.objects):
        bpy.context.view_layer.objects.active = thing
        thing.select_set(True)
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.uv.smart_project()
        bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.wm.obj_export(filepath=target, export_materials=False)
