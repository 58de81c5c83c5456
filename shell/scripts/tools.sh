# Sourced by shell/demo and tests/run: finds the tools that the builds need, and installs what is missing where it can.
# shellcheck shell=bash

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# Vite 7 needs this much.
readonly node_minimum=20.19.0
# The release to fetch where the system's Node.js is older; kept in build/deps, the system's own stays as it is.
readonly node_fallback=22

# Debian's emcc finds its JavaScript packages only with this set.
if [[ -d /usr/share/nodejs ]]; then
  export NODE_PATH=/usr/share/nodejs
fi

say() { printf '%s\n' "$*" >&2; }

version_at_least() { [[ $(printf '%s\n%s\n' "$2" "$1" | sort -V | head -n 1) == "$2" ]]; }

on_debian() { command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; }

is_installed() { [[ $(dpkg-query -W -f '${db:Status-Abbrev}' "$1" 2>/dev/null) == ii* ]]; }

# install_tools build|test: what shell/demo needs, or that and what only the tests need. Ends the script if it cannot.
install_tools() {
  if on_debian; then
    local packages=(cmake ninja-build g++ emscripten libeigen3-dev libglm-dev nlohmann-json3-dev doctest-dev
      ca-certificates xz-utils)
    if [[ $1 == test ]]; then
      packages+=(clang-format clang-tidy librapidcheck-dev libbenchmark-dev libsisl-dev python3-scipy valgrind
        hunspell hunspell-en-gb)
      find_chromium >/dev/null || packages+=(chromium)
    fi
    command -v node >/dev/null || packages+=(nodejs)
    command -v npm >/dev/null || packages+=(npm)

    local missing=() package
    for package in "${packages[@]}"; do
      is_installed "$package" || missing+=("$package")
    done
    if ((${#missing[@]})); then
      install_packages "${missing[@]}"
    fi
  else
    require_commands "$1"
  fi
  use_node
}

install_packages() {
  if ((EUID != 0)); then
    say "Missing packages. Please run: sudo apt-get install --no-install-recommends $*"
    exit 1
  fi
  say "installing: $*"
  export DEBIAN_FRONTEND=noninteractive
  local log
  log=$(mktemp)
  # The package lists may be older than the archive, so they are refreshed first.
  if ! { apt-get -qq update && apt-get -qq -y install --no-install-recommends "$@"; } </dev/null >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    say "apt-get could not install: $*"
    exit 1
  fi
  rm "$log"
}

require_commands() {
  local commands=(cmake ninja c++ emcc node npm) missing=() command
  [[ $1 == test ]] && commands+=(clang-format clang-tidy)
  for command in "${commands[@]}"; do
    command -v "$command" >/dev/null || missing+=("$command")
  done
  if ((${#missing[@]})); then
    say "Missing: ${missing[*]}. This script installs by itself only on Debian as root."
    say "  macOS:  brew install cmake ninja emscripten node; for the tests also llvm"
    say "  others: CMake 3.25, Ninja, a C++20 compiler, Emscripten 3.1.6 or newer, Node.js $node_minimum or newer;"
    say "          for the tests also clang-format and clang-tidy 14 or newer, Chromium, and, if at hand, RapidCheck,"
    say "          Google Benchmark (both are downloaded otherwise), SISL, and Python with SciPy (left out otherwise)"
    exit 1
  fi
  if [[ $1 == test ]] && ! find_chromium >/dev/null; then
    say "Missing: Chromium. The browser tests look for it as chromium, chromium-browser or google-chrome,"
    say "or at the path in CHROMIUM."
    exit 1
  fi
}

find_chromium() {
  if [[ -n ${CHROMIUM:-} ]]; then
    echo "$CHROMIUM"
  else
    command -v chromium || command -v chromium-browser || command -v google-chrome
  fi
}

# Puts a Node.js that is new enough first on the PATH.
use_node() {
  local private="$repository/build/deps/node"
  if version_at_least "$(node --version 2>/dev/null | tr -d v)" "$node_minimum"; then
    return
  fi
  local platform
  case "$(uname -s)-$(uname -m)" in
    Linux-x86_64) platform=linux-x64 ;;
    Linux-aarch64) platform=linux-arm64 ;;
    *)
      say "Node.js $(node --version) is too old: please install $node_minimum or newer."
      exit 1
      ;;
  esac
  local folder="$private/node_modules/node-$platform/bin"
  if [[ ! -x $folder/node ]]; then
    say "Node.js $(node --version) is too old (Vite needs $node_minimum); fetching $node_fallback into build/deps"
    mkdir -p "$private"
    npm install --silent --no-save --no-audit --no-fund --prefix "$private" "node-$platform@$node_fallback" </dev/null
  fi
  export PATH="$folder:$PATH"
  if ! version_at_least "$(node --version | tr -d v)" "$node_minimum"; then
    say "Could not get a Node.js of $node_minimum or newer; please install one."
    exit 1
  fi
}

# install_node_modules FOLDER: npm ci, unless the lock file was installed already.
install_node_modules() {
  if [[ ! $1/node_modules/.package-lock.json -nt $1/package-lock.json ]]; then
    (cd "$1" && npm ci --no-audit --no-fund </dev/null)
    touch "$1/node_modules/.package-lock.json"
  fi
}

# The page's module: build/web/module.
build_module() {
  (cd "$repository" && cmake --preset web && cmake --build --preset web --target knotwork)
}

# The site: shell/dist.
build_site() {
  install_node_modules "$repository/shell"
  (cd "$repository/shell" && npm run build </dev/null)
}
