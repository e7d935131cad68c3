#!/bin/sh
# Runs three steps of every case of legacy_cases under both profiles, by a program that is built with sanitizers.
# usage: tests/few_steps.sh PROGRAM JOBS
# exit code: 0 no fault; 1 a sanitizer reported one, or a signal ended a run. Reports are in the folder that is named.
# Values are not checked: a run may end with any exit code of its own. A run of more than two minutes is cut off and named.
# SPDX-License-Identifier: GPL-3.0-or-later
export ASAN_OPTIONS=detect_stack_use_after_return=1:exitcode=99 UBSAN_OPTIONS=print_stacktrace=1:exitcode=99

# Called by xargs below, with FEW_STEPS as the folder of logs: PROGRAM CASE.
if [ -n "$FEW_STEPS" ]; then
  for profile in legacy standard; do
    log=$FEW_STEPS/$(echo "$2" | tr / _)_$profile
    timeout 120 "$1" run "$2" --profile $profile --set steps=3 --threads 2 -o "$log.out" >"$log" 2>&1
    code=$?
    rm -rf "$log.out"
    if [ $code = 124 ]; then
      echo "$2, $profile" >>"$FEW_STEPS/cut_off"
    elif [ $code = 99 ] || [ $code -gt 125 ] || grep -q 'Sanitizer\|runtime error' "$log"; then
      echo "$2, $profile: exit code $code" >>"$FEW_STEPS/faults"
      continue
    else
      echo "exit code $code" >>"$FEW_STEPS/codes"
    fi
    rm "$log"
  done
  exit 0
fi

[ -x "$1" ] || { echo "few_steps.sh: expected a program, found none: $1"; exit 1; }
FEW_STEPS=$(mktemp -d)
export FEW_STEPS
find legacy_cases -name expected.csv -printf '%h\n' | sort | xargs -P "$2" -n 1 "$0" "$1"
[ -e "$FEW_STEPS/codes" ] || { echo "few_steps.sh: expected cases in legacy_cases, found none that ran"; exit 1; }
echo "three steps of every case under both profiles:"
sort "$FEW_STEPS/codes" | uniq -c
[ ! -e "$FEW_STEPS/cut_off" ] || { echo "cut off after two minutes:"; sort "$FEW_STEPS/cut_off"; }
if [ -e "$FEW_STEPS/faults" ]; then
  echo "faults, their logs in $FEW_STEPS:"
  sort "$FEW_STEPS/faults"
  exit 1
fi
rm -r "$FEW_STEPS"
