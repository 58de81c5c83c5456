#!/usr/bin/env bash
# Leaves Dear ImGui 1.90.1's sources in DESTINATION, taken from Debian's source package.
#
# Debian 12 packages an older ImGui as a native binary; 1.90.1 is a source package of Debian 13. This script asks the
# machine's own apt configuration where Debian's archive lives and reads Debian 13's source index from there with a
# private apt folder, so nothing of the machine's apt set-up changes and root is not needed.
#
# usage: fetch-imgui.sh DESTINATION
# Ends with 3 where there is no Debian archive to ask; the caller then downloads by commit instead.
set -euo pipefail

readonly version=1.90.1
readonly suite=trixie
readonly tarball_sha256=ecce377df0f90b292f15dcbd83d438bddc162b2388c881132bde18c787572a1c

destination=${1:?usage: fetch-imgui.sh DESTINATION}
if [[ -f $destination/imgui.h ]] && grep -q "IMGUI_VERSION *\"$version\"" "$destination/imgui.h"; then
  exit 0
fi
if ! command -v apt-get >/dev/null || [[ ! -r /etc/os-release ]]; then
  echo "fetch-imgui: no apt here" >&2
  exit 3
fi

mkdir -p "$(dirname "$destination")"
work=$(cd "$(dirname "$destination")" && pwd)/imgui-apt
mkdir -p "$work/lists/partial" "$work/cache/archives/partial" "$work/download"

sha256_matches() { echo "$tarball_sha256  $1" | sha256sum --check --status 2>/dev/null; }

find_tarball() { find "$work/download" -name "imgui_$version*.orig.tar.*" ! -name '*.asc' -print -quit; }

tarball=$(find_tarball)
if [[ -z $tarball ]] || ! sha256_matches "$tarball"; then
  # shellcheck source=/dev/null
  codename=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
  # The archive that serves this machine's own release serves the other suites too.
  # shellcheck disable=SC2016 # apt fills in these names
  archive=$(apt-get indextargets --format '$(RELEASE) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' |
    awk -v codename="$codename" '$1 == codename && $2 == "main" { print $3; exit }')
  if [[ -z $archive ]]; then
    echo "fetch-imgui: apt knows no Debian archive for '$codename main'" >&2
    exit 3
  fi
  keyring=/usr/share/keyrings/debian-archive-keyring.gpg
  options=""
  [[ -r $keyring ]] && options="[signed-by=$keyring] "
  echo "deb-src $options$archive $suite main" >"$work/sources.list"
  apt_private=(apt-get -qq
    -o "Dir::Etc::SourceList=$work/sources.list" -o "Dir::Etc::SourceParts=/dev/null"
    -o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache"
    -o "Acquire::Languages=none" -o "APT::Sandbox::User=$(id -un)" -o "Debug::NoLocking=true")
  "${apt_private[@]}" update
  (cd "$work/download" && "${apt_private[@]}" source --download-only --only-source imgui)
  tarball=$(find_tarball)
  if [[ -z $tarball ]]; then
    echo "fetch-imgui: $suite no longer carries imgui $version" >&2
    exit 3
  fi
fi

if ! sha256_matches "$tarball"; then
  echo "fetch-imgui: $tarball does not have the pinned checksum" >&2
  sha256sum "$tarball" >&2
  exit 1
fi

# Unpacked beside and moved, so that an interrupted run leaves no half-filled folder.
rm -rf "$destination.part"
mkdir -p "$destination.part"
tar -xf "$tarball" --strip-components=1 -C "$destination.part"
rm -rf "$destination"
mv "$destination.part" "$destination"
