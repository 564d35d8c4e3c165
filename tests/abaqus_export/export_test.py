#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs tools/abaqus/feelem_export.py on a stand-in for Abaqus' odb interface, and Feelem on what it wrote.

    export_test.py FEELEM SOURCE
"""
import contextlib
import importlib.util
import io
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


def plate(name="PLATE-1", space="THREE_D"):
    """A shell, or a plane element, of four nodes."""
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    nodes = [Named(label=i + 1, coordinates=corner) for i, corner in enumerate(corners)]
    elements = [Named(label=7, type="S4R" if space == "THREE_D" else "CPS4R", connectivity=(1, 2, 3, 4))]
    return Named(name=name, nodes=nodes, elements=elements, embeddedSpace=space, nodeSets={}, elementSets={},
                 sectionAssignments=[])


def shell_stress(instance, of_point):
    """Stress at section points 1 and 5: of_point(point, node) is S11."""
    labels = ("S11", "S22", "S33", "S12")
    field = Field(INTEGRATION_POINT, labels, [])
    field.at_nodes = Field(ELEMENT_NODAL, labels, [
        Named(instance=instance, componentLabels=labels, nodeLabels=[1, 2, 3, 4], elementLabels=[7] * 4,
              sectionPoint=Named(number=point), data=[(of_point(point, i), 0.5, 0.0, 0.25) for i in range(1, 5)],
              conjugateData=None) for point in (1, 5)])
    return field


class NoNodalValues(Field):
    """A field of which Abaqus cannot make values at nodes."""

    def getSubset(self, position):
        raise RuntimeError("not available at this position")


def one_frame_odb(instance, fields, **frame):
    frame = {"incrementNumber": 1, "frameValue": 1.0, "mode": None, "description": "", **frame}
    domain = "MODAL" if frame["mode"] else "TIME"
    step = Named(name="Step-1", domain=domain, procedure="*STATIC", frames=[Named(fieldOutputs=fields, **frame)])
    return Named(name="job.odb", title="", rootAssembly=Named(instances={instance.name: instance}),
                 steps={"Step-1": step}, close=lambda: None)


def results_of(path):
    """Of info --json: (name, layer, complex, step, substep) -> {component: (min, max)}."""
    return {(result["name"], result.get("layer"), result.get("complex"), result["step"], result["substep"]):
            {c["component"]: (c["min"], c["max"]) for c in result["ranges"]}
            for result in info_of(path)["results"]}


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

    def test_section_points_are_layers(self):
        with tempfile.TemporaryDirectory() as folder:
            shell = plate()
            path = export(one_frame_odb(shell, {"S": shell_stress(shell, lambda point, i: 10.0 * point + i)}), folder)
            listed = results_of(path)
            layers = {key[1]: ranges for key, ranges in listed.items() if key[0] == "stress"}
            self.assertEqual(sorted(layers), ["bottom", "top"], listed.keys())
            self.assertEqual(layers["bottom"]["xx"], (11, 14))
            self.assertEqual(layers["top"]["xx"], (51, 54))
            self.assertEqual(layers["top"]["xy"], (0.25, 0.25))

    def test_rotations_follow_their_displacement(self):
        with tempfile.TemporaryDirectory() as folder:
            shell = plate()
            fields = {"U": nodal_field([shell], ("U1", "U2", "U3"), lambda _, i: (1.0 * i, 0.0, 0.5)),
                      "UR": nodal_field([shell], ("UR1", "UR2", "UR3"), lambda _, i: (0.0, -0.125 * i, 0.0))}
            listed = {key[0]: ranges for key, ranges in results_of(export(one_frame_odb(shell, fields), folder)).items()}
            self.assertEqual(listed["displacement"]["x"], (1, 4))
            self.assertEqual(listed["rotation"]["y"], (-0.5, -0.125))

    def test_plane_models_have_two_directions(self):
        with tempfile.TemporaryDirectory() as folder:
            flat = plate(space="TWO_D_PLANAR")
            fields = {"U": nodal_field([flat], ("U1", "U2"), lambda _, i: (1.0 * i, 2.0 * i))}
            listed = {key[0]: ranges for key, ranges in results_of(export(one_frame_odb(flat, fields), folder)).items()}
            self.assertEqual({name: listed["displacement"][name] for name in "xy"}, {"x": (1, 4), "y": (2, 8)})
            self.assertNotIn("rotation", listed)

    def test_complex_values_are_real_and_imaginary_parts(self):
        with tempfile.TemporaryDirectory() as folder:
            listed = results_of(export(make_odb([brick("BRICK-1", 0.0)]), folder))
            parts = {key[2]: ranges for key, ranges in listed.items() if key[:1] == ("displacement",) and key[3] == 3}
            self.assertEqual(parts["real"]["y"], (2, 2))
            self.assertEqual(parts["imaginary"]["z"], (-3, -3))

    def test_complex_values_of_elements_are_named_as_not_written(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as said:
            stack = brick("BRICK-1", 0.0)
            odb = one_frame_odb(stack, {"S": stress_field([stack])})
            odb.steps["Step-1"].domain = "FREQUENCY"
            self.assertEqual(results_of(export(odb, folder)), {})
        self.assertIn("not written: S (complex, at elements)", said.getvalue())

    def test_frequency_of_a_mode_may_be_an_attribute(self):
        with tempfile.TemporaryDirectory() as folder:
            shell = plate()
            fields = {"U": nodal_field([shell], ("U1", "U2", "U3"), lambda _, i: (1.0, 0.0, 0.0))}
            odb = one_frame_odb(shell, fields, mode=3, frequency=12.5)
            step = info_of(export(odb, folder))["steps"][0]
            self.assertEqual((step["kind"], step["substep"]), ("mode", 3))
            self.assertAlmostEqual(step["value"], 12.5, places=9)

    def test_values_of_a_second_instance_stand_at_its_offset(self):
        with tempfile.TemporaryDirectory() as folder:
            value = lambda instance, i: (100.0 * i if instance.name == "B" else 1.0 * i, 0.0, 0.0)
            stack = [brick("A", 0.0), brick("B", 1.0)]
            odb = one_frame_odb(stack[0], {"U": nodal_field(stack, ("U1", "U2", "U3"), value)})
            odb.rootAssembly.instances["B"] = stack[1]
            result = info_of(export(odb, folder))["results"][0]["ranges"][0]
            self.assertEqual((result["min"], result["min_id"], result["max"], result["max_id"]), (1, 1, 800, 1000008))

    def test_fields_are_chosen_and_the_rest_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            odb = make_odb([brick("BRICK-1", 0.0)])
            names = {key[0] for key in results_of(export(odb, folder, "--fields", "NT11"))}
            self.assertEqual(names, {"temperature"})
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as said:
            shell = plate()
            fields = {"E": NoNodalValues(INTEGRATION_POINT, (), []), "CPRESS": nodal_field([shell], (), lambda _, i: 1.0),
                      "NT11": nodal_field([shell], (), lambda _, i: float("inf") if i == 2 else 20.0)}
            export(one_frame_odb(shell, fields), folder)
        self.assertIn("not written: CPRESS, E (not available at this position)", said.getvalue())
        self.assertIn("left out: 1 records with numbers that are not finite", said.getvalue())

    def test_says_wherever_it_is_described_that_it_has_not_run_in_abaqus(self):
        tool = (SOURCE / "tools/abaqus/feelem_export.py").read_text()
        page = (SOURCE / "docs/formats/abaqus.md").read_text()
        self.assertIn("NEVER YET RUN IN ABAQUS", tool)
        self.assertIn("**It has never yet been run in Abaqus**", page)

    def test_says_so_where_there_is_no_abaqus(self):
        done = subprocess.run([sys.executable, str(SOURCE / "tools/abaqus/feelem_export.py"), "job.odb"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("abaqus python", done.stderr)


if __name__ == "__main__":
    FEELEM, SOURCE = (pathlib.Path(text) for text in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])
