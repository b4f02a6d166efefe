#!/bin/sh
# Installs what is missing (Debian 12, as root or with sudo), builds the programs and renders mirrors into pictures/.
set -eu
cd "$(dirname "$0")/.."
. cmake/debian.sh

# shellcheck disable=SC2086 # words are meant
install_missing $packages_to_build $packages_with_models
# shellcheck disable=SC2046 # an empty answer is no argument
cmake --preset release -DMIRRORBALL_HEADLESS=ON -DMIRRORBALL_IO=ON -DMIRRORBALL_EXAMPLES=ON $(launcher_option)
cmake --build --preset release --target render

# picture <name> <arguments of render>…: pictures/<name>.png and the timings of its drawing.
picture() {
    name=$1
    shift
    build-release/examples/render/render "$@" -o "pictures/$name.png" --stats "pictures/$name.json" >/dev/null
    echo "$PWD/pictures/$name.png"
    sed -n 's/^ *"\([a-z0-9_]*_ms\|[a-z0-9_]*per_second\)": *\([0-9.e+-]*\),\{0,1\}$/    \1 \2/p' "pictures/$name.json"
}

mkdir -p pictures

# (1) A teapot and a golden sphere as mirrors in the garden, each with a probe of its own.
picture garden builtin:garden --reflector teapot --scale 0.5 --at -0.8,-1.19,0.4 \
    --reflector sphere:1 --at 1.75,-0.98,-0.6 --tint 1,0.82,0.52 \
    --eye 2.2,0.5,7.6 --look 0.25,-0.7,0 --fov 30 --pixels 1280x720 --supersample 3 --frames 9

# (2) A golden bunny as a mirror in the living room of a house.
picture house_bunny /usr/share/assimp/models/IFC/AC14-FZK-Haus.ifc --reflector /usr/share/glmark2/models/bunny.obj \
    --scale 0.7 --at 4.25,0.7,-2.4 --tint 1,0.84,0.55 --eye 1.9,1.4,-1.4 --look 4.25,0.8,-2.4 --fov 45 \
    --light 3,2.2,-3.5 --pixels 1280x720 --supersample 3 --frames 9
