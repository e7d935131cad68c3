#!/bin/sh
# Runs every reader of fuzz_reader for so many seconds, JOBS of them at a time; findings stay in FOLDER/findings.
# SPDX-License-Identifier: GPL-3.0-or-later
#
#   tests/fuzz/fuzz.sh PROGRAM FOLDER SECONDS JOBS [READER…]
set -eu
program=$1 folder=$2 seconds=$3 jobs=$4
shift 4
corpus=$(dirname "$0")/corpus
hostile=$(dirname "$0")/../malformed/hostile
mkdir -p "$folder/findings"
"$program" seeds "$folder/seeds"
[ $# -gt 0 ] || set -- $("$program" list)

# What one reader has found new stays in FOLDER and is where its next run starts.
export program folder seconds corpus hostile
run='
  reader=$1
  mkdir -p "$folder/$reader"
  if "$program" "$reader" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=4096 -max_len=65536 -use_value_profile=1 \
    -artifact_prefix="$folder/findings/$reader-" "$folder/$reader" "$folder/seeds" "$corpus" "$hostile" >"$folder/$reader.log" 2>&1
  then echo "$reader: $(sed -n "s/^Done \([0-9]* runs in [0-9]* second\).*/\1/p" "$folder/$reader.log")s, nothing found"
  else echo "$reader: FOUND SOMETHING, see $folder/$reader.log"; exit 1
  fi'
printf '%s\n' "$@" | xargs -P "$jobs" -I READER sh -c "$run" fuzz READER
