#!/usr/bin/env bash
# Builds the packages and uses them where nothing else of this machine is: the wheel in a fresh virtual environment, the
# Debian packages in a minimal Debian.
# usage: tests/validate/packages.sh [wheel] [deb]    both without an argument; from any folder
# exit code: 0 all succeeded, or were skipped with a message; 1 one failed
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
checkout=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d -t keyblock_packages_XXXXXX)
trap 'rm -rf "$work"' EXIT
failed=0

fail() {
  echo "packages: $*"
  failed=1
}

# A clean clone, pip without network, and a run far from the sources.
check_wheel() {
  local python=/usr/bin/python3
  if ! $python -c "import setuptools, pip, wheel, venv, numpy" 2>/dev/null || ! [ -d /usr/include/pybind11 ]; then
    echo "wheel: skipped: Debian: python3-pip python3-wheel python3-setuptools python3-venv python3-numpy python3-dev pybind11-dev"
    return
  fi
  git clone --quiet "$checkout" "$work/clone" && cd "$work/clone" || return 1
  $python -m pip wheel --quiet --no-index --no-build-isolation --no-deps -w "$work/wheels" . >"$work/wheel.log" 2>&1 ||
    { tail -n 20 "$work/wheel.log"; fail "the wheel was not built"; return; }
  cd "$work" && rm -rf clone
  $python -m venv --system-site-packages "$work/venv" && "$work/venv/bin/pip" install --quiet --no-index --no-deps wheels/*.whl ||
    { fail "the wheel was not installed"; return; }
  env -u PYTHONPATH -u KEYBLOCK_PROGRAM PATH=/usr/bin:/bin "$work/venv/bin/python" - <<'PYTHON' || fail "the package of the wheel does not work"
import os
import keyblock as kb
assert "/venv/" in kb.__file__, kb.__file__
assert "/venv/" in kb.program(), kb.program()
case = kb.read(kb.new("block", "block.json"))
run = kb.Run(case)
assert run.go_on().end == "finished"
table = kb.sweep(case, {"/analysis/joint_materials/0/friction_angle_deg": [10, 20]}, out=["displacement"])
assert [round(v, 3) for v in table["displacement"]] == [1.703, 0.906], table
assert kb.record(case, "out").end == "finished" and os.path.exists("out/run.json")
print("wheel:", kb.__version__, kb._keyblock.commit(), *os.listdir("wheels"))
PYTHON
}

# What a user of the packages has: program, library with headers, man page, completion and the package for Python.
in_the_minimal_system='set -e
apt-get -qq update
DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends ../files/*.deb g++ pkg-config >/dev/null 2>&1
cd "$(mktemp -d)"
keyblock version
keyblock new block
keyblock run block.json -o out >/dev/null
test -s out/run.json
cat >slide.cpp <<CPP
#include <keyblock/keyblock.hpp>
int main() {
  namespace kb = keyblock::api::v1;
  kb::Run run(kb::Plan(kb::Case::read({"block.json"})));
  return run.go_on().end == kb::End::finished ? 0 : 1;
}
CPP
g++ -std=c++20 slide.cpp $(pkg-config --cflags --libs keyblock) -o slide
./slide
dpkg -L keyblock | grep -q "/man1/keyblock.1"
dpkg -L keyblock | grep -q "bash-completion/completions/keyblock"
dpkg -L keyblock | grep -q "/cmake/keyblock/keyblockConfig.cmake"
python3 -c "import keyblock as kb
assert kb.Run(\"block.json\").go_on().end == \"finished\"
table = kb.sweep(\"block.json\", {\"steps\": [10, 20]}, out=[\"displacement\"])
assert list(table[\"verdict\"]) == [\"finished\"] * 2, table
print(\"python3-keyblock\", kb.__version__, kb.program())"'

check_deb() {
  (cd "$checkout" && nice make deb) >"$work/deb.log" 2>&1 || { tail -n 20 "$work/deb.log"; fail "make deb failed"; return; }
  KEYBLOCK_BARE_FILES=$(echo "$checkout"/build-deb/*.deb) "$checkout/tests/bare.sh" "$in_the_minimal_system" >"$work/bare.log" 2>&1
  case $? in
    0) grep -E '^(python3-)?keyblock ' "$work/bare.log" ;;
    77) echo "deb: skipped: $(tail -n 1 "$work/bare.log")" ;;
    *) tail -n 30 "$work/bare.log"; fail "the packages do not work in a minimal Debian" ;;
  esac
}

[ $# -gt 0 ] || set -- wheel deb
for what in "$@"; do check_"$what"; done
exit $failed
