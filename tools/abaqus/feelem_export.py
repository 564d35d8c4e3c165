# SPDX-License-Identifier: Apache-2.0
"""Writes the mesh and the field results of an Abaqus .odb as one ASCII results file (.fil) that Feelem reads.

    abaqus python feelem_export.py job.odb [-o job.fil] [--steps last|all] [--fields U,S,NT11]

An .odb can be opened by Abaqus alone, so this runs under Abaqus' own Python (2.7 or 3) and uses nothing else.
NEVER YET RUN IN ABAQUS: it was written from the documented odb interface and tested against a stand-in for it.

What it writes, beyond what Abaqus itself puts into a .fil:
- ids of several instances that repeat each other get the offset that Feelem gives them in a deck: those of the
  second instance + 1000000 (or more, a power of ten), of the third twice that;
- records of key 9001 before elements: the part they belong to, as text in words of eight letters;
- element results extrapolated to the nodes of each element, not averaged, as Abaqus/Viewer does before it averages.
"""
from __future__ import division, print_function

import argparse
import math
import re
import sys

LINE = 80
PART_KEY = 9001
# Field of the .odb -> key of the .fil. Others are named at the end as not written.
KEYS = {
    'U': 101, 'V': 102, 'A': 103, 'RF': 104, 'EPOT': 105, 'CF': 106, 'POR': 108, 'NT11': 201, 'RFL11': 204,
    'TEMP': 2, 'S': 11, 'E': 21, 'PE': 22, 'CE': 23, 'IE': 24, 'EE': 25, 'HFL': 28, 'PEEQ': 73, 'THE': 88,
    'LE': 89, 'NE': 90,
}
ROTATIONS = {'U': 'UR', 'V': 'VR', 'A': 'AR', 'RF': 'RM', 'CF': 'CM'}


class Writer(object):
    """Records as lines of 80 letters."""

    def __init__(self, out):
        self.out = out
        self.rest = ''
        self.not_finite = 0

    def record(self, key, words):
        if any(isinstance(word, float) and not abs(word) < 1e99 for word in words):
            self.not_finite += 1
            return
        items = [self.item(len(words) + 2), self.item(key)]
        items.extend(self.item(word) for word in words)
        self.rest += '*' + ''.join(items)
        whole = len(self.rest) // LINE * LINE
        for at in range(0, whole, LINE):
            self.out.write(self.rest[at:at + LINE] + '\n')
        self.rest = self.rest[whole:]

    def end_increment(self):
        self.record(2001, [])
        if self.rest:
            self.out.write(self.rest.ljust(LINE) + '\n')
            self.rest = ''
        self.out.write(' ' * LINE + '\n')

    @staticmethod
    def item(word):
        if isinstance(word, str):
            return 'A' + word[:8].ljust(8)
        if isinstance(word, float):
            # Room for two digits of an exponent; what is smaller is zero in any float32.
            return 'D' + ('% .15E' % (word if abs(word) > 1e-99 else 0.0)).replace('E', 'D')
        digits = '%d' % word
        return 'I%2d%s' % (len(digits), digits)


def letters(text, words=None):
    """Text as words of eight letters; `words`: as many."""
    pieces = [str(text[at:at + 8]) for at in range(0, len(text), 8)]
    if words is None:
        return pieces or ['']
    return (pieces + [''] * words)[:words]


class Numbering(object):
    """Ids over all instances: Feelem's rule for decks."""

    def __init__(self, instances):
        nodes = [set(node.label for node in instance.nodes) for instance in instances]
        elements = [set(element.label for element in instance.elements) for instance in instances]
        repeated = any(sum(map(len, ids)) != len(set().union(*ids)) for ids in (nodes, elements) if ids)
        largest = max([0] + [max(ids) for ids in nodes + elements if ids])
        step = 1000000
        while step <= largest:
            step *= 10
        self.step = step if repeated else 0
        self.offsets = dict((instance.name, i * self.step) for i, instance in enumerate(instances))

    def of(self, instance):
        return self.offsets[instance.name]


def parts_of(instance, alone):
    """Element label -> part: the instance, or the section where there is one instance only."""
    parts = {}
    if alone:
        for assignment in getattr(instance, 'sectionAssignments', ()):
            for element in assignment.region.elements:
                parts[element.label] = str(assignment.sectionName)
    return parts


