# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by tools/package: make_portable, and what it consists of.

# The newest glibc that a program or library in the archive may ask for: that of Debian 12.
newest_glibc=2.36
# The plugins of Qt that Cradle uses: its display, keyboards, accessibility, pictures and printing.
qt_plugins=(platforms/libqxcb.so platforms/libqoffscreen.so platforms/libqminimal.so
    platforminputcontexts/libcomposeplatforminputcontextplugin.so
    platforminputcontexts/libibusplatforminputcontextplugin.so
    xcbglintegrations/libqxcb-glx-integration.so xcbglintegrations/libqxcb-egl-integration.so
    iconengines/libqsvgicon.so imageformats/libqsvg.so imageformats/libqjpeg.so imageformats/libqgif.so
    printsupport/libcupsprintersupport.so)
# Never bundled: glibc itself, with which the loader must agree.
of_glibc='^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|nsl|util|anl|BrokenLocale)\.so.*)$'
# A desktop has these, and its graphics drivers need its own: bundled for machines that lack them.
of_desktop='^lib(stdc\+\+|gcc_s|GL|EGL|GLX|OpenGL|GLdispatch|X11|X11-xcb|xcb|xcb-(dri2|dri3|glx|present|sync|randr|shm|xfixes|render)|Xau|Xdmcp|Xext|drm|gbm|z|zstd|lzma|expat|fontconfig|freetype|dbus-1|systemd|udev|gcrypt|gpg-error|selinux|cap|uuid|bsd|md|wayland-(client|server|egl|cursor))\.so.*$'

declare -A owners versions

# read_packages: which package each library, plugin and font of this machine belongs to, and its version. Once:
# asking dpkg of every file takes minutes.
read_packages() {
    local name value
    while read -r name value; do
        owners[$name]=$value
    done < <(awk '/\.(so|otf|ttf)/ { package = FILENAME; sub(/.*\//, "", package)
                                    sub(/(:[^.]*)?\.list$/, "", package)
                                    sub(/^\/usr/, ""); print $0, package }' /var/lib/dpkg/info/*.list)
    while read -r name value; do
        versions[$name]=$value
    done < <(dpkg-query -W -f='${Package} ${Version}\n')
}

# package_of FILE: the Debian package that owns it; nothing if none does.
package_of() {
    local real
    real=$(readlink -f "$1")
    echo "${owners[${real#/usr}]:-${owners[${1#/usr}]:-}}"
}

# bundle_library FILE FOLDER: copies it where it belongs, and notes where it comes from.
bundle_library() {
    local name place
    name=$(basename "$1")
    place=lib
    [[ ! $name =~ $of_desktop ]] || place=lib/fallback/$name
    mkdir -p "$2/$place"
    cp -L "$1" "$2/$place/$name"
    bundle_licence "$place/$name" "$1" "$2"
}

# bundle_licence NAME FILE FOLDER: a line of LIBRARIES.txt, and the copyright of the package.
bundle_licence() {
    local package
    package=$(package_of "$2")
    [ -n "$package" ] || {
        echo "tools/package: no package owns $2, so its licence is not known" >&2
        exit 1
    }
    printf '%-52s %-28s %s\n' "$1" "$package" "${versions[$package]}" >>"$3/LIBRARIES.txt"
    cp -L "/usr/share/doc/$package/copyright" "$3/licenses/$package"
}

# check_glibc FOLDER: says the newest symbol version of glibc that is asked for; fails if there are newer ones
# than Debian 12 has.
check_glibc() {
    local newest
    newest=$(find "$1" -type f \( -name '*.so*' -o -path '*/bin/cradle*' \) -exec objdump -T {} + 2>/dev/null \
        | grep -o 'GLIBC_[0-9.]*' | sort -Vu | tail -1)
    echo "newest glibc symbol: $newest"
    [ "$(printf '%s\n' "$newest" "GLIBC_$newest_glibc" | sort -V | tail -1)" = "GLIBC_$newest_glibc" ] || {
        echo "tools/package: Debian 12 has glibc $newest_glibc; build there" >&2
        exit 1
    }
}

