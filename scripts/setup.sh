# shellcheck shell=sh disable=SC2154
# Steps that ./run and ./test share; sourced with `code` set to the folder of the program.
# Everything said here goes to stderr: standard output belongs to the program.

say() { echo "$*" >&2; }

runs_here() { "$1" -c "$2" >/dev/null 2>&1; }

find_python() {
    for python in python3.14 python3.13 python3.12 python3.11 python3; do
        runs_here "$python" 'import sys; sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 14))' || continue
        # Debian and Ubuntu ship Python without ensurepip, and then no pip gets into the environment.
        runs_here "$python" 'import ensurepip, venv' && return 0
    done
    return 1
}

create_environment() {
    find_python || { need_packages python3 python3-venv && find_python; } || {
        say "No Python 3.11 to 3.14 with venv and ensurepip found on PATH."
        exit 1
    }
    say "Setting up $code/.venv with $python (first start only) ..."
    "$python" -m venv --clear "$code/.venv" || exit 1
}

# The copy of a requirements file that was installed is its stamp: any change installs again.
install_requirements() {
    environment=$code/.venv
    [ -x "$environment/bin/python" ] && [ -f "$environment/installed-requirements.txt" ] || create_environment
    for file in "$@"; do
        stamp=$environment/installed-$(echo "$file" | tr / -)
        cmp -s "$code/$file" "$stamp" && continue
        say "Installing $file ..."
        "$environment/bin/python" -m pip install -q --disable-pip-version-check -r "$code/$file" >&2 || exit 1
        cp "$code/$file" "$stamp"
    done
}

# need_packages NAME...: through apt as root on Debian and Ubuntu, otherwise one line to paste.
need_packages() {
    if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
        say "Installing system packages: $* ..."
        export DEBIAN_FRONTEND=noninteractive
        apt-get update -qq >&2 || say "apt-get update failed; going on with the lists that are here."
        apt-get install -y -qq --no-install-recommends "$@" >/dev/null && return 0
    fi
    say "Missing system packages. On Debian or Ubuntu: sudo apt-get install -y $*"
    return 1
}

# What a window needs on Linux; libgl1 and libegl1 bring Mesa's drivers with them.
need_graphics() {
    [ "$(uname)" = Linux ] || return 0
    known=$(PATH=$PATH:/usr/sbin:/sbin ldconfig -p 2>/dev/null) || known=
    packages=
    while read -r library package; do
        case $known in *"$library"*) ;; *) packages="$packages $package" ;; esac
    done <<LIBRARIES
libX11.so.6 libx11-6
libGL.so.1 libgl1
libEGL.so.1 libegl1
libXrandr.so.2 libxrandr2
libXinerama.so.1 libxinerama1
libXcursor.so.1 libxcursor1
libXi.so.6 libxi6
LIBRARIES
    # shellcheck disable=SC2086 # one word a package
    [ -z "$packages" ] || need_packages $packages || say "Going on without; a window may not open."
}

need_commands() {
    packages=
    for pair in "$@"; do
        command -v "${pair%%:*}" >/dev/null || packages="$packages ${pair#*:}"
    done
    # shellcheck disable=SC2086
    [ -z "$packages" ] || need_packages $packages || say "Going on without; the tests of the window are skipped."
}

has_display() { [ "$(uname)" != Linux ] || [ -n "${DISPLAY-}${WAYLAND_DISPLAY-}" ]; }
