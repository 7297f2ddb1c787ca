# The rules of scripts/check-includes. Arguments: the table of folders, then the C++ files.

BEGIN {
  # `export` is a word of the language, and so is `import` at the beginning of a line; `lint` is the
  # verb itself.
  named["export", "outputs"] = named["import", "svg_import"] = named["lint", "lint_detail"] = 1
  named["base", "limits"] = named["document", "rules"] = 1
}

function complain(message) {
  print FILENAME ":" FNR ": " message
  broken = 1
}

function finish_file() {
  if (lines > 600) {
    print previous_file ":601: file has " lines " lines; at most 600"
    broken = 1
  }
}

# The path within src/, or within include/sfumato/ for a public header; of other files "".
function inner_path(path) {
  return sub(/^(src|include\/sfumato)\//, "", path) ? path : ""
}

# The first folder of such a path ("formats"), or "".
function folder_of(path, parts) {
  return split(path, parts, "/") > 1 ? parts[1] : ""
}

# The folder of a path within src/ ("formats/css/color.hpp"): a room of its own where it has a
# line in the table ("formats/css"), else the first one.
function room_of(path, parts, count) {
  count = split(path, parts, "/")
  return count > 2 && (parts[1] "/" parts[2]) in is_folder ? parts[1] "/" parts[2] : parts[1]
}

function check_project_include(path, parts, other, other_room) {
  if (is_public && path !~ /^sfumato\//) complain("a public header may not include " path)
  if (folder == "" || path !~ /\//) return
  sub(/^sfumato\//, "", path)
  split(path, parts, "/")
  other = parts[1]
  other_room = room_of(path)
  if (other != folder && !((folder, other) in may_use)) {
    complain(folder " may not include " path)
  }
  if (other == folder && other_room != room && !((room, other_room) in may_use)) {
    complain(room " may not include " path)
  }
  if (path ~ /^base\/native\// && core) complain("the core may not include " path)
}

# A namespace is sfumato, for what the library hands out, or has its folder's name.
function check_namespace(name, parts) {
  if (folder == "" || name == "sfumato") return
  sub(/^sfumato::/, "", name)
  split(name, parts, "::")
  if (parts[1] == folder || room == folder "/" parts[1] || (folder, parts[1]) in named) return
  complain(room " may not open namespace " name)
}

# Comments and string literals are not code.
function code_of(line) {
  gsub(/\\./, "", line)
  gsub(/"[^"]*"/, "\"\"", line)
  gsub(/\/\*[^*]*\*\//, "", line)
  sub(/\/\/.*/, "", line)
  return line
}

FNR == 1 {
  finish_file()
  previous_file = FILENAME
  lines = 0
  is_table = FILENAME ~ /folder-order\.txt$/
  is_public = FILENAME ~ /^include\//
  folder = folder_of(inner_path(FILENAME))
  room = room_of(inner_path(FILENAME))
  is_native = inner_path(FILENAME) ~ /^base\/native\//
  core = folder ~ /^(base|document|curves|picture|mesh|gather|raster|solve)$/ &&
         !is_native
  if (!is_table && folder != "" && !(folder in is_folder)) {
    complain(folder " is not in scripts/folder-order.txt")
  }
}

is_table {
  if ($0 ~ /^#/ || NF == 0) next
  name = $1
  sub(/:$/, "", name)
  is_folder[name] = 1
  for (i = 2; i <= NF; ++i) may_use[name, $i] = 1
  next
}

{
  ++lines
  text = $0
  gsub(/[\200-\277]/, "", text)
  if (length(text) > 100) complain("line has " length(text) " characters; at most 100")
}

/^[ \t]*#[ \t]*include[ \t]*"/ {
  split($0, quoted, "\"")
  check_project_include(quoted[2])
}

# The command's options are the command's: it adds them to what the library says.
folder != "" && folder != "cli" && /"[^"]*(--[a-z]|sfumato (init|render|lint|convert|info|compare) )/ &&
    !/<!--/ {
  complain("the library may not speak of the command")
}

/^[ \t]*(inline )?namespace [a-z_:]+ \{/ {
  name = $0
  sub(/^.*namespace /, "", name)
  sub(/ .*/, "", name)
  check_namespace(name)
}

# Large headers are read by every file of an embedder. What is listed here costs 38,000 lines.
is_public && /^[ \t]*#[ \t]*include[ \t]*</ &&
    !/<(cassert|cstddef|cstdint|optional|span|string|string_view|type_traits|utility|variant|vector)>/ {
  complain("a public header may not include" substr($0, index($0, "include") + 7))
}

core && /^[ \t]*#[ \t]*include[ \t]*<(thread|filesystem|iostream|fstream|regex|future|mutex|shared_mutex|condition_variable|execution)>/ {
  complain("the core may not use" substr($0, index($0, "include") + 7))
}

# base/no_throw.hpp is where what the allocator throws becomes a status.
core && FILENAME != "src/base/no_throw.hpp" {
  code = code_of($0)
  if (code ~ /(^|[^A-Za-z0-9_])(throw|try|catch)([^A-Za-z0-9_]|$)/) {
    complain("the core may not throw or catch")
  }
}

END {
  finish_file()
  exit broken
}
