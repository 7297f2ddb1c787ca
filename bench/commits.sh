# Functions of the benchmarks that compare this checkout with another commit. Source it in the project's
# folder.

# Prints the full hash of a commit; exits where there is none.
commit_of() {
  git rev-parse --verify --quiet "$1^{commit}" || {
    echo "${0##*/}: $1 is no commit here" >&2
    exit 2
  }
}

# Builds the command of a commit once, in build/against/, and prints its path.
build_commit() {
  local folder=build/against/$1
  if [[ ! -d $folder/source ]]; then
    mkdir -p "$folder"
    git archive --prefix=source/ "$1" | tar -x -C "$folder"
  fi
  cmake -S "$folder/source" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE='-O3 -DNDEBUG' -DSFUMATO_TESTS=OFF -DSFUMATO_BENCH=OFF \
    -DSFUMATO_WERROR=OFF --log-level=WARNING >/dev/null
  cmake --build "$folder/build" --target sfumato >"$folder/log" || { tail -n 30 "$folder/log" >&2; exit 1; }
  echo "$folder/build/sfumato"
}

# Prints the paths of public scenes, given their names; names each that is missing.
public_scenes() {
  local name
  for name in "$@"; do
    if [[ -r ../shared/scenes/$name.xml ]]; then
      echo "../shared/scenes/$name.xml"
    else
      echo "${0##*/}: no ../shared/scenes/$name.xml" >&2
    fi
  done
}
