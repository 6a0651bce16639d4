"""A Jupyter widget around <hex-lens>: moving a vertex updates the array, and the other way round."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import HexlensError
from ._picture import picture
from ._report import analyze

try:
    import anywidget
    import traitlets
except ImportError:
    raise ImportError("The widget needs anywidget, which is not installed: pip install 'hexlens[widget]'.") from None

__all__ = ["HexLens"]

CUBE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]


_MESH_WORKER = Path(__file__).parent / "hexlens.mesh-worker.js"


class Vertices(traitlets.TraitType):  # type: ignore[misc]
    """Eight points as an array of 8 x 3 doubles, which cannot be written into: assign another one instead."""

    info_text = "eight points of three finite numbers"

    def validate(self, obj: Any, value: Any) -> NDArray[np.float64]:
        try:
            array = np.array(value, dtype=np.float64)
        except (TypeError, ValueError):
            self.error(obj, value)
            raise
        if array.size != 24:
            raise traitlets.TraitError(f"A hexahedron has 24 coordinates; {array.size} were given.")
        array = array.reshape(8, 3)
        if not np.isfinite(array).all():
            raise traitlets.TraitError("A coordinate is not a finite number.")
        array.flags.writeable = False
        return array


def _to_bytes(array: NDArray[np.float64], _widget: Any) -> bytes:
    return array.astype("<f8").tobytes()


def _from_bytes(received: bytes, _widget: Any) -> NDArray[np.float64]:
    return np.frombuffer(received, dtype="<f8").reshape(8, 3)


class HexLens(anywidget.AnyWidget):  # type: ignore[misc]
    """One hexahedron, its vertices in VTK_HEXAHEDRON order.

    vertices           array of 8 x 3 doubles; assign to it, observe it
    valid              True, False, or None before the front end has answered
    boundary_minimum   least jacdet on the boundary, of the map from [0,1]^3; None where it is not a double
    views, controls, camera, theme, label, app, readonly: the attributes of <hex-lens>; height in CSS pixels
    """

    _esm = Path(__file__).parent / "hexlens.anywidget.js"

    vertices = Vertices(default_value=CUBE).tag(sync=True, to_json=_to_bytes, from_json=_from_bytes)
    valid = traitlets.Bool(None, allow_none=True).tag(sync=True)
    boundary_minimum = traitlets.Float(None, allow_none=True).tag(sync=True)
    views = traitlets.Unicode("scene verdict").tag(sync=True)
    controls = traitlets.Unicode("").tag(sync=True)
    camera = traitlets.Unicode("").tag(sync=True)
    theme = traitlets.Unicode("").tag(sync=True)
    label = traitlets.Unicode("").tag(sync=True)
    app = traitlets.Unicode("").tag(sync=True)
    readonly = traitlets.Bool(False).tag(sync=True)
    height = traitlets.Int(480).tag(sync=True)

    def __init__(self, vertices: ArrayLike | None = None, **keywords: Any) -> None:
        super().__init__(**({} if vertices is None else {"vertices": vertices}), **keywords)
        self.on_msg(self._answer)

    def _answer(self, _widget: Any, content: Any, _buffers: Any) -> None:
        """Sends the script that reads what is pasted, once it is asked for: a notebook need not keep it."""
        if content == "mesh-worker":
            self.send("mesh-worker", [_MESH_WORKER.read_bytes()])

    def _repr_mimebundle_(self, **keywords: Any) -> Any:
        """The widget, and a picture for where it cannot run: exported notebooks, and those that are read without a kernel."""
        bundle = super()._repr_mimebundle_(**keywords)
        try:
            drawn = {"text/html": picture(analyze(self.vertices))}
        except HexlensError:
            return bundle
        if isinstance(bundle, tuple):
            return ({**bundle[0], **drawn}, *bundle[1:])
        return bundle if bundle is None else {**bundle, **drawn}
