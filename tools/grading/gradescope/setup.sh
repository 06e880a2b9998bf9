#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Gradescope runs this once, as root, while it builds the image of an autograder. The zip that was
# uploaded lies in /autograder/source; see docs/grading.md for what belongs into it.
# CRADLE_PREFIX stands in front of /autograder where the layout is only tried.
set -euo pipefail
source=${CRADLE_PREFIX:-}/autograder/source

# The program comes with the zip, built for this distribution, or is built here from its sources.
if [ -x "$source/cradle-cli" ]; then
    "$source/cradle-cli" --version
    exit 0
fi
if [ ! -d "$source/cradle" ]; then
    echo "Neither cradle-cli nor the folder cradle with its sources is in the zip." >&2
    exit 1
fi
cd "$source/cradle"
. tools/packages.sh
need_packages "${build_packages[@]}"
cmake --preset release -DBUILD_TESTING=OFF
cmake --build --preset release --target cradle-cli
ln -sf "$PWD/build/release/bin/cradle-cli" "$source/cradle-cli"