def write_mesh(odb, writer, numbering, instances, dimensions):
    count = [sum(len(getattr(instance, what)) for instance in instances) for what in ('elements', 'nodes')]
    version = str(getattr(getattr(odb, 'jobData', None), 'version', '')) or 'odb'
    writer.record(1921, letters(version, 1) + letters('odb', 3) + count + [1.0])
    current = None
    for instance in instances:
        offset = numbering.of(instance)
        parts = parts_of(instance, len(instances) == 1)
        for element in instance.elements:
            part = parts.get(element.label, str(instance.name))
            if part != current:
                writer.record(PART_KEY, letters(part))
                current = part
            nodes = [label + offset for label in element.connectivity]
            writer.record(1900, [element.label + offset] + letters(str(element.type), 1) + nodes)
    for instance in instances:
        offset = numbering.of(instance)
        for node in instance.nodes:
            writer.record(1901, [node.label + offset] + [float(x) for x in node.coordinates])
    write_sets(writer, numbering, instances)
    writer.record(1902, [1, 2, 3, 4, 5, 6] if dimensions == 3 else [1, 2, 0, 0, 0, 3])
    writer.record(1922, letters(str(getattr(odb, 'title', '') or odb.name), 10))
    writer.end_increment()


def write_sets(writer, numbering, instances):
    """Long names are numbers that records 1940 explain."""
    names = []
    for instance in instances:
        offset = numbering.of(instance)
        for first_key, what, sets in ((1931, 'nodes', instance.nodeSets), (1933, 'elements', instance.elementSets)):
            for name in sets.keys():
                labels = [member.label + offset for member in getattr(sets[name], what)]
                names.append('%s.%s' % (instance.name, name) if len(instances) > 1 else str(name))
                writer.record(first_key, letters('%8d' % len(names)) + labels[:70])
                for at in range(70, len(labels), 70):
                    writer.record(first_key + 1, labels[at:at + 70])
    for number, name in enumerate(names):
        writer.record(1940, [number + 1] + letters(name))


def is_domain(step, word):
    return str(step.domain).upper().endswith(word)


def frequency_of(frame):
    """Of a mode: an attribute in newer versions, else in the text."""
    value = getattr(frame, 'frequency', None)
    if value is None:
        found = re.search(r'Freq\s*=\s*([-+0-9.Ee]+)', str(frame.description))
        value = found.group(1) if found else 0.0
    return float(value)


def rows_of(field, numbering):
    """(id, place, section point, values, labels) of all blocks; place: a node of the element, or 0."""
    for block in field.bulkDataBlocks:
        if block.instance is None:
            continue
        offset = numbering.of(block.instance)
        labels = [str(label) for label in (block.componentLabels or ())]
        data = getattr(block, 'data', None)
        nodes = block.nodeLabels
        elements = block.elementLabels
        point = getattr(block, 'sectionPoint', None)
        section = int(point.number) if point is not None else 0
        of_elements = elements is not None and len(elements) > 0
        for i in range(len(data)):
            row = data[i]
            values = [float(x) for x in row] if hasattr(row, '__len__') else [float(row)]
            place = nodes[i] + offset if of_elements and nodes is not None and len(nodes) > i else 0
            owner = elements[i] if of_elements else nodes[i]
            yield int(owner) + offset, int(place), section, values, labels


def directions(labels):
    """How many direct and shear components a tensor lists."""
    return (len([l for l in labels if l[-2:] in ('11', '22', '33')]),
            len([l for l in labels if l[-2:] in ('12', '13', '23')]))


def imaginary_rows(field, numbering):
    """Imaginary parts at nodes by id."""
    rows = {}
    for block in field.bulkDataBlocks:
        data = getattr(block, 'conjugateData', None)
        if data is None or block.instance is None:
            continue
        offset = numbering.of(block.instance)
        for i in range(len(data)):
            row = data[i]
            rows[int(block.nodeLabels[i]) + offset] = \
                [float(x) for x in row] if hasattr(row, '__len__') else [float(row)]
    return rows


def write_nodal(writer, frame, name, numbering, complex_step):
    rotations = {}
    if ROTATIONS.get(name) in frame.fieldOutputs.keys():
        for id_, _, _, values, _ in rows_of(frame.fieldOutputs[ROTATIONS[name]], numbering):
            rotations[id_] = values
    field = frame.fieldOutputs[name]
    imaginary = imaginary_rows(field, numbering) if complex_step else {}
    for id_, _, _, values, _ in rows_of(field, numbering):
        if complex_step:
            if id_ not in imaginary:
                continue
            values = values + imaginary[id_]
        elif id_ in rotations:
            values = values + rotations[id_]
        writer.record(KEYS[name], [id_] + values)


