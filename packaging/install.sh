#!/bin/sh
# Installs the program `archard` of a release, after its digest was checked:
#   sh install.sh [FOLDER]        into ~/.local/bin if no folder is given
# ARCHARD_VERSION is the release, ARCHARD_FROM the URL of the folder that holds its archives.
set -eu
version=${ARCHARD_VERSION:-0.1.0}
# A placeholder until the project has an address.
from=${ARCHARD_FROM:-https://example.org/archard/releases/download/v$version}
folder=${1:-$HOME/.local/bin}
fail() { echo "error: $*" >&2; exit 1; }

case $(uname -s) in
    Linux) system=unknown-linux-gnu ;;
    Darwin) system=apple-darwin ;;
    *) fail "no program for $(uname -s) here; take \`pip install archard\`" ;;
esac
case $(uname -m) in
    x86_64 | amd64) processor=x86_64 ;;
    aarch64 | arm64) processor=aarch64 ;;
    *) fail "no program for processors of kind $(uname -m); build it with \`cargo install archard-cli\`" ;;
esac
name=archard-$version-$processor-$system
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for file in "$name.tar.gz" "$name.tar.gz.sha256"; do
    curl -fsSL "$from/$file" -o "$scratch/$file" || fail "cannot fetch $from/$file"
done
cd "$scratch"
if command -v sha256sum > /dev/null; then check="sha256sum -c"; else check="shasum -a 256 -c"; fi
$check "$name.tar.gz.sha256" > /dev/null || fail "the digest of $name.tar.gz is not that of the release"
tar xzf "$name.tar.gz"
mkdir -p "$folder"
# Beside the old one first: a program that runs is not written over.
cp "$name/archard" "$folder/.archard.new" && mv -f "$folder/.archard.new" "$folder/archard"
echo "installed $("$folder/archard" --version) as $folder/archard"
case ":$PATH:" in *":$folder:"*) ;; *) echo "$folder is not in PATH yet" ;; esac
