#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs tools/abaqus/feelem_export.py on a stand-in for Abaqus' odb interface, and Feelem on what it wrote.

    export_test.py FEELEM SOURCE
"""
import importlib.util
import json
import pathlib
import subprocess
import sys
import tempfile
import types
import unittest

FEELEM = SOURCE = None


class Named(types.SimpleNamespace):
    """Any object of the odb interface: what it has is said in the call."""


class Position(str):
    pass


NODAL, INTEGRATION_POINT, ELEMENT_NODAL = Position("NODAL"), Position("INTEGRATION_POINT"), Position("ELEMENT_NODAL")


def brick(name, lift):
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    nodes = [Named(label=i + 1, coordinates=(x, y, z + lift)) for i, (x, y, z) in enumerate(corners)]
    elements = [Named(label=1, type="C3D8R", connectivity=tuple(range(1, 9)))]
    region = Named(elements=elements)
    return Named(name=name, nodes=nodes, elements=elements, embeddedSpace="THREE_D",
                 nodeSets={"A SET WITH A LONG NAME": Named(nodes=nodes[:4])}, elementSets={"ALL": Named(elements=elements)},
                 sectionAssignments=[Named(region=region, sectionName="Section-Steel")])


class Field:
    """A FieldOutput; values per block: instance -> rows."""

    def __init__(self, position, labels, blocks):
        self.locations = [Named(position=position)]
        self.bulkDataBlocks = blocks
        self.componentLabels = labels
        self.at_nodes = None

    def getSubset(self, position):
        assert position == ELEMENT_NODAL
        return self.at_nodes


def nodal_field(instances, labels, value, imaginary=None):
    blocks = []
    for instance in instances:
        ids = [node.label for node in instance.nodes]
        blocks.append(Named(instance=instance, componentLabels=labels, nodeLabels=ids, elementLabels=None, sectionPoint=None,
                            data=[value(instance, i) for i in ids],
                            conjugateData=[imaginary(instance, i) for i in ids] if imaginary else None))
    return Field(NODAL, labels, blocks)


def stress_field(instances):
    labels = ("S11", "S22", "S33", "S12", "S13", "S23")
    field = Field(INTEGRATION_POINT, labels, [])
    field.at_nodes = Field(ELEMENT_NODAL, labels, [
        Named(instance=instance, componentLabels=labels, nodeLabels=list(range(1, 9)), elementLabels=[1] * 8,
              sectionPoint=None, data=[(100.0 * i, 1.0, 2.0, 3.0, 4.0, 5.0) for i in range(1, 9)], conjugateData=None)
        for instance in instances])
    return field


def make_odb(instances):
    displacement = nodal_field(instances, ("U1", "U2", "U3"), lambda instance, i: (0.125 * i, 0.0, -1e-120))
    temperature = nodal_field(instances, (), lambda instance, i: 20.1 + i if i < 8 else float("nan"))
    static = Named(name="Load", domain="TIME", procedure="*STATIC", frames=[
        Named(incrementNumber=0, frameValue=0.0, fieldOutputs={"U": displacement}, mode=None, description=""),
        Named(incrementNumber=4, frameValue=2.0, mode=None, description="", fieldOutputs={
            "U": displacement, "NT11": temperature, "S": stress_field(instances), "COPEN": displacement})])
    modes = Named(name="Shake", domain="MODAL", procedure="*FREQUENCY", frames=[
        Named(incrementNumber=1, frameValue=0.0, mode=1, fieldOutputs={"U": displacement},
              description="Mode         1: Value =  986.96     Freq =   5.0000     (cycles/time)")])
    harmonic = Named(name="Sweep", domain="FREQUENCY", procedure="*STEADY STATE DYNAMICS", frames=[
        Named(incrementNumber=1, frameValue=50.0, mode=None, description="", fieldOutputs={
            "U": nodal_field(instances, ("U1", "U2", "U3"), lambda i, n: (1.0, 2.0, 3.0), lambda i, n: (-1.0, -2.0, -3.0))})])
    return Named(name="job.odb", title="A stack", rootAssembly=Named(instances={i.name: i for i in instances}),
                 steps={"Load": static, "Shake": modes, "Sweep": harmonic}, close=lambda: None)


def export(odb, folder, *arguments):
    spec = importlib.util.spec_from_file_location("feelem_export", SOURCE / "tools/abaqus/feelem_export.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules["odbAccess"] = Named(openOdb=lambda name, readOnly: odb)
    sys.modules["abaqusConstants"] = Named(ELEMENT_NODAL=ELEMENT_NODAL)
    spec.loader.exec_module(module)
    written = pathlib.Path(folder, "job.fil")
    assert module.main(["job.odb", "-o", str(written), *arguments]) == 0
    return written


def info_of(path):
    done = subprocess.run([str(FEELEM), "info", "--json", str(path)], capture_output=True, check=True, text=True)
    return json.loads(done.stdout)


class Export(unittest.TestCase):
    def test_lines_are_80_letters(self):
        with tempfile.TemporaryDirectory() as folder:
            lines = export(make_odb([brick("BRICK-1", 0.0)]), folder).read_text().splitlines()
            self.assertEqual({len(line) for line in lines}, {80})

    def test_one_instance_keeps_its_ids_and_its_sections_are_parts(self):
        with tempfile.TemporaryDirectory() as folder:
            info = info_of(export(make_odb([brick("BRICK-1", 0.0)]), folder))
            text = json.dumps(info)
            self.assertIn("Section-Steel", text)
            self.assertNotIn("1000001", text)
            for name in ("displacement", "temperature", "stress"):
                self.assertIn(name, text)

    def test_instances_that_repeat_ids_get_offsets(self):
        with tempfile.TemporaryDirectory() as folder:
            path = export(make_odb([brick("BRICK-1", 0.0), brick("BRICK-2", 1.0)]), folder)
            text = path.read_text().replace("\n", "")
            self.assertIn("I 71000008", text)
            info = info_of(path)
            self.assertIn("BRICK-2", json.dumps(info))

    def test_values_come_through(self):
        with tempfile.TemporaryDirectory() as folder:
            path = export(make_odb([brick("BRICK-1", 0.0)]), folder)
            listed = subprocess.run([str(FEELEM), "info", str(path)], capture_output=True, check=True, text=True).stdout
            steps = [line for line in listed.splitlines() if line[:4].strip()[:2] in ("1.", "2.", "3.")]
            self.assertEqual(len(steps), 4, listed)
            self.assertRegex(listed, r"displacement x\s.*0\.125 @ 1\s+1 @ 8")
            self.assertRegex(listed, r"temperature\s.*21\.1 @ 1\s+27\.1 @ 7\s+1")
            self.assertRegex(listed, r"stress xx\s.*100 @ \S+\s+800 @ ")
            self.assertRegex(listed, r"mode\s+5\s")
            self.assertRegex(listed, r"frequency\s+50\s")

    def test_only_the_last_frame(self):
        with tempfile.TemporaryDirectory() as folder:
            path = export(make_odb([brick("BRICK-1", 0.0)]), folder, "--steps", "last")
            self.assertEqual(path.read_text().replace("\n", "").count("I 42000"), 1)

    def test_says_so_where_there_is_no_abaqus(self):
        done = subprocess.run([sys.executable, str(SOURCE / "tools/abaqus/feelem_export.py"), "job.odb"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("abaqus python", done.stderr)


if __name__ == "__main__":
    FEELEM, SOURCE = (pathlib.Path(text) for text in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])
