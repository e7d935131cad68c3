#!/bin/sh
# Counts the instructions of a step of profile `standard` with and without features that a scene names but does not use, and fails where
# one costs more than 1 %. With a second program (the same sources before a feature came in) that one gives the counts to compare with.
# SPDX-License-Identifier: GPL-3.0-or-later
#
#   tests/validate/instructions_per_step.sh PROGRAM [EARLIER_PROGRAM]
#
# A step's count is the difference of two runs of N and 2N steps under valgrind's callgrind, over N, of what the stepper does alone: start
# and end of the program cancel out, and the tables of results, whose growth costs by steps of two, are left out. So is the inside of malloc, which depends on what else was
# ever allocated: results and passes of the rows are the same to the bit.
set -eu

PROGRAM=$1
EARLIER=${2:-$1}
STEPS=50
MOST=0.01 # share by which an unused feature may change the count

if ! command -v valgrind >/dev/null; then
  echo "skipped: valgrind is not installed"
  exit 0
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# A block 10 m above nothing.
cat >"$folder/fall.geo" <<'GEO'
0.001
4 4 0 0 0 0 0 0
0 10 1 10 1
1 10 1 11 1
1 11 0 11 1
0 11 0 10 1
GEO

# A block on a held wedge of 30 degrees.
cat >"$folder/slide.geo" <<'GEO'
0.001
7 7 0 0 2 0 0 0
0 0 20 -11.547005383792515 1
20 -11.547005383792515 0 -11.547005383792515 1
0 -11.547005383792515 0 0 1
1 -0.5773502691896257 1.5 0.2886751345948129 1
1.5 0.2886751345948129 2.366025403784439 -0.2113248654051871 1
2.366025403784439 -0.2113248654051871 1.866025403784439 -1.0773502691896257 1
1.866025403784439 -1.0773502691896257 1 -0.5773502691896257 1
3 -10 3 -10
12 -10 12 -10
GEO

# analysis BLOCK_MATERIALS JOINT_MATERIALS: the counts first, the materials after them.
analysis() {
  blocks=$(printf '%s\n' "$1" | wc -l)
  joints=$(printf '%s\n' "$2" | wc -l)
  printf '1\n%d\n%d\n%d\n0.01\n0.001\n%s\n%s\n' "$STEPS" "$blocks" "$joints" "$1" "$2"
}
rock='2600 25506 5e9 0.25 0 0 0 0 0 0 0 0 0'
other_rock='3000 29430 1e10 0.2 -1e5 -1e5 0 0 1e3 0 1 2 0.1'
analysis "$rock" '15 0 0' >"$folder/plain.ana"
analysis "$rock" '15 0 0
40 1e6 5e5' >"$folder/bonded_joints.ana"
analysis "$rock
$other_rock" '15 0 0' >"$folder/second_rock.ana"

# instructions PROGRAM GEOMETRY ANALYSIS STEPS SETTINGS…
instructions() {
  program=$1 geometry=$2 analysis=$3 steps=$4
  shift 4
  valgrind --tool=callgrind --callgrind-out-file="$folder/counts" --toggle-collect='keyblock::StandardStepper::advance()' "$program" run \
    "$folder/$geometry.geo" "$folder/$analysis.ana" -o "$folder/out" --force --profile standard --record-every 1000 \
    --set "steps=$steps" "$@" >/dev/null 2>&1
  callgrind_annotate --show-percs=no --threshold=100 "$folder/counts" |
    awk -v least=$((1000 * steps)) '/^ *[0-9,]+ .*:/ && !/malloc\.c:/ { gsub(",", "", $1); sum += $1 }
      END {
        if (sum < least) { print "too few instructions: is the stepper counted?" >"/dev/stderr"; exit 1 }
        printf "%d\n", sum
      }'
}

per_step() {
  program=$1 geometry=$2 analysis=$3
  shift 3
  once=$(instructions "$program" "$geometry" "$analysis" "$STEPS" "$@")
  twice=$(instructions "$program" "$geometry" "$analysis" $((2 * STEPS)) "$@")
  echo $(((twice - once) / STEPS))
}

misses=0
# row SCENE FEATURE ANALYSIS SETTINGS…: against the plain scene of the earlier program, held in $base.
row() {
  scene=$1 feature=$2 analysis=$3
  shift 3
  count=$(per_step "$PROGRAM" "$scene" "$analysis" "$@")
  share=$(awk -v a="$count" -v b="$base" 'BEGIN { printf "%.4f", a / b - 1 }')
  verdict=$(awk -v s="$share" -v m="$MOST" 'BEGIN { print ((s <= m && s >= -m) ? "holds" : "misses") }')
  [ "$verdict" = holds ] || misses=$((misses + 1))
  printf '%-6s %-52s %12d %9s  %s\n' "$scene" "$feature" "$count" "$share" "$verdict"
}

printf '%-6s %-52s %12s %9s\n' scene 'unused feature' 'instr./step' change
for scene in fall slide; do
  base=$(per_step "$EARLIER" "$scene" plain)
  [ "$PROGRAM" = "$EARLIER" ] || printf '%-6s %-52s %12d\n' "$scene" 'none, earlier program' "$base"
  row "$scene" 'none' plain
  row "$scene" 'joint material with cohesion and tension' bonded_joints
  row "$scene" 'second rock with initial stress and velocity' second_rock
  row "$scene" 'body acceleration 0' plain --set body_acceleration.x=0 --set body_acceleration.y=0
  row "$scene" 'factor 1 on joint strength' plain --set joint_strength_factor=1
  row "$scene" 'restitution without an impact' plain --set restitution=0.8
done
[ "$misses" -eq 0 ] || exit 1
