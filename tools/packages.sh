# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by ./run, ./test, tools/package and bench/compare: what they need of Debian 12, and how to get it.

build_packages=(
    g++ cmake ninja-build ccache mold git
    qt6-base-dev qt6-base-dev-tools libqt6opengl6-dev libgl-dev libopengl-dev
    qt6-charts-dev qt6-svg-dev qt6-declarative-dev
    qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools linguist-qt6 qt6-translations-l10n
    libvalijson-dev pkg-config liblua5.4-dev libzip-dev zlib1g-dev libgit2-dev libseccomp-dev libqscintilla2-qt6-dev
    librapidcheck-dev) # the tests are configured with the rest
run_packages=(libgl1-mesa-dri qt6-qpa-plugins fonts-inter fonts-jetbrains-mono bubblewrap)
test_packages=(clang libclang-rt-14-dev clang-format clang-tidy xvfb libxml2-utils perl python3
    poppler-utils qpdf unzip)
package_packages=(appstream debootstrap desktop-file-utils dpkg-dev fonts-dejavu-core lintian patchelf
    qt6-translations-l10n xz-utils) # for tools/package and tests/tools/try-packages
bench_packages=(libbenchmark-dev libbox2d-dev libchipmunk-dev python3) # for the preset bench

# need_packages NAME...: installs those that are missing; present ones cost no time.
need_packages() {
    local missing=() name
    local installed
    # It reports the missing ones as an error of its own, which is what we came to learn.
    installed=" $({ dpkg-query -W -f='${db:Status-Abbrev}${Package} ' "$@" 2>/dev/null || true; } \
        | sed 's/ii *//g') "
    for name in "$@"; do
        [[ $installed == *" $name "* ]] || missing+=("$name")
    done
    # MathJax is bundled with npm; any npm will do.
    command -v npm >/dev/null || missing+=(npm)
    [ ${#missing[@]} -eq 0 ] && return 0

    echo "Installing ${missing[*]}"
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "These packages are missing, and there is no sudo to install them with:" >&2
            echo "    apt-get install ${missing[*]}" >&2
            return 1
        fi
        as_root=(sudo)
    fi
    "${as_root[@]}" apt-get update -qq || true
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}
