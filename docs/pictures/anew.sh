#!/usr/bin/env bash
# Makes all pictures of docs/ anew, and tells the processor seconds of those whose page states them:
#
#     docs/pictures/anew.sh [BINARY [FOLDER]]
#
# BINARY is target/release/scn if it is not said, FOLDER this one.
set -euo pipefail
cd "$(dirname "$0")/../.."
scn=${1:-target/release/scn}
to=${2:-docs/pictures}
scenes=scenes
aside=$(mktemp -d)
trap 'rm -rf "$aside"' EXIT

render() {
    "$scn" render "$@" > /dev/null
}

# By bash's own clock: `time` counts what all threads took.
timed() {
    local TIMEFORMAT="%U s: $*"
    time render "$@"
}

draw() {
    local name=$1 over=$2
    shift 2
    "$scn" paths $scenes/w05_path_tracing.scn "$@" --scale 0.5 --over "$to/w05/$over.png" \
        -o "$to/w05/$name.png" > /dev/null
}

days=(--only day_7 --only day_9 --only day_11 --only day_13 --only day_15 --only day_17)

w=$scenes/w01_first_pictures.scn
for figure in 02 04 05 06; do timed $w -o "$aside" --only fig$figure; done
timed $w -o "$to/w01"
render $w -o "$to/w01" --crop 170,80,298,208 \
    --only rays_1 --only rays_4 --only rays_9 --only rays_16

w=$scenes/w02_sky_and_sun.scn
timed $w -o "$to/w02" --only fig07
render $w -o "$to/w02" --only fig07_boards
render $w -o "$to/w02" --scale 0.5 "${days[@]}" --only noon_disc

w=$scenes/w03_mirror_glass_metal.scn
for figure in 11 12 13 14; do timed $w -o "$to/w03" --only fig$figure; done
render $w -o "$to/w03" --scale 0.5 --only fig12_true --only elephant_depth_1 \
    --only elephant_depth_2 --only elephant_depth_10 --only elephant_roulette

w=$scenes/w04_soft_shadows.scn
for figure in 15 16 20 21; do timed $w -o "$to/w04" --only fig$figure; done
render $w -o "$to/w04" --scale 0.5 "${days[@]}"

w=$scenes/w05_path_tracing.scn
timed $w -o "$to/w05" --scale 0.5
chosen='integrator.paths="L D S_r D E"'
draw paths_glass fig26_spheres fig26_spheres_straight --pixel 183,215 --lines 24
draw paths_silver_glass fig26_spheres fig26_spheres_straight --pixel 222,200 \
    --samples 16384 --lines 24
draw paths_silver fig26_spheres fig26_spheres --set "$chosen" --pixel 60,206 \
    --samples 512 --lines 100
draw paths_elephant fig26_glass_and_gold fig26_glass_and_gold_straight --pixel 104,203 \
    --samples 8192 --lines 24
draw paths_bunny fig26_glass_and_gold fig26_glass_and_gold --set "$chosen" --pixel 130,230 \
    --samples 1024 --lines 100

render $scenes/tour/ball.scn -o "$to/tour" --only noon --only necklace
render $scenes/tour/lamp.scn -o "$to/tour" --only independent_4 --only smooth
render $scenes/tour/glass.scn -o "$to/tour"
render $scenes/tour/terrace.scn -o "$to/tour"
render $scenes/tour/colours.scn -o "$to/tour" --only painted
render $scenes/matter.scn -o "$to/matter"
