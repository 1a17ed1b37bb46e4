"""What the library knows by name: techniques, metrics, settings, devices."""
from __future__ import annotations

import itertools
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional

import numpy as np

from ._call import Descriptor, described
from ._cffi import ffi, lib
from ._errors import ArgumentError, text_of


class Setting(NamedTuple):
    """A setting of the renderer: its name, its default as text, and its meaning."""

    name: str
    default: str
    help: str


def _names(function: Callable[[int], Any]) -> List[str]:
    return [text_of(name) for name in itertools.takewhile(bool, map(function, itertools.count()))]


def techniques() -> List[str]:
    """Names of techniques for indirect light."""
    return _names(lib.manylight_technique_name)


def direct_methods() -> List[str]:
    """Names of methods for direct light."""
    return _names(lib.manylight_direct_name)


def qualities() -> List[str]:
    """Names of qualities."""
    return _names(lib.manylight_quality_name)


def metrics() -> List[str]:
    """Names of metrics for `compare`."""
    return _names(lib.manylight_metric_name)


def settings() -> List[Setting]:
    """All settings of the renderer, with their defaults."""
    row, found = Descriptor("setting"), []
    while lib.manylight_setting_at(len(found), row.pointer) == lib.MANYLIGHT_OK:
        found.append(Setting(*(text_of(text) for text in (row.pointer.name, row.pointer.value, row.pointer.help))))
    return found


def devices() -> str:
    """The OpenGL devices of this machine, a line each, then the reasons why other kinds are not there."""
    text = ffi.new("char[]", 1 << 16)
    lib.manylight_list_devices(text, len(text))
    return text_of(text)


def version() -> str:
    """Version of the library."""
    return text_of(lib.manylight_version())


def _identifier(name: str) -> str:
    return name.replace(".", "_").replace("-", "_")


def setting_name(keyword: str, known: List[str]) -> str:
    """The setting that a keyword argument names: `gather_interleave` is gather.interleave, and `near_samples` the one
    setting whose last word is near-samples. Another keyword stays, for the library to refuse."""
    if not keyword.isidentifier():
        return keyword
    for name in known:
        if _identifier(name) == keyword:
            return name
    lasts = {name.rpartition(".")[2] for name in known}
    return next((last for last in lasts if _identifier(last) == keyword), keyword)


def _value(value: Any) -> str:
    if isinstance(value, (bool, np.bool_)):
        return "on" if value else "off"
    return repr(float(value)) if isinstance(value, float) else str(value)


def settings_text(settings_of_names: Optional[Mapping[str, Any]], keywords: Dict[str, Any]) -> Optional[str]:
    """Settings as the library reads them: name=value with spaces between."""
    if not isinstance(settings_of_names, (Mapping, type(None))):
        raise ArgumentError(f"settings: {described(settings_of_names)} is not a dict")
    given = dict(settings_of_names or {})
    if keywords:
        known = [setting.name for setting in settings()]
        given.update({setting_name(keyword, known): value for keyword, value in keywords.items()})
    return " ".join(f"{name}={_value(value)}" for name, value in given.items()) or None
