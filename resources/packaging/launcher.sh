#!/bin/sh
# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Starts the program of the same name in bin/, from whatever folder this archive was unpacked into. What a
# desktop brings itself (OpenGL, X11, fontconfig) is taken from it, because its drivers belong together;
# what it lacks comes from lib/fallback/.
here=$(dirname "$(readlink -f "$0")")
known=$(PATH=$PATH:/sbin:/usr/sbin ldconfig -p 2>/dev/null)
for folder in "$here"/lib/fallback/*; do
    case $known in
    *"${folder##*/} ("*) ;;
    *) LD_LIBRARY_PATH=${LD_LIBRARY_PATH:+$LD_LIBRARY_PATH:}$folder ;;
    esac
done
[ -z "${LD_LIBRARY_PATH:-}" ] || export LD_LIBRARY_PATH
# The fonts that came along, before those of the machine.
[ -n "${FONTCONFIG_FILE:-}" ] || export FONTCONFIG_FILE="$here/fonts/fonts.conf"
exec "$here/bin/$(basename "$0")" "$@"
