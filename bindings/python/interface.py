"""Describes the C interface to cffi. setup.py writes the description into each wheel as
sfumato/_interface.py; `python3 interface.py` writes it into the checkout. The source is sfumato.h.
"""

import re
from pathlib import Path

from cffi import FFI

HERE = Path(__file__).resolve().parent
HEADER = HERE.parent.parent / "include" / "sfumato" / "sfumato.h"

# Comments, the braces of extern "C", directives that define no number, and the macro for exports.
OTHERS = r'/\*.*?\*/|#ifdef __cplusplus.*?#endif|^#(?!define \w+ \d)[^\n]*|\bSFUMATO_API\b'

ffi = FFI()
ffi.cdef(re.sub(OTHERS, "", HEADER.read_text(), flags=re.DOTALL | re.MULTILINE))
ffi.set_source("sfumato._interface", None)

if __name__ == "__main__":
    ffi.compile(tmpdir=str(HERE))
