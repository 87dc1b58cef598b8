# SPDX-License-Identifier: Apache-2.0
"""Packs the Python module as a wheel with the standard library alone: the same bytes from the same build.

make_wheel.py --package FOLDER --binary FILE... --version V --licence FILE --out FOLDER; prints the wheel's path.
"""

import argparse
import base64
import hashlib
import pathlib
import sysconfig
import zipfile

MADE = (2000, 1, 1, 0, 0, 0)


def tag():
    python = "cp" + sysconfig.get_config_var("py_version_nodot")
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def metadata(version):
    return (f"Metadata-Version: 2.1\nName: handsight\nVersion: {version}\nLicense: Apache-2.0\n"
            "Summary: Where a robot's hand really is, and why it is not where the model says\n"
            "Requires-Python: >=3.9\nRequires-Dist: numpy\n")


def contents(arguments):
    info = f"handsight-{arguments.version}.dist-info"
    for file in sorted(arguments.package.glob("*.py")):
        yield f"handsight/{file.name}", file.read_bytes()
    for file in arguments.binary:
        yield f"handsight/{file.name}", file.read_bytes()
    yield f"{info}/METADATA", metadata(arguments.version).encode()
    yield f"{info}/WHEEL", ("Wheel-Version: 1.0\nGenerator: handsight\nRoot-Is-Purelib: false\n"
                            f"Tag: {tag()}\n").encode()
    yield f"{info}/LICENSE", arguments.licence.read_bytes()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--package", type=pathlib.Path, required=True)
    parser.add_argument("--binary", type=pathlib.Path, action="append", required=True)
    parser.add_argument("--version", required=True)
    parser.add_argument("--licence", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    for old in arguments.out.glob("handsight-*.whl"):  # of another version: one wheel is what there is to install
        old.unlink()
    wheel = arguments.out / f"handsight-{arguments.version}-{tag()}.whl"
    record = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        def write(name, data):
            archive.writestr(zipfile.ZipInfo(name, MADE), data, zipfile.ZIP_DEFLATED)

        for name, data in contents(arguments):
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(data)}")
            write(name, data)
        name = f"handsight-{arguments.version}.dist-info/RECORD"
        write(name, "\n".join([*record, f"{name},,", ""]).encode())
    print(wheel)


if __name__ == "__main__":
    main()