def write_elemental(writer, frame, name, numbering, position):
    field = frame.fieldOutputs[name].getSubset(position=position)
    for id_, place, section, values, labels in rows_of(field, numbering):
        direct, shear = directions(labels)
        writer.record(1, [id_, place, section, 2, '', direct, shear, 0, 0])
        writer.record(KEYS[name], values)


def is_nodal(field):
    return str(field.locations[0].position).upper() == 'NODAL'


def write_frame(writer, frame, fields, numbering, element_nodal, complex_step, left_out):
    nodal, elemental = [], []
    for name in frame.fieldOutputs.keys():
        if fields and name not in fields:
            continue
        if name not in KEYS:
            if name not in ROTATIONS.values():
                left_out.add(str(name))
            continue
        if not len(frame.fieldOutputs[name].locations):
            continue
        (nodal if is_nodal(frame.fieldOutputs[name]) else elemental).append(name)
    if complex_step and elemental:
        left_out.update(str(name) + ' (complex, at elements)' for name in elemental)
        elemental = []
    for name in elemental:
        writer.record(1911, [0] + letters('', 2))
        try:
            write_elemental(writer, frame, name, numbering, element_nodal)
        except Exception as error:  # Abaqus' own: a field that has no values at nodes of elements.
            left_out.add('%s (%s)' % (name, error))
    for name in nodal:
        writer.record(1911, [1] + letters('', 1))
        write_nodal(writer, frame, name, numbering, complex_step)


def write_steps(odb, writer, options, numbering, element_nodal):
    left_out = set()
    total = 0.0
    names = list(odb.steps.keys())
    for number, name in enumerate(names):
        step = odb.steps[name]
        modal, harmonic = is_domain(step, 'MODAL'), is_domain(step, 'FREQUENCY')
        frames = list(step.frames)
        if options.steps == 'last':
            frames = frames[-1:] if number == len(names) - 1 else []
        for frame in frames:
            increment = int(getattr(frame, 'incrementNumber', 0))
            value = float(frame.frameValue)
            procedure = 1 if 'STATIC' in str(step.procedure).upper() else 0
            time = 0.0 if modal or harmonic else value
            writer.record(2000, [total + time, time, 0.0, 0.0, procedure, number + 1, increment, 0, 0.0,
                                 value if harmonic else 0.0, 0.0] + letters(str(step.name), 10))
            mode = getattr(frame, 'mode', None)
            if modal and mode:
                writer.record(1980, [int(mode), (2 * math.pi * frequency_of(frame)) ** 2, 1.0, 0.0])
            write_frame(writer, frame, options.fields, numbering, element_nodal, harmonic, left_out)
            writer.end_increment()
        if not modal and not harmonic and len(step.frames):
            total += float(step.frames[-1].frameValue)
    return left_out


def export(odb, out, options, element_nodal):
    instances = [odb.rootAssembly.instances[name] for name in odb.rootAssembly.instances.keys()]
    instances = [instance for instance in instances if len(instance.nodes)]
    flat = any('TWO_D' in str(getattr(instance, 'embeddedSpace', '')) for instance in instances)
    flat = flat or any('AXISYM' in str(getattr(instance, 'embeddedSpace', '')) for instance in instances)
    numbering = Numbering(instances)
    writer = Writer(out)
    write_mesh(odb, writer, numbering, instances, 2 if flat else 3)
    left_out = write_steps(odb, writer, options, numbering, element_nodal)
    if numbering.step:
        for instance in instances:
            print('ids of %s: + %d' % (instance.name, numbering.of(instance)))
    if left_out:
        print('not written: ' + ', '.join(sorted(left_out)))
    if writer.not_finite:
        print('left out: %d records with numbers that are not finite' % writer.not_finite)


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('odb')
    parser.add_argument('-o', '--output', help='default: the .odb with the ending .fil')
    parser.add_argument('--steps', choices=('all', 'last'), default='all')
    parser.add_argument('--fields', type=lambda text: text.split(','), default=[], help='default: all that are known')
    options = parser.parse_args(arguments)
    try:
        from odbAccess import openOdb
        from abaqusConstants import ELEMENT_NODAL
    except ImportError:
        print('This needs the Python of Abaqus: abaqus python feelem_export.py job.odb', file=sys.stderr)
        return 1
    name = options.output or re.sub(r'\.odb$', '', options.odb) + '.fil'
    odb = openOdb(options.odb, readOnly=True)
    try:
        with open(name, 'w') as out:
            export(odb, out, options, ELEMENT_NODAL)
    finally:
        odb.close()
    print('written: ' + name)
    return 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
