"""Shared by the tests of the installed package."""

from __future__ import annotations

from pathlib import Path

import pytest

import sfumato

ROOT = Path(__file__).resolve().parents[3]
EXAMPLES = ROOT / "examples"

TEXT = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 64 48"
    sf:version="1"><g id="layer" sf:diffuse="true">
  <path id="first" d="M5 40 C20 44 40 36 60 40" sf:left="red, #00f 25%, lime" sf:right="blue"/>
  <path d="M5 10 C20 14 40 6 60 10" sf:left="gold" sf:right="none" sf:blur="2, 5"/>
  <path d="M10 24 C20 28 40 20 50 24" sf:left="#888" sf:left-opacity="0.5, 1"/>
</g></svg>"""


@pytest.fixture
def drawing() -> sfumato.Document:
    return sfumato.read(TEXT)


@pytest.fixture(scope="session")
def evening() -> Path:
    return EXAMPLES / "evening.xml"


@pytest.fixture(scope="session")
def large() -> Path:
    """Returns the path of a drawing that takes a second to solve."""
    return EXAMPLES / "portrait.svg"
