#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the Debian packages of packages.txt that are missing; silent when all are there.
# Usage: install_packages.sh [LIST]   (or --missing [LIST]: only print what is missing)
set -eu

only_print=no
if [ "${1:-}" = --missing ]; then
    only_print=yes
    shift
fi
list=${1:-$(dirname "$0")/packages.txt}
wanted=$(sed -e 's/#.*//' "$list" | tr -s ' \t\n' ' ')

if ! command -v dpkg-query >/dev/null 2>&1; then
    echo "sightline: not a Debian system, nothing installed; the build needs the equivalents of:$wanted" >&2
    exit 0
fi

missing=
for package in $wanted; do
    state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$state" = installed ] || missing="$missing $package"
done
[ "$only_print" = no ] || { echo $missing; exit 0; }
[ -n "$missing" ] || exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null 2>&1 && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
        as_root=sudo
    else
        echo "sightline: packages are missing and neither root nor sudo is at hand; run as root: apt-get install --no-install-recommends$missing" >&2
        exit 1
    fi
fi

apt() { $as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300 "$@" >/dev/null; }
install() { apt install -y --no-install-recommends $missing; }

echo "sightline: installing, which may take minutes:$missing"
# The lists of a bare machine are empty or old: refreshed when a package is unknown, or its version is gone.
known=yes
for package in $missing; do
    apt-cache show "$package" >/dev/null 2>&1 || known=no
done
if [ "$known" = no ]; then
    apt update
    install
else
    install || { apt update && install; }
fi
