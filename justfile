# The commands a person types. `just` lists them.

# list the commands
default:
    @just --list

# run a case: just run cases/pin_on_disc, just run cases/hertz -o results/ball
run case="cases/pin_on_disc" *options:
    cargo run --release -- run {{case}} {{options}}

# run every test, those that take longest too
test:
    cargo test
    cargo test --tests -- --ignored $(cat .ci/long)

# kill, interrupt and starve runs, a hundred of them killed
faults:
    cargo test -p archard-cli --test faults -- --include-ignored

# two thousand random cases, the errors stated by two hundred, ten minutes of each kind of damaged file, a hundred runs killed; about an hour
soak:
    cargo test -p archard-case --test soak -- --ignored --nocapture
    cargo test -p archard-case --test honesty -- --ignored --nocapture
    cargo test -p archard-case --test damaged -- --ignored --nocapture --test-threads 1
    cargo test -p archard-cli --lib -- damaged_folders --ignored --nocapture
    cargo test -p archard-cli --test faults -- --ignored

# count lines, constants, questions to the motion, types, tuples and circular imports into crates/archard/tests/house.csv
house:
    ARCHARD_HOUSE=1 cargo test -p archard --test house -- --nocapture

# hold the last rows of all cases against an earlier commit, to the bit, on one thread, on two and resumed: just same main~1 [CASE...]
same earlier *cases:
    #!/usr/bin/env bash
    set -euo pipefail
    rm -rf target/earlier && mkdir -p target/earlier
    git archive {{earlier}} | tar -x -C target/earlier
    CARGO_TARGET_DIR=target/of-earlier cargo build --release --manifest-path target/earlier/Cargo.toml -p archard-cli
    cargo build --release -p archard-cli
    python3 crates/archard-cli/benches/same.py target/of-earlier/release/archard target/release/archard cases {{cases}}

# check formatting and lints
lint:
    cargo fmt --all --check
    cargo clippy --workspace --all-targets --all-features -- -D warnings

# draw the picture of a report in the book, with Chromium
report-picture:
    cargo run --release -- run cases/pin_on_disc -o target/report --force --quiet --report
    chromium --headless --no-sandbox --disable-gpu --enable-unsafe-swiftshader --hide-scrollbars --window-size=1280,1500 \
        --virtual-time-budget=60000 --screenshot=book/src/report.png file://$PWD/target/report/report.html

# build the documentation of the library, warnings as errors
docs:
    RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps

# install the Python package into target/python and test it
python:
    python3 -m venv target/python
    target/python/bin/pip install "./python[test]"
    target/python/bin/pytest python

# build the wheel of the Python package and the command, one for all versions of Python, and for any Linux since 2018
wheel:
    #!/usr/bin/env bash
    set -euo pipefail
    python3 -m venv target/maturin-tools
    target/maturin-tools/bin/pip install -q "maturin[zig]>=1.16,<2.0"
    portable=()
    [ "$(uname -s)" != Linux ] || portable=(--compatibility manylinux_2_28 --zig)
    PATH="$PWD/target/maturin-tools/bin:$PATH" maturin build --profile dist --locked --features pdf \
        --manifest-path python/Cargo.toml --out target/wheels "${portable[@]}"

# build the site of the book into target/site and check it, after `just python`; just site --notebooks runs the notebooks first
site *options:
    book/site/build {{options}}

# run the published cases and write what they give into the book
pages:
    ARCHARD_PAGES=1 cargo test --test cases -- --ignored every_case_gives
    ARCHARD_PAGES=1 cargo test --test cases the_gallery

# run the published cases and draw the picture of each into the book, as book/src/gallery/seen.toml says, after `just python`
gallery:
    #!/usr/bin/env bash
    set -euo pipefail
    for case in cases/*; do
        results=target/gallery/$(basename "$case")
        cargo run --release --quiet -- run "$case" --quiet --force --output "$results"
        # A body by itself has nothing to plot.
        cargo run --release --quiet -- plot "$results" > /dev/null || true
        target/python/bin/python book/src/gallery/draw.py "$results"
    done

# time whole solves in padded round trips, and whole cases against the last release
bench: && bench-cases
    cargo bench -p archard-case

# compare whole cases with an earlier version, from 128 to 1024 elements a side and as published, into target/bench-cases.md: just bench-cases 848cb14
bench-cases earlier="$(git describe --tags --abbrev=0 2>/dev/null || echo 848cb14)":
    #!/usr/bin/env bash
    set -euo pipefail
    rm -rf target/earlier && mkdir -p target/earlier
    git archive {{earlier}} | tar -x -C target/earlier
    CARGO_TARGET_DIR=target/of-earlier cargo build --release --manifest-path target/earlier/Cargo.toml -p archard-cli
    cargo build --release -p archard-cli
    python3 crates/archard-cli/benches/cases.py target/of-earlier/release/archard target/release/archard \
        target/earlier/cases cases | tee target/bench-cases.md

# solve the same problems by Archard and others (ASPHER, Tamaas, ContactMechanics, CalculiX; the bank of CONTACT), into the book
peers:
    python3 benches/peers/peers.py
    python3 benches/peers/bodies.py
    python3 benches/peers/rolling.py

# all that has to pass before a merge
ci:
    .ci/run
