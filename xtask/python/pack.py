"""Packs the wheel out of a library that is built: `python pack.py PYPROJECT LIBRARY FOLDER` prints the wheel's path.

`maturin` builds the wheel that is handed out, with a build of its own. This one takes what CI has built for its tests. Name, command
and needs come from the same file, the version from the library; the tests that follow hold it to be right.
"""

from __future__ import annotations

import base64
import hashlib
import importlib.machinery
import importlib.util
import pathlib
import sys
import sysconfig
import tomllib
import zipfile

ENDINGS = (".py", ".pyi", ".typed")


def version_of(library: pathlib.Path) -> str:
    loader = importlib.machinery.ExtensionFileLoader("_antrieb", str(library))
    module = importlib.util.module_from_spec(importlib.machinery.ModuleSpec("_antrieb", loader, origin=str(library)))
    loader.exec_module(module)
    return str(module.VERSION)


def main(pyproject: pathlib.Path, library: pathlib.Path, folder: pathlib.Path) -> None:
    about = tomllib.loads(pyproject.read_text(encoding="utf-8"))
    project, maturin = about["project"], about["tool"]["maturin"]
    version = version_of(library)
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    tag = f"cp311-abi3-{platform}"
    stem = f"{project['name']}-{version}"
    head = [f"Name: {project['name']}", f"Version: {version}", f"Summary: {project['description']}", f"Requires-Python: {project['requires-python']}"]
    for extra, needs in project["optional-dependencies"].items():
        head.append(f"Provides-Extra: {extra}")
        head.extend(f'Requires-Dist: {each} ; extra == "{extra}"' for each in needs)
    scripts = [f"{name}={call}" for name, call in project["scripts"].items()]
    wheel = ["Wheel-Version: 1.0", "Generator: xtask", "Root-Is-Purelib: false", f"Tag: {tag}"]
    source = pyproject.parent / maturin["python-source"]
    native = maturin["module-name"].replace(".", "/") + (".pyd" if sys.platform == "win32" else ".abi3.so")
    files = {native: library.read_bytes()}
    for path in sorted(source.rglob("*")):
        if path.suffix in ENDINGS or path.name == "py.typed":
            files[path.relative_to(source).as_posix()] = path.read_bytes()
    for name, lines in (
        ("METADATA", ["Metadata-Version: 2.4", *head]),
        ("WHEEL", wheel),
        ("entry_points.txt", ["[console_scripts]", *scripts]),
    ):
        files[f"{stem}.dist-info/{name}"] = ("\n".join(lines) + "\n").encode()
    record = f"{stem}.dist-info/RECORD"
    rows = []
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        rows.append(f"{name},sha256={digest},{len(content)}")
    files[record] = ("\n".join([*rows, f"{record},,"]) + "\n").encode()
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{stem}-{tag}.whl"
    # It is installed at once and thrown away: to pack it would take longer.
    with zipfile.ZipFile(path, "w", zipfile.ZIP_STORED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    print(path)


if __name__ == "__main__":
    main(*(pathlib.Path(word) for word in sys.argv[1:4]))