# make_portable OUT: the archive in OUT.
make_portable() {
    local version name folder work plugins libraries translations
    version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' build/release/CMakeCache.txt)
    name=cradle-$version-linux-$(uname -m)
    work=$(mktemp -d)
    folder=$work/$name
    read_packages
    mkdir -p "$folder"/{lib/fallback,plugins,translations,fonts,licenses}
    DESTDIR=$work/installed cmake --install build/release --prefix /usr --strip >/dev/null
    mv "$work/installed/usr/bin" "$work/installed/usr/share" "$folder/"
    rm -rf "$folder/share/doc" "$work/installed"

    plugins=$(qtpaths6 --query QT_INSTALL_PLUGINS)
    libraries=$(qtpaths6 --query QT_INSTALL_LIBS)
    translations=$(qtpaths6 --query QT_INSTALL_TRANSLATIONS)
    local plugin file
    for plugin in "${qt_plugins[@]}"; do
        mkdir -p "$folder/plugins/$(dirname "$plugin")"
        cp "$plugins/$plugin" "$folder/plugins/$plugin"
        bundle_licence "plugins/$plugin" "$plugins/$plugin" "$folder"
    done
    # All that programs and plugins link, however far down; and the one that is asked for by name alone.
    while read -r file; do
        [[ $(basename "$file") =~ $of_glibc ]] || bundle_library "$file" "$folder"
    done < <({
        ldd "$folder"/bin/* "${qt_plugins[@]/#/$plugins/}" | sed -n 's/.* => \(\/[^ ]*\) .*/\1/p'
        echo "$libraries/libxcb.so.1"
    } | sort -u -t/ -k4 | awk -F/ '!seen[$NF]++')
    cp "$translations"/qtbase_*.qm "$folder/translations/"
    cp /usr/share/fonts/opentype/inter/Inter-{Regular,Italic,Medium,SemiBold,Bold,BoldItalic}.otf \
        /usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-{Regular,Italic,Bold}.ttf \
        /usr/share/fonts/truetype/dejavu/DejaVuSans{,-Bold}.ttf "$folder/fonts/" # the last for Arabic
    bundle_licence fonts/Inter /usr/share/fonts/opentype/inter/Inter-Regular.otf "$folder"
    bundle_licence fonts/JetBrainsMono /usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf "$folder"
    bundle_licence fonts/DejaVuSans /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf "$folder"
    # Where their texts only point to the common ones.
    cp -L /usr/share/common-licenses/{Apache-2.0,Artistic,BSD,GFDL-1.3,GPL-1,GPL-2,GPL-3,LGPL-2,LGPL-2.1,LGPL-3,MPL-1.1,MPL-2.0} \
        "$folder/licenses/"
    cp resources/packaging/copyright "$folder/licenses/cradle"
    cp LICENSE resources/packaging/README.txt "$folder/"
    cp resources/packaging/fonts.conf "$folder/fonts/"
    printf '[Paths]\nPrefix = ..\nLibraries = lib\nPlugins = plugins\nTranslations = translations\n' \
        >"$folder/bin/qt.conf"
    local program
    for program in cradle cradle-cli; do
        # An RPATH, not a RUNPATH: it also holds for what libraries and plugins load in turn.
        patchelf --force-rpath --set-rpath '$ORIGIN/../lib' "$folder/bin/$program"
        cp resources/packaging/launcher.sh "$folder/$program"
        chmod 755 "$folder/$program"
    done
    check_glibc "$folder"
    tar -C "$work" --sort=name --owner=0 --group=0 --numeric-owner \
        --mtime="@$(git log -1 --format=%ct 2>/dev/null || echo 0)" -c "$name" | xz -4 -T0 >"$1/$name.tar.xz"
    echo "$1/$name.tar.xz: $(stat -c %s "$1/$name.tar.xz") bytes," \
        "unpacked $(du -sb "$folder" | cut -f1) bytes"
    rm -rf "$work"
}
