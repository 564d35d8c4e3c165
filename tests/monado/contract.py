# SPDX-License-Identifier: Apache-2.0
"""What a value sounds and feels like (docs/effects.md), a third time: held against tests/contract before it judges."""
import json
import math
import pathlib

CONTRACT = pathlib.Path(__file__).resolve().parents[1] / "contract/senses.json"


def share(value, lo, hi):
    return 0.5 if hi == lo else min(1.0, max(0.0, (value - lo) / (hi - lo)))


def tone_hz(u, midi, gamma):
    return 440 * 2 ** ((midi[0] + (midi[1] - midi[0]) * u ** gamma - 69) / 12)


def beat(u, rates, weakest):
    """Pulses a second, amplitude."""
    return rates[0] * (rates[1] / rates[0]) ** u, weakest * (1 / weakest) ** u


def check():
    """The formulas above against every contract vector that they speak of."""
    contract = json.loads(CONTRACT.read_text())

    def plain(vector):
        return vector["range"]["scale"] == "linear" and not vector["invert"] and vector["value"] is not None
    checked = 0
    for vector in contract["tone"]:
        if plain(vector) and vector["quantise"] == "none":
            u = share(vector["value"], vector["range"]["lo"], vector["range"]["hi"])
            assert math.isclose(tone_hz(u, vector["midi"], vector["gamma"]), vector["hz"], rel_tol=1e-12), vector
            checked += 1
    for vector in contract["pulses"]:
        if plain(vector):
            u = share(vector["value"], vector["range"]["lo"], vector["range"]["hi"])
            rate, amplitude = beat(u, vector["rateHz"], vector["ampMin"])
            assert math.isclose(rate, vector["rate"], rel_tol=1e-12), (vector, rate)
            assert math.isclose(amplitude, vector["amplitude"], rel_tol=1e-12), (vector, amplitude)
            checked += 1
    assert checked > 20, checked
    return checked
