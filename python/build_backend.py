"""scikit-build-core, with what it does not know of this project: the C sources lie beside this folder in the repository and
inside it in an sdist; a package without its widget's script is not built."""

import os
import shutil
import sys
from pathlib import Path

from scikit_build_core import build as _inner
from scikit_build_core.build import *  # noqa: F403 - the hooks that are the same

_HERE = Path(__file__).parent
_SCRIPTS = ("hexlens.anywidget.js", "hexlens.mesh-worker.js")
# Sources by their place in an sdist; in the repository they lie beside this folder.
_BESIDE = {
    "wasm/Makefile": "../wasm/Makefile",
    "wasm/include": "../wasm/include",
    "wasm/src": "../wasm/src",
    "certificates/check_certificates.py": "../tests/certificates/check_certificates.py",
}
_COMPILERS = ("cc", "gcc", "clang", "cl", "clang-cl")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    _require_scripts()
    _require_compiler()
    return _inner.build_wheel(wheel_directory, config_settings, metadata_directory)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    _require_scripts()
    _require_compiler()
    return _inner.build_editable(wheel_directory, config_settings, metadata_directory)


def build_sdist(sdist_directory, config_settings=None):
    _require_scripts()
    copied = [_copy(place, source) for place, source in _BESIDE.items()]
    try:
        return _inner.build_sdist(sdist_directory, config_settings)
    finally:
        for folder in {place.split("/")[0] for place, is_copied in zip(_BESIDE, copied, strict=True) if is_copied}:
            shutil.rmtree(_HERE / folder)


def _copy(place, source):
    """True if it was copied; an sdist has it already."""
    if not (_HERE / source).exists():
        return False
    target = _HERE / place
    target.parent.mkdir(parents=True, exist_ok=True)
    if (_HERE / source).is_dir():
        shutil.copytree(_HERE / source, target, dirs_exist_ok=True)
    else:
        shutil.copyfile(_HERE / source, target)
    return True


def _require_scripts():
    missing = [name for name in _SCRIPTS if not (_HERE / "hexlens" / name).exists()]
    if missing:
        sys.exit(
            f"The widget's script is missing, python/hexlens/{missing[0]}: "
            "make it with `npm run build` in the repository's folder, then repeat."
        )


def _require_compiler():
    named = os.environ.get("CC", "").split()
    if not any(shutil.which(name) for name in named[:1] or _COMPILERS):
        what = f"CC names {named[0]}, which is not there" if named else "none is on PATH"
        sys.exit(
            f"Hexlens is compiled when it is installed from source, and needs a C compiler; {what}. "
            "Install one (Debian: apt-get install gcc libc6-dev; macOS: xcode-select --install), then repeat."
        )
