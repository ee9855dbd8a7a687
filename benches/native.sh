#!/bin/sh
# Times of `revolutions` in a build for any x86-64 processor and in one for this machine, run in turn.
set -e
cd "$(dirname "$0")"
target="${CARGO_TARGET_DIR:-target}"
CARGO_TARGET_DIR="$target" cargo build --release --quiet
RUSTFLAGS="-C target-cpu=native" CARGO_TARGET_DIR="$target/native" cargo build --release --quiet
for build in "$target" "$target/native" "$target" "$target/native" "$target" "$target/native"; do
    echo "$build $("$build/release/assur-benches" brief)"
done | awk '
    { for (i = 2; i <= NF; i++) if (!(($1, i) in least) || $i < least[$1, i]) least[$1, i] = $i; order[NR] = $1 }
    END {
        split("hand, sine of std|hand, sine of Assur|hand-written equations, stepper of Assur|emitted|hand, fused, sines of a step packed|periodic::solve", name, "|")
        printf "%-42s %10s %10s %7s\n", "us", "plain", "native", "ratio"
        for (i = 2; i <= 7; i++) {
            plain = least[order[1], i]; native = least[order[2], i]
            printf "%-42s %10.1f %10.1f %7.2f\n", name[i - 1], plain, native, plain / native
        }
        best = 1e9
        for (i = 2; i <= 5; i++) if (least[order[2], i] < best) best = least[order[2], i]
        ratio = least[order[1], 5] / best
        printf "plain build, emitted / best native: %.2f (goal 1.15) %s\n", ratio, ratio <= 1.15 ? "pass" : "FAIL"
    }'
