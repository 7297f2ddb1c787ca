"""Debian's package openclipart-svg: the drawings that the benchmark scripts of this folder use."""
import pathlib
import re

FOLDER = pathlib.Path("/usr/share/openclipart/svg")
LEFT_OUT = re.compile(
    rb"<(?:\w+:)?(?:text|switch|clipPath|mask|filter|pattern|image|marker|symbol|flowRoot)\b|<!ENTITY", re.IGNORECASE)


def plain_files(folder):
    """Returns the SVG files of a folder, and those among them without text, clips, filters and similar elements."""
    files = sorted((file for file in folder.rglob("*.svg") if file.is_file()), key=str)
    return files, [file for file in files if not LEFT_OUT.search(file.read_bytes())]
