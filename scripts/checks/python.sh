#!/usr/bin/env bash
# The Python module by pybind11: built, tested by pytest where it was built and again where it was installed.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"

# Debian's interpreter: the one its numpy and pytest belong to.
python=/usr/bin/python3
quietly python-configure cmake --preset python -DADIT_WERROR=ON -DPython3_EXECUTABLE=$python
quietly python-build cmake --build build/python --target adit_python --parallel "$jobs"

# A folder of the tests' own, as a user has it: no build folder beside it.
pytest_with() {
  local status=0 count=0 out
  out=$(ADIT_SOURCE_FOLDER=$PWD PYTHONPATH=$1 $python -B -m pytest -q -p no:cacheprovider tests/python 2>&1) || status=$?
  echo "$out" | tail -n 15
  count=$(sed -n 's/^\([0-9]*\) passed.*/\1/p' <<< "$out" | tail -n 1)
  tally "${count:-0}" $((status == 0 ? 0 : 1)) "$(grep -oE '[0-9]+ skipped' <<< "$out" | grep -oE '[0-9]+' || echo 0)"
  return $status
}
pytest_with "$PWD/build/python/python"
quietly python-install cmake --install build/python --component python --prefix "$PWD/build/python_staged"
pytest_with "$PWD/build/python_staged/lib/python3/dist-packages"

# As pip does by scikit-build-core, which Debian 12 has not: the definitions, targets and components that pyproject.toml
# names, with the wheel's root for a prefix, in a virtual environment of its own.
venv=$PWD/build/python_venv
rm -rf "$venv"
$python -m venv --without-pip --system-site-packages "$venv"
site=$("$venv/bin/python" -c 'import sysconfig; print(sysconfig.get_path("platlib"))')
mapfile -t words < <("$venv/bin/python" - <<'EOF'
import tomllib
whole = tomllib.load(open("pyproject.toml", "rb"))
told = whole["tool"]["scikit-build"]
# The back end refuses a key that it does not know: these are in the schema of its settings from version 0.10 on.
known = {"cmake": {"version", "define"}, "build": {"targets"}, "install": {"components"}, "wheel": {"packages"}}
assert all(part in known and set(keys) <= known[part] for part, keys in told.items()), told
assert any(one.startswith("scikit-build-core>=0.10") for one in whole["build-system"]["requires"]), whole["build-system"]
assert told["install"]["components"] == ["python"] and told["build"]["targets"] == ["adit_python"], told
print(*(f"-D{name}={value}" for name, value in told["cmake"]["define"].items()), sep="\n")
EOF
)
[ ${#words[@]} -gt 0 ]
quietly wheel-configure cmake -S . -B build/python_wheel -G Ninja -DCMAKE_BUILD_TYPE=Release -DSKBUILD=2 \
  -DPython3_EXECUTABLE="$venv/bin/python" -DADIT_WERROR=ON "${words[@]}"
quietly wheel-build cmake --build build/python_wheel --target adit_python --parallel "$jobs"
quietly wheel-install cmake --install build/python_wheel --component python --prefix "$site"
python=$venv/bin/python
pytest_with "$site"
