# Shared by the scripts of this folder; sourced.

# The files of C++ and C of a project folder, relative to it, each ended by NUL: those that git
# tracks, or all where the folder is no working tree.
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

# Lines of the Test Anything Protocol, which scripts/count-tests counts.
passed() { echo "ok - $1"; }
failed() { echo "not ok - $1"; }
skipped() { echo "ok - $1 # SKIP $2"; }

# install_npm FOLDER: what its package-lock.json names; nothing where it is there.
install_npm() {
  [[ $1/node_modules/.package-lock.json -nt $1/package-lock.json ]] ||
    npm ci --prefix "$1" --no-audit --no-fund
}

# timed COMMAND...: runs it and says how long it took.
timed() {
  local began=$SECONDS status=0
  "$@" || status=$?
  echo "# $((SECONDS - began)) s"
  return "$status"
}

# stage NAME COMMAND...: one check that passes or fails as a whole, noted in the file $stages.
stage() {
  local name=$1 verdict=failed
  shift
  echo "== $name"
  if timed "$@"; then verdict=passed; fi
  "$verdict" "$name" | tee -a "$stages"
}

# unit_tests FOLDER [OPTION...]: runs the tests of a build folder, in parallel on all cores, and names
# the ten slowest; the options are ctest's. The tests themselves are counted from ctest's report
# there; the exit code says whether there is one.
unit_tests() {
  local log=$1/ctest.log
  ctest --test-dir "$1" "${@:2}" --parallel "$(nproc)" --output-on-failure --output-junit ctest.xml \
    --no-tests=error </dev/null >"$log" 2>&1
  grep -vE '^ *(Start +[0-9]+:|[0-9]+/[0-9]+ Test +#[0-9]+:.* Passed +)' "$log"
  sed -nE 's/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: ([^ ]+) .* ([0-9.]+) sec.*/# \2 s \1/p' "$log" |
    sort -k 2nr | head -n 10
  [[ -s $1/ctest.xml ]]
}
