"""Is a devcontainer.json one, and is all there that it names? usage: devcontainer.py FILE"""
import json
import pathlib
import re
import sys

path = pathlib.Path(sys.argv[1])
told = json.loads(path.read_text(encoding="utf-8"))
build, faults = told.get("build", {}), []
dockerfile = path.parent / build.get("dockerfile", "")
context = path.parent / build.get("context", ".")
if not dockerfile.is_file():
    faults.append(f"build.dockerfile: there is no {dockerfile}")
elif f"USER {told.get('remoteUser')}" not in dockerfile.read_text(encoding="utf-8"):
    faults.append(f"remoteUser: {dockerfile} makes no user {told.get('remoteUser')}")
if not (context / "CMakeLists.txt").is_file():
    faults.append(f"build.context: {context} is not the project's folder")
if match := re.search(r"cmake --preset (\S+)", told.get("postCreateCommand", "")):
    presets = json.loads((context / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]
    if match[1] not in (preset["name"] for preset in presets):
        faults.append(f"postCreateCommand: there is no preset {match[1]}")
known = {"name", "build", "remoteUser", "customizations", "postCreateCommand"}  # of containers.dev's reference, those in use
faults += [f"{key}: is it a property of devcontainer.json? Look it up, and add it here" for key in told.keys() - known]
for fault in faults:
    print(f"{path}: {fault}")
sys.exit(1 if faults else 0)
