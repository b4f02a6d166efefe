# For the scripts of this project, to be sourced: what they need from Debian.

# install_missing <package>…: installs what dpkg does not know as installed; asks nothing.
install_missing() {
    missing=
    for package in "$@"; do
        status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null) || status=
        [ "$status" = installed ] || missing="$missing $package"
    done
    [ -n "$missing" ] || return 0

    if ! command -v apt-get >/dev/null; then
        echo "Debian packages are missing and there is no apt-get:$missing" >&2
        return 1
    fi
    echo "Installing$missing"
    as_root=
    if [ "$(id -u)" -ne 0 ]; then
        as_root=sudo
    fi
    # The lists of packages may be absent or too old: then they are fetched, and it is tried once more.
    # shellcheck disable=SC2086 # words are meant
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends $missing || {
        $as_root apt-get update -q
        $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends $missing
    }
}

# What builds the library, its components and the example programs, and what these run on.
packages_to_build='g++ cmake ninja-build ccache pkgconf libglm-dev libepoxy-dev libegl-dev libopenexr-dev libstb-dev
    libassimp-dev libembree-dev libcli11-dev libglfw3-dev libegl1 libgl1-mesa-dri libgles2'

# The models that examples and tests use.
packages_with_models='glmark2-data assimp-testmodels'

# What the tests need beyond these.
packages_to_test='clang clang-format libclang-rt-14-dev libmpfr-dev glslang-tools libglew-dev binutils xvfb xauth
    mesa-vulkan-drivers'

# The launcher of the compiler, where there is one.
launcher_option() {
    if command -v ccache >/dev/null; then
        echo -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
    fi
}
