# Sourced by app/run and tests/run: installs what the build needs where it is missing, then configures.
# On Debian 12, Ubuntu 24.04 and their kin it uses apt, as root or with sudo; elsewhere it says what to install.

packages=(g++ cmake ninja-build qt6-base-dev qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools libgl-dev libboost-dev
    qt6-translations-l10n fontconfig fonts-dejavu-extra) # the last: a serif with true italics, for formulas

say() { printf '%s\n' "$*" >&2; }

as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        return 1
    fi
}

missing_packages() {
    local package
    for package in "${packages[@]}"; do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || echo "$package"
    done
    # A Korean font of any make will do.
    [ -n "$(fc-list :lang=ko 2>/dev/null | head -n 1)" ] || echo fonts-noto-cjk
}

prepare() {
    if ! command -v apt-get >/dev/null; then
        say "ThetaLane needs: a C++20 compiler, CMake 3.25+, Ninja, Qt 6.4+ (Widgets, Test, Linguist tools), Boost headers"
        say "and a font with Korean letters. Install them with this system's package manager if what follows fails."
        return
    fi
    local missing
    mapfile -t missing < <(missing_packages)
    [ "${#missing[@]}" -gt 0 ] || return 0
    say "Installing: ${missing[*]}"
    if ! { as_root apt-get update -q && as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get install -q -y --no-install-recommends "${missing[@]}"; } >&2; then
        say "Could not install them. As root: apt-get install ${missing[*]}"
        say "Going on with what is there."
    fi
}
