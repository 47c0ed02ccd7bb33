# SPDX-License-Identifier: GPL-3.0-or-later
"""The library of adfric.h: its structures and functions, by ctypes. Each call lets other threads of Python go on."""

import ctypes
import os
from contextlib import contextmanager
from ctypes import POINTER, c_char_p, c_double, c_int, c_int8, c_int32, c_int64, c_void_p
from pathlib import Path

from .errors import FailedError, InputError, StoppedError

# What has become of a call.
BAD_INPUT, FAILED, STOPPED = 2, 3, 4
ERRORS = {BAD_INPUT: InputError, FAILED: FailedError, STOPPED: StoppedError}
# Kinds of variables.
REAL, INTEGER, LOGICAL, WORD, ARRAY = 1, 2, 3, 4, 5
# What an array of results is.
COORDINATE, RESULT, PROFILE, PARAMETER, LIST, EXTRA, WORDS = 1, 2, 3, 4, 5, 6, 7

Progress = ctypes.CFUNCTYPE(c_int, c_void_p, c_int64, c_int64)

# How often a thread of OpenMP looks whether the others are done, before it sleeps. OpenMP's 300000 times cost milliseconds a wait where
# cores have other work.
LOOKS_BEFORE_SLEEP = {"GOMP_SPINCOUNT": "10000"}


class ModelInfo(ctypes.Structure):
    """adfric_model_info"""

    _fields_ = [("name", c_char_p), ("summary", c_char_p), ("references", c_char_p), ("profile_axes", c_char_p),
                ("n_variables", c_int32), ("n_results", c_int32), ("n_profiles", c_int32)]


class VariableInfo(ctypes.Structure):
    """adfric_variable_info"""

    _fields_ = [("group", c_char_p), ("name", c_char_p), ("unit", c_char_p), ("meaning", c_char_p), ("allowed", c_char_p),
                ("choices", c_char_p), ("default_text", c_char_p), ("columns", c_char_p), ("column_units", c_char_p),
                ("default_value", c_double), ("lower", c_double), ("upper", c_double), ("kind", c_int32),
                ("lower_is_open", c_int32), ("upper_is_open", c_int32), ("largest_rank", c_int32), ("is_list", c_int32)]


class ResultInfo(ctypes.Structure):
    """adfric_result_info"""

    _fields_ = [("name", c_char_p), ("unit", c_char_p), ("long_name", c_char_p), ("flag_meanings", c_char_p),
                ("first_flag", c_int32)]


class Array(ctypes.Structure):
    """adfric_array"""

    _fields_ = [("name", c_char_p), ("unit", c_char_p), ("long_name", c_char_p), ("flag_meanings", c_char_p),
                ("dimensions", POINTER(c_char_p)), ("shape", POINTER(c_int64)), ("strides", POINTER(c_int64)),
                ("values", c_void_p), ("states", c_void_p), ("rank", c_int32), ("first_flag", c_int32), ("role", c_int32)]


class Table(ctypes.Structure):
    """adfric_table"""

    _fields_ = [("name", c_char_p), ("columns", POINTER(c_char_p)), ("units", POINTER(c_char_p)), ("values", c_void_p), ("n", c_int64),
                ("n_columns", c_int32)]


class AttributeInfo(ctypes.Structure):
    """adfric_attribute_info"""

    _fields_ = [("name", c_char_p), ("text", c_char_p), ("number", c_double)]


