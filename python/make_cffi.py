"""make_cffi.py HEADER OUTPUT.c: writes the C source of manylight._cffi from the public header of libmanylight."""
import re
import sys

import cffi

# Callbacks of Python functions, and the number that a macro names.
OWN = """
#define MANYLIGHT_ZERO ...
extern "Python" int manylight_python_progress(void *, double, const char *);
extern "Python" void manylight_python_log(void *, enum manylight_log_level, const char *);
"""


def declarations(header: str) -> str:
    """What cffi can parse: no preprocessor, no linkage of C++, no attributes. Macros that rename functions apply when the
    C compiler reads the header itself."""
    plain = re.sub(r"#ifdef __cplusplus.*?#endif", "", header, flags=re.DOTALL)
    plain = re.sub(r"^ *#(?:.*\\\n)*.*$", "", plain, flags=re.MULTILINE)
    return plain.replace("MANYLIGHT_API", "")


def main(header: str, output: str) -> None:
    with open(header, encoding="utf-8") as file:
        text = file.read()
    ffi = cffi.FFI()
    ffi.cdef(declarations(text) + OWN)
    ffi.set_source("manylight._cffi", '#include "manylight.h"')
    ffi.emit_c_code(output)


if __name__ == "__main__":
    main(*sys.argv[1:])
