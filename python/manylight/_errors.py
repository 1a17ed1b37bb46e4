"""Exceptions: one for each status of the library, with the words of the program."""
from __future__ import annotations

from ._cffi import ffi, lib


class Error(Exception):
    """A call failed. The text names the object, the value and the reason, as the program prints them."""


class ArgumentError(Error, ValueError):
    """A size, a name, or a call that is not allowed here."""


class SceneError(Error):
    """A scene's file, bytes or arrays."""


class FileMissing(SceneError, FileNotFoundError):
    """A scene or a picture whose file does not exist."""


class SettingError(Error, ValueError):
    """A technique, direct method, quality, setting, or its value."""


class DeviceError(Error):
    """No such device, software OpenGL that was not allowed, or a driver without OpenGL 4.5."""


class OutOfMemory(Error, MemoryError):
    """More memory than there is."""


class Cancelled(Error):
    """The work was stopped before its end."""


KINDS = {
    lib.MANYLIGHT_BAD_ARGUMENT: ArgumentError,
    lib.MANYLIGHT_BAD_SCENE: SceneError,
    lib.MANYLIGHT_BAD_SETTING: SettingError,
    lib.MANYLIGHT_NO_DEVICE: DeviceError,
    lib.MANYLIGHT_NO_MEMORY: OutOfMemory,
    lib.MANYLIGHT_CANCELLED: Cancelled,
}


def text_of(pointer) -> str:
    """A C string, or "" for NULL."""
    return ffi.string(pointer).decode("utf-8", "replace") if pointer else ""


def check(status: int) -> None:
    """Raises the exception of a status, on the thread that made the call."""
    if status == lib.MANYLIGHT_OK:
        return
    text, kind = text_of(lib.manylight_error()), KINDS.get(status, Error)
    text = text.replace("(--help-all lists them)", "(manylight.settings() lists them)")
    raise (FileMissing if text.endswith(": No such file or directory") else kind)(text)