# Arguments of the functions that give back a status.
CASE = RESULTS = c_int64
ARGUMENTS = {
    "adfric_model_count": (POINTER(c_int32),),
    "adfric_model": (c_int32, POINTER(ModelInfo)),
    "adfric_variable": (c_char_p, c_int32, POINTER(VariableInfo)),
    "adfric_result": (c_char_p, c_int32, POINTER(ResultInfo)),
    "adfric_profile": (c_char_p, c_int32, POINTER(ResultInfo)),
    "adfric_open": (c_char_p, POINTER(CASE)),
    "adfric_read": (c_char_p, POINTER(CASE)),
    "adfric_read_text": (c_char_p, POINTER(CASE)),
    "adfric_open_scene": (c_char_p, c_int32, POINTER(c_char_p), POINTER(CASE)),
    "adfric_read_fit": (c_char_p, c_int32, POINTER(Table), POINTER(CASE)),
    "adfric_close_case": (CASE,),
    "adfric_set_real": (CASE, c_char_p, c_double),
    "adfric_set_integer": (CASE, c_char_p, c_int64),
    "adfric_set_logical": (CASE, c_char_p, c_int),
    "adfric_set_word": (CASE, c_char_p, c_char_p),
    "adfric_set_array": (CASE, c_char_p, c_int32, POINTER(c_int64), c_void_p),
    "adfric_unset": (CASE, c_char_p),
    "adfric_sweep": (CASE, c_char_p, c_int64, c_void_p),
    "adfric_sweep_together": (CASE, c_int32, POINTER(c_char_p), c_int64, c_void_p),
    "adfric_model_of": (CASE, POINTER(c_char_p)),
    "adfric_scene_of": (CASE, POINTER(c_char_p)),
    "adfric_variable_of": (CASE, c_char_p, POINTER(VariableInfo)),
    "adfric_describe": (CASE, c_char_p, POINTER(ResultInfo)),
    "adfric_point_count": (CASE, POINTER(c_int64)),
    "adfric_check": (CASE,),
    "adfric_solve": (CASE, c_int32, Progress, c_void_p, POINTER(RESULTS)),
    "adfric_solve_point": (CASE, c_int32, POINTER(c_char_p), POINTER(c_double)),
    "adfric_array_count": (RESULTS, POINTER(c_int32)),
    "adfric_array_at": (RESULTS, c_int32, POINTER(Array)),
    "adfric_attribute_count": (RESULTS, POINTER(c_int32)),
    "adfric_attribute": (RESULTS, c_int32, POINTER(AttributeInfo)),
    "adfric_close_results": (RESULTS,),
    "adfric_sphere_scales": (c_int64,) + 7*(c_void_p,),
    "adfric_sphere_load": (c_int64,) + 7*(c_void_p,),
    "adfric_sphere_approach": (c_int64,) + 7*(c_void_p,),
    "adfric_sphere_radius": (c_int64,) + 6*(c_void_p,),
    "adfric_sphere_pull_off": (c_int64,) + 6*(c_void_p,),
    "adfric_strip_load": (c_int64,) + 12*(c_void_p,),
    "adfric_strip_penetration": (c_int64,) + 12*(c_void_p,),
}


@contextmanager
def short_waits():
    """Let an OpenMP that is loaded meanwhile sleep soon where it waits, if the environment says nothing of waiting."""
    added = {} if any(name in os.environ for name in ("OMP_WAIT_POLICY", *LOOKS_BEFORE_SLEEP)) else LOOKS_BEFORE_SLEEP
    os.environ.update(added)
    try:
        yield
    finally:
        for name in added:
            del os.environ[name]


def load_library():
    """The shared library of this package, or the one that ADFRIC_LIBRARY names."""
    path = os.environ.get("ADFRIC_LIBRARY") or Path(__file__).parent/"lib"/"libadfric.so"
    try:
        with short_waits():
            library = ctypes.CDLL(str(path))
    except OSError as problem:
        raise ImportError(f"adfric: cannot load the library: {problem}") from None
    for name, arguments in ARGUMENTS.items():
        function = getattr(library, name)
        function.argtypes = arguments
        function.restype = c_int
        function.errcheck = check_status
    for name in ("adfric_version", "adfric_message"):
        getattr(library, name).argtypes = ()
        getattr(library, name).restype = c_char_p
    return library


def check_status(status, function, arguments):
    """Raise what the library says of a call that has failed."""
    if status != 0:
        raise ERRORS.get(status, FailedError)(library.adfric_message().decode("utf-8", "replace"))
    return status


def text_for(text, what):
    """A text for the library, where a 0 is its end."""
    if not isinstance(text, str):
        raise InputError(f"{what}: given {text!r}, allowed: a text")
    if "\0" in text:
        raise InputError(f"{what}: given {text!r}, allowed: a text without characters that are 0")
    return text.encode("utf-8", "surrogateescape")


def text_of(text):
    """A text of the library."""
    return text.decode("utf-8", "replace") if text else ""


def words_of(text):
    """The words of a text of the library."""
    return tuple(text_of(text).split())


library = load_library()
