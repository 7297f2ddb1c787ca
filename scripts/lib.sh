# Shared by the scripts of this folder; sourced.

# The C++ files of a project folder, relative to it, each ended by NUL: those that git tracks, or all
# where the folder is no working tree.
cpp_files() {
  (
    cd "$1"
    if [[ -e .git ]] && command -v git >/dev/null; then
      git ls-files -z -- '*.hpp' '*.cpp'
    else
      find . \( -name 'build*' -o -name '.*' -not -name . \) -prune -o \
        -type f \( -name '*.hpp' -o -name '*.cpp' \) -print0 | sed -z 's|^\./||' | sort -z
    fi | while IFS= read -r -d '' file; do
      if [[ -f $file ]]; then printf '%s\0' "$file"; fi
    done
  )
}

# Lines of the Test Anything Protocol, which scripts/check counts.
passed() { echo "ok - $1"; }
failed() { echo "not ok - $1"; }
skipped() { echo "ok - $1 # SKIP $2"; }
