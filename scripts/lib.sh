# Shared by the scripts of this folder; sourced.

# Prints the C++ and C files of a project folder, relative to it, each ended by NUL: the files that git
# tracks, or all files if the folder is not a working tree.
cpp_files() {
  (
    cd "$1"
    if [[ -e .git ]] && command -v git >/dev/null; then
      git ls-files -z -- '*.hpp' '*.cpp' '*.h' '*.c'
    else
      find . \( -name 'build*' -o -name '.*' -not -name . \) -prune -o \
        -type f \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.c' \) -print0 | sed -z 's|^\./||' | sort -z
    fi | while IFS= read -r -d '' file; do
      if [[ -f $file ]]; then printf '%s\0' "$file"; fi
    done
  )
}

# The folder that `make check` and `make check-all` build in.
checked=build-check

# build_checked OPTION... [--target TARGET...]: configures $checked with these options of CMake, and builds
# it.
build_checked() {
  local options=()
  while [[ $# -gt 0 && $1 != --target ]]; do options+=("$1") && shift; done
  cmake --preset release -B "$checked" -DSFUMATO_TESTS=ON "${options[@]}" --log-level=WARNING >/dev/null &&
    cmake --build "$checked" --parallel "$(nproc)" "$@"
}

# Lines of the Test Anything Protocol, which scripts/count-tests counts.
passed() { echo "ok - $1"; }
failed() { echo "not ok - $1"; }
skipped() { echo "ok - $1 # SKIP $2"; }

# install_npm FOLDER: installs the packages of its package-lock.json if they are not installed.
install_npm() {
  [[ $1/node_modules/.package-lock.json -nt $1/package-lock.json ]] ||
    npm ci --prefix "$1" --no-audit --no-fund
}

# measured NAME COMMAND...: runs the command, and writes the wall and CPU seconds of it and of all its
# processes to $results/times.tsv, which scripts/time-table reads.
measured() {
  local name=$1 status=0 report wall user system cpu
  shift
  report=$(mktemp)
  local TIMEFORMAT='%R %U %S'
  { time "$@" 2>&3; } 3>&2 2>"$report" || status=$?
  read -r wall user system <"$report"
  rm -f "$report"
  cpu=$(awk "BEGIN { printf \"%.1f\", $user + $system }")
  printf '%s\t%s\t%s\n' "$wall" "$cpu" "$name" >>"$results/times.tsv"
  echo "# ${wall%??} s, $cpu s of CPU"
  return "$status"
}

# no_time_left NAME: succeeds if CI's time is over ($SFUMATO_DEADLINE, seconds since 1970); the stage NAME
# is then skipped.
no_time_left() {
  [[ ${EPOCHSECONDS} -ge ${SFUMATO_DEADLINE:-$((EPOCHSECONDS + 1))} ]] || return 1
  skipped "$1" "CI has no time left for it" | tee -a "$results/stages.tap"
}

# stage NAME COMMAND...: one check that passes or fails as a whole, recorded in $results/stages.tap.
stage() {
  local name=$1 verdict=failed
  shift
  echo "== $name"
  if no_time_left "$name"; then return; fi
  if measured "$name" "$@"; then verdict=passed; fi
  "$verdict" "$name" | tee -a "$results/stages.tap"
}

# suite NAME COMMAND...: runs a command that prints its tests as TAP, and stores them in $results/NAME.tap.
suite() {
  local name=$1
  shift
  echo "== $name"
  if no_time_left "$name"; then return; fi
  measured "$name" "$@" | tee "$results/$name.tap"
}

# unit_tests BUILD [OPTION...]: runs the tests of a build folder in parallel on all cores, with options of
# ctest. The report, $results/ctest.xml, or ctest-$part.xml if part is set, holds the results and times; the exit
# code says whether the report exists.
unit_tests() {
  local name=$results/ctest${part:+-$part}
  ctest --test-dir "$1" "${@:2}" --parallel "$(nproc)" --output-on-failure \
    --output-junit "$PWD/$name.xml" --no-tests=error </dev/null >"$name.log" 2>&1
  grep -vE '^ *(Start +[0-9]+:|[0-9]+/[0-9]+ Test +#[0-9]+:.* Passed +)' "$name.log"
  [[ -s $name.xml ]]
}

# start_results: empties the folder $results, except for built files.
start_results() {
  mkdir -p "$results"
  rm -f "$results"/summary "$results"/times.tsv "$results"/*.tap "$results"/ctest*.xml
}

# end_results: prints the time of each stage, then the failed tests and the count of all tests, which it also
# writes to $results/summary. Exit 1 if a test failed.
end_results() {
  scripts/time-table "$results"
  scripts/count-tests "$results" | tee "$results/summary"
  return "${PIPESTATUS[0]}"
}
