#!/bin/sh
# Installs what is missing (Debian 12, as root or with sudo), builds with both compilers and runs every test twice:
# optimised by g++, and (but for the package's, those on other drivers and the look-ups' accuracy) by clang++ under
# AddressSanitizer and UndefinedBehaviorSanitizer. Fails when anything fails.
set -eu
cd "$(dirname "$0")/.."
. cmake/debian.sh

begun=$(date +%s)
step() {
    title=$1
    shift
    echo "==== $title"
    step_begun=$(date +%s)
    "$@" || {
        echo "==== $title: failed" >&2
        exit 1
    }
    echo "==== $title: $(($(date +%s) - step_begun)) s"
}

check_format() {
    find include src examples tests \( -name '*.h' -o -name '*.cpp' \) -exec clang-format --dry-run -Werror {} +
}

# Every part is asked for by name, so that none is left out for a package that was missing once.
configure() {
    # shellcheck disable=SC2046 # an empty answer is no argument
    cmake --preset "$1" -DMIRRORBALL_WERROR=ON -DMIRRORBALL_HEADLESS=ON -DMIRRORBALL_IO=ON -DMIRRORBALL_EXAMPLES=ON \
        -DMIRRORBALL_TESTS=ON $(launcher_option)
}

count() {
    ctest --preset "$1" --show-only | sed -n 's/^Total Tests: //p'
}

# shellcheck disable=SC2086 # words are meant
step "packages" install_missing $packages_to_build $packages_with_models $packages_to_test
step "clang-format" check_format
for preset in release sanitize; do
    step "$preset: configure" configure "$preset"
    step "$preset: build" cmake --build --preset "$preset"
    step "$preset: tests" ctest --preset "$preset" --parallel "$(nproc)"
done
echo "==== all: $(($(date +%s) - begun)) s"
echo "$(($(count release) + $(count sanitize))) passed, 0 failed"
