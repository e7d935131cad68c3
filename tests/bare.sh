#!/usr/bin/env bash
# Runs commands in a minimal Debian, on a clone of this checkout: nothing else of this machine is there.
# usage: tests/bare.sh COMMAND...    each COMMAND is a line for sh, run in the clone, one after the other
# variable: KEYBLOCK_BARE_FILES   files, separated by blanks, that lie in the folder `files` beside the clone
#           KEYBLOCK_BARE_CACHE   folder of a ccache of this machine: the system gets ccache and compiles with it
# exit code: 0 all succeeded; 1 one failed; 77 no such system can be made here (the last line says why)
# The system is made once, in build-bare/base, by debootstrap from the mirror of this machine; each run begins with a
# copy of it, build-bare/root. All mounts belong to a namespace of their own, which ends with the script.
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
export PATH="$PATH:/usr/sbin:/sbin" LC_ALL=C
checkout=$(cd "$(dirname "$0")/.." && pwd)
bare=$checkout/build-bare
root=$bare/root
# Parent folder of the clone inside; `shared` lies beside the clone, as it does outside.
home=/home/keyblock

cannot() {
  echo "bare: no minimal Debian can be made here: $*"
  exit 77
}

[ $# -gt 0 ] || { sed -n 's/^# usage: //p' "$0"; exit 2; }
[ "$(id -u)" = 0 ] || cannot "it needs root"
if [ -z "${KEYBLOCK_BARE_INSIDE:-}" ]; then
  unshare --mount true 2>/dev/null || cannot "mounts are not allowed"
  KEYBLOCK_BARE_INSIDE=1 exec unshare --mount bash "$0" "$@"
fi

# Lines "URI suite components" of the package sources of this machine, those of its own release alone.
sources_of_release() {
  apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Identifier: Packages' 2>/dev/null |
    awk -v release="$1" '$2 == release || index($2, release "-") == 1' | sort -u
}

make_base() {
  command -v debootstrap >/dev/null || apt-get -qq install -y debootstrap >/dev/null 2>&1 ||
    { apt-get -qq update && apt-get -qq install -y debootstrap; } >/dev/null 2>&1 ||
    cannot "debootstrap cannot be installed"
  local release sources mirror extra=()
  release=$(. /etc/os-release && [ "$ID" = debian ] && echo "${VERSION_CODENAME:-}")
  sources=$(sources_of_release "${release:=bookworm}")
  [ -n "$sources" ] || sources="http://deb.debian.org/debian $release main"
  mirror=$(awk -v release="$release" '$2 == release { print $1; exit }' <<<"$sources")
  case $mirror in https:*) extra=(--include=ca-certificates) ;; esac
  echo "bare: debootstrap $release from $mirror"
  rm -rf --one-file-system "$bare/base.part"
  debootstrap --variant=minbase "${extra[@]}" "$release" "$bare/base.part" "$mirror" >"$bare/debootstrap.log" 2>&1 ||
    cannot "debootstrap failed: $(tail -n 1 "$bare/debootstrap.log")"
  sed 's/^/deb /' <<<"$sources" >"$bare/base.part/etc/apt/sources.list"
  # The way to the mirror: proxies and what is asked of dates.
  apt-config dump | grep -E '^Acquire::(http|https|Check-Date|Check-Valid-Until|Retries)' \
    >"$bare/base.part/etc/apt/apt.conf.d/90-mirror" || true
  mv "$bare/base.part" "$bare/base"
}

# With the variables of a new login, those that name a proxy, and those by which OpenBLAS knows the processor.
within() {
  local kept=()
  for name in http_proxy https_proxy no_proxy OPENBLAS_CORETYPE OPENBLAS_L2_SIZE; do [ -z "${!name:-}" ] || kept+=("$name=${!name}"); done
  chroot "$root" /usr/bin/env -i HOME=/root TERM="${TERM:-dumb}" "${kept[@]}" \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin /bin/sh -c "cd $home/main && $1"
}

make_root() {
  rm -rf --one-file-system "$root"
  cp -a --reflink=auto "$bare/base" "$root" || exit 1
  mkdir -p "$root$home"
  cat /etc/resolv.conf >"$root/etc/resolv.conf"
  cat /etc/hosts >"$root/etc/hosts"
  local certificates=/etc/ssl/certs/ca-certificates.crt  # of an https mirror
  [ ! -e "$root$certificates" ] || cat $certificates >"$root$certificates"
  git clone --quiet --no-hardlinks "$checkout" "$root$home/main" || exit 1
  mkdir -p "$root$home/files"
  for file in ${KEYBLOCK_BARE_FILES:-}; do cp "$file" "$root$home/files/" || exit 1; done
  for folder in proc dev sys; do
    mount --rbind "/$folder" "$root/$folder" || cannot "/$folder cannot be mounted"
  done
  [ -d "$checkout/../shared" ] || return 0
  mkdir -p "$root$home/shared"
  { mount --bind "$checkout/../shared" "$root$home/shared" && mount -o remount,bind,ro "$root$home/shared"; } ||
    cannot "../shared cannot be mounted"
}

# A cache saves the hour of compiling; what the system lacks shows all the same.
use_cache() {
  [ -n "${KEYBLOCK_BARE_CACHE:-}" ] || return 0
  mkdir -p "$root/root/.cache/ccache" "$root/root/.config/ccache"
  mount --bind "$KEYBLOCK_BARE_CACHE" "$root/root/.cache/ccache" || cannot "$KEYBLOCK_BARE_CACHE cannot be mounted"
  printf '%s\n' "base_dir = $home" "hash_dir = false" \
    "sloppiness = pch_defines,time_macros,include_file_ctime,include_file_mtime" >"$root/root/.config/ccache/ccache.conf"
  within "apt-get -qq install -y ccache" >"$bare/ccache.log" 2>&1 || cannot "ccache cannot be installed"
}

mkdir -p "$bare" || cannot "no folder $bare"
exec 9>"$bare/lock"
flock -n 9 || cannot "another is at work in $bare"
[ -d "$bare/base" ] || make_base
make_root
within "apt-get -qq update -o APT::Update::Error-Mode=any" >"$bare/update.log" 2>&1 ||
  cannot "its mirror is out of reach: $(tail -n 1 "$bare/update.log")"
use_cache
within "rm -rf /var/lib/apt/lists"
[ -z "$(git -C "$checkout" status --porcelain)" ] || echo "bare: changes that are not committed are not in the clone"

failed=0
lines=()
for command in "$@"; do
  began=$SECONDS
  code=0
  within "$command" </dev/null || code=$?
  [ $code = 0 ] || failed=1
  lines+=("bare Debian $(cat "$root/etc/debian_version"): exit code $code after $((SECONDS - began)) s: $command")
done
printf '%s\n' "${lines[@]}"
exit $failed
