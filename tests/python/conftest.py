# SPDX-License-Identifier: MIT
"""Fixtures: the vehicles that most tests use. TRUCKRIDE_LIBRARY says which library."""
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "bindings" / "python"
sys.path.insert(0, str(PACKAGE))
sys.dont_write_bytecode = True

import truckride as tr  # noqa: E402


@pytest.fixture
def spec():
    return tr.vehicle("reference_half", "thesis_dampers")


@pytest.fixture
def model(spec):
    return spec.compile()


@pytest.fixture(scope="session")
def truck():
    return tr.vehicle("reference_truck", "thesis_dampers").compile()


@pytest.fixture
def excitation(model):
    return tr.Excitation(model, tr.Signal.sine(0.005, 1.5))
