"""Calls of the library: descriptors, progress, log, and Ctrl-C. cffi releases the GIL during each call."""
from __future__ import annotations

import logging
import operator
import os
import threading
from typing import Any, Callable, Optional

import numpy as np

from ._cffi import ffi, lib
from ._errors import ArgumentError, check, text_of

Progress = Callable[[float, str], Any]

LOG = logging.getLogger("manylight")
LEVELS = {
    lib.MANYLIGHT_DETAIL: logging.DEBUG,
    lib.MANYLIGHT_NOTE: logging.INFO,
    lib.MANYLIGHT_WARNING: logging.WARNING,
}


@ffi.def_extern()
def manylight_python_log(_user, level, message) -> None:
    LOG.log(LEVELS.get(level, logging.WARNING), "%s", text_of(message))


class Work:
    """What a call at work tells Python, and how Python stops it."""

    def __init__(self, progress: Optional[Progress]):
        self.progress = progress
        self.error: Optional[BaseException] = None
        self.handle = ffi.new_handle(self)


_reporting = threading.local()


def is_reporting() -> bool:
    """Whether this thread is in a progress function, where the library refuses calls of the device at work."""
    return getattr(_reporting, "now", False)


@ffi.def_extern(error=1)
def manylight_python_progress(user, done, note) -> int:
    work = ffi.from_handle(user)
    if work.error is None and work.progress is not None:
        _reporting.now = True
        try:
            work.progress(done, text_of(note))
        except BaseException as error:  # It comes out of the call that made the work.
            work.error = error
        finally:
            _reporting.now = False
    return int(work.error is not None)


def encode(text: "str | os.PathLike[str]") -> bytes:
    """Text or a path as a C string."""
    coded = os.fsencode(text)
    if b"\0" in coded:
        raise ArgumentError(f"{os.fspath(text)!r} has a zero byte")
    return coded


def described(value: Any) -> str:
    """A value in an error, short."""
    if isinstance(value, np.ndarray):
        return f"an array of {value.dtype} and shape {value.shape}"
    text = repr(value)
    return text if len(text) <= 60 else f"a {type(value).__name__}"


def real(name: str, value: Any) -> float:
    """A finite or infinite real number of any kind: of Python, of numpy, an array of no dimension."""
    try:
        if isinstance(value, (str, bytes)) or np.ndim(value) != 0:
            raise TypeError
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise ArgumentError(f"{name}: {described(value)} is not a number") from None


def whole(name: str, value: Any) -> int:
    """A whole number or a truth value of any kind. Floats are refused, as they would be cut."""
    try:
        return int(value) if isinstance(value, np.bool_) else operator.index(value)
    except TypeError:
        raise ArgumentError(f"{name}: {described(value)} is not a whole number") from None


def real_array(name: str, values: Any) -> np.ndarray:
    """An array of real numbers of any kind."""
    try:
        array = np.asarray(values)
    except ValueError:
        raise ArgumentError(f"{name}: its rows differ in length") from None
    if array.dtype.kind not in "fiu":
        raise ArgumentError(f"{name}: {described(values)} is not of real numbers")
    return array


def vector(name: str, values: Any, length: int) -> list:
    """So many real numbers."""
    array = real_array(name, values)
    if array.shape != (length,):
        raise ArgumentError(f"{name}: {described(values)} is not {length} numbers")
    return array.astype(float).tolist()


def width_and_height(size: Any) -> dict:
    """Members of a descriptor from (width, height)."""
    try:
        width, height = size
    except (TypeError, ValueError):
        raise ArgumentError(f"size: {described(size)} is not (width, height)") from None
    return {"width": whole("size: width", width), "height": whole("size: height", height)}


# Members whose 0 the library takes for a default.
NOT_DEFAULT_ZERO = ("bounces", "roughness")


class Descriptor:
    """A struct of the library that begins with its size. Members that are None keep their default, and texts and
    arrays live as long as the descriptor."""

    def __init__(self, name: str, **members: Any):
        self.name = name
        self.pointer = ffi.new(f"struct manylight_{name} *")
        self.pointer.size = ffi.sizeof(self.pointer[0])
        self.types = {member: field.type for member, field in ffi.typeof(self.pointer).item.fields}
        self.kept: list = []
        for member, value in members.items():
            self.set(member, value)

    def set(self, member: str, value: Any) -> None:
        """Sets a member: a number, a text, numbers, or a pointer. Refuses what C would cut, drop or take for another
        thing."""
        if value is None:
            return
        if not isinstance(value, ffi.CData):
            value = self.converted(member, self.types[member], value)
        try:
            setattr(self.pointer, member, value)
        except OverflowError:
            raise ArgumentError(f"{member}: {value} is too large") from None

    def converted(self, member: str, kind: Any, value: Any) -> Any:
        """A value of Python as one of C."""
        if kind.kind == "array":
            return vector(member, value, kind.length)
        if kind.kind == "pointer":
            if not isinstance(value, (str, os.PathLike)):
                raise ArgumentError(f"{member}: {described(value)} is not a string")
            return self.keep(ffi.new("char[]", encode(value)))
        number = real(member, value) if kind.cname in ("float", "double") else whole(member, value)
        if member in NOT_DEFAULT_ZERO and number <= 0:
            if number < 0:
                raise ArgumentError(f"{member}: {number} is below 0")
            return lib.MANYLIGHT_ZERO
        return number

    def copied(self, **members: Any) -> "Descriptor":
        """A copy with other members."""
        other = Descriptor(self.name, **members)
        for member in set(self.types) - {"size", *members}:
            setattr(other.pointer, member, getattr(self.pointer, member))
        other.kept += self.kept
        return other

    def keep(self, value: Any) -> Any:
        """Holds what a member points to."""
        self.kept.append(value)
        return value


def call(function: Callable[..., int], *arguments: Any) -> None:
    """Calls a function that returns a status; raises its exception."""
    lib.manylight_log_to(lib.manylight_python_log, ffi.NULL)
    check(function(*arguments))


def made(kind: str, function: Callable[..., int], *arguments: Any) -> Any:
    """The handle that a function makes. Its last reference frees it, so no call of another thread still uses it."""
    out = ffi.new(f"struct manylight_{kind} **")
    call(function, *arguments, out)
    return ffi.gc(out[0], getattr(lib, f"manylight_{kind}_free"))


def run(work: Work, job: Callable[[], Any]) -> Any:
    """Does a job whose call has the progress of work. On the main thread, Ctrl-C stops it."""
    if threading.current_thread() is threading.main_thread():
        job = _beside(work, job)
    try:
        return job()
    finally:
        if work.error is not None:
            raise work.error


def _beside(work: Work, job: Callable[[], Any]) -> Callable[[], Any]:
    """The job on a thread of its own, because Python handles signals only while its main thread is not in a call."""
    result: list = [None, None]
    ended = threading.Event()

    def body() -> None:
        try:
            result[0] = job()
        except BaseException as error:
            result[1] = error
        finally:
            ended.set()

    def wait() -> Any:
        thread = threading.Thread(target=body, name="manylight")
        thread.start()
        # Before Python 3.13 a join that Ctrl-C interrupts takes the thread for ended, though it works on.
        while not ended.is_set():
            try:
                ended.wait()
            except KeyboardInterrupt as interrupt:
                work.error = interrupt
        thread.join()
        if result[1] is not None:
            raise result[1]
        return result[0]

    return wait
