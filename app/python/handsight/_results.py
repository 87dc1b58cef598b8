# SPDX-License-Identifier: Apache-2.0
"""Plain objects from the JSON that the core gives."""

import json

import numpy


class Result(dict):
    """A dict whose keys are attributes too: result.rms_pixel is result["rms_pixel"]."""

    def __getattr__(self, name):
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"there is no {name!r} here; there is: {', '.join(self)}") from None

    def __dir__(self):
        return [*super().__dir__(), *self]


def _is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _plain(value):
    if isinstance(value, dict):
        return Result((name, _plain(inner)) for name, inner in value.items())
    if not isinstance(value, list):
        return value
    items = [_plain(inner) for inner in value]
    if any(map(_is_number, items)) and all(item is None or _is_number(item) for item in items):
        return numpy.array([numpy.nan if item is None else item for item in items], dtype=float)
    shapes = {item.shape if isinstance(item, numpy.ndarray) else None for item in items}
    if len(shapes) == 1 and None not in shapes:
        return numpy.stack(items)
    return items


def result(text):
    """JSON text as dicts with attributes; lists of numbers and of equal arrays as arrays, what is not known in them nan."""
    return _plain(json.loads(text))
