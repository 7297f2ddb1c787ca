# The rules of scripts/check-includes. Arguments: the table of folders, then the C++ files.

BEGIN {
  # `export` is a keyword of C++, and so is `import` at the beginning of a line. `lint` is also the name of
  # the function.
  named["export", "outputs"] = named["import", "svg_import"] = named["lint", "lint_detail"] = 1
  named["base", "limits"] = named["document", "rules"] = named["trace", "tracing"] = 1
  # Parts of a name that show that `stop` is a verb.
  stops_work = "_(must|should|shall|can|may|will|is|to|or|please|request|asked|early)_stop_|" \
               "_stop_(now|early|at|if|when|on|status|reason|code|flag|token|source|requested|work)_"
  # Files whose polls of the cancel flag need not end in a status.
  is_flag_itself["base/context.cpp"] = is_flag_itself["base/poll.hpp"] = 1
  is_flag_itself["base/parallel.cpp"] = 1             # tasks of an executor return nothing
  is_flag_itself["base/native/posix.cpp"] = 1         # false and errno, as system calls do
  is_flag_itself["codecs/jpeg/jpeg_decode.cpp"] = 1        # libjpeg reports errors by jumps
  is_flag_itself["codecs/jpeg/jpeg_encode.cpp"] = 1        # libjpeg's callback returns nothing
  is_flag_itself["codecs/webp/webp_encode.cpp"] = 1        # libwebp's callback returns a number
  allow_estimates()
  is_flag_itself["formats/css/tokenizer.hpp"] = 1     # tokens carry no Result: TextPoll has the status
}

function allow_estimates() {
  # Files that may charge memory by an estimate, without measuring it.
  is_estimate["codecs/jpeg/jpeg_decode.cpp"] = 1           # libjpeg allocates the memory itself
  is_estimate["codecs/jpeg/jpeg_encode.cpp"] = 1
  is_estimate["codecs/webp/webp_encode.cpp"] = 1           # libwebp allocates it
  is_estimate["codecs/photo/photo_webp.cpp"] = 1
  is_estimate["codecs/photo/photo_profile_memory.cpp"] = 1  # lcms2 reports the size of each of its blocks
  is_estimate["formats/text/xml_source.cpp"] = 1      # pugixml allocates it
  is_estimate["gpu/target.cpp"] = 1                   # the GPU's driver allocates it
  is_estimate["gpu/table.cpp"] = 1
  is_estimate["codecs/webp/webp_import.cpp"] = 1
  is_estimate["tiles/big_tiff.cpp"] = 1              # memory that libtiff keeps for each tile
  is_estimate["export/glb/glb_file.cpp"] = 1          # nodes of a std::map
  is_estimate["formats/svg/write/svg_write_ids.cpp"] = 1    # nodes of a std::set
  is_estimate["cli/files/document_input.cpp"] = 1           # bounds the part of a pipe that is still to be read
  is_estimate["raster/rasterize.cpp"] = 1             # tasks cannot fail: charged before they begin
  is_estimate["base/charge.hpp"] = is_estimate["base/charge.cpp"] = 1
  is_estimate["base/table_memory.hpp"] = 1
}

function complain(message) {
  print FILENAME ":" FNR ": " message
  broken = 1
}

function finish_file() {
  complain_of_look()
  if (lines > 600) {
    print previous_file ":601: file has " lines " lines; at most 600"
    broken = 1
  }
}

# Returns the path within src/, or within include/sfumato/ for a public header; "" for other files.
function inner_path(path) {
  return sub(/^(src|include\/sfumato)\//, "", path) ? path : ""
}

# Returns the first folder of such a path ("formats"), or "".
function folder_of(path, parts) {
  return split(path, parts, "/") > 1 ? parts[1] : ""
}

# Returns the folder of a path within src/ ("formats/css/color.hpp"). A folder with its own line in the
# table is a room ("formats/css"); otherwise the first folder counts.
function room_of(path, parts, count) {
  count = split(path, parts, "/")
  return count > 2 && (parts[1] "/" parts[2]) in is_folder ? parts[1] "/" parts[2] : parts[1]
}

function check_project_include(path, parts, other, other_room) {
  if (is_public && path !~ /^sfumato\//) complain("a public header may not include " path)
  if (folder == "" || path !~ /\//) return
  sub(/^sfumato\//, "", path)
  if (path == "sfumato.h") {
    if (folder != "capi") complain("the C interface is for capi: " folder " may not include it")
    return
  }
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

# A namespace is sfumato, for public names, or has its folder's name.
function check_namespace(name, parts) {
  if (folder == "" || name == "sfumato") return
  sub(/^sfumato::/, "", name)
  split(name, parts, "::")
  if (parts[1] == folder || room == folder "/" parts[1] || (folder, parts[1]) in named) return
  complain(room " may not open namespace " name)
}

# Returns a line without comments and string literals.
function code_of(line) {
  gsub(/\\./, "", line)
  gsub(/"[^"]*"/, "\"\"", line)
  gsub(/\/\*[^*]*\*\//, "", line)
  sub(/\/\/.*/, "", line)
  return line
}

# Returns an identifier as lower-case words between underscores: "_stop_list_" for StopList and stop_list_.
function words_of(name, words) {
  words = ""
  while (match(name, /[A-Z]*[a-z0-9]+|[A-Z]+/)) {
    words = words "_" tolower(substr(name, RSTART, RLENGTH))
    name = substr(name, RSTART + RLENGTH)
  }
  return words "_"
}

# `stop` means a colour stop and never to end; `scene` means the objects that rays hit, or a file format's
# term.
function check_words(name, words) {
  words = words_of(name)
  if (words ~ /_(stopped|stopping)_/ || words ~ stops_work || (words ~ /_stop_/ && !has_stops)) {
    complain("stop means a colour stop alone: " name)
  }
  if (words ~ /_scenes?_/ && !has_scenes) complain("a scene is what rays hit: " name)
}

# A function, number, place or flag named stop is not a colour stop.
function check_stop_declaration(code) {
  if (code ~ /(bool|int|size_t|int(8|16|32|64)_t|char|Vec2|Status|void|stop_token)>?[ *&]+stop[^A-Za-z0-9_]/ ||
      code ~ /(^|[^A-Za-z0-9_])stop\(/) {
    complain("stop means a colour stop alone: stop")
  }
}

# A cancelled step returns a status. Code that stops in the middle without one returns incomplete data, and
# every caller has to poll the flag again. A poll of the flag has its status on the same line, or on one of
# the next three. `look` is the line of a poll that has no status yet.
function check_looks(code) {
  if (code ~ /(cancel_status|check)\(\)/) {
    look = 0
  } else if (code ~ /(^|[^A-Za-z0-9_])cancelled\(\)/) {
    complain_of_look()
    look = FNR
  } else if (look && FNR >= look + 3) {
    complain_of_look()
  }
}

function complain_of_look() {
  if (!look) return
  print previous_file ":" look ": a cancelled step has to return its status"
  broken = 1
  look = 0
}

# Memory is charged by the code that allocates it (TableMemory, OutputBuffer), or by a measured size. A size
# written by hand is forgotten when the code changes.
function check_charge(code, name) {
  if (code ~ /(^|[^A-Za-z0-9_.])ScopedCharge [a-z_]+[;(]/) {
    name = code
    sub(/^.*ScopedCharge /, "", name)
    sub(/[;(].*/, "", name)
    if (name !~ /(charge|held)_?$/) complain("a ScopedCharge is called charge or held: " name)
  }
  if (code ~ /constexpr .* k[A-Za-z]*(NodeBytes|BytesPer[A-Z][A-Za-z]*) =/ && code !~ /BytesPerPoll/) {
    complain("a figure of memory by hand: measure what is there")
  }
  # A refusal charges one byte more than the budget has.
  if (code ~ /budget_?\.charge\(/ && code !~ /\(room \+ 1,/) complain("memory is charged by TableMemory or ScopedCharge")
  if (!charged && code ~ /((charge|held)_?\.(add|raise_to)|memory_?\.settle)\(/) charged = FNR
  if (!charged) return
  charge_text = charge_text code
  if (code !~ /;|\{/) return
  if (charge_text !~ /(^|[^A-Za-z0-9_])(bytes_of|capacity_bytes|kept_bytes|list_bytes|room_bytes|stroke_bytes)\(/) {
    print FILENAME ":" charged ": a charge has to measure what it is for: bytes_of, capacity_bytes"
    broken = 1
  }
  charged = 0
  charge_text = ""
}

# Returns the text in the string literals of a line.
function words_for_people(line, words) {
  words = ""
  gsub(/\\./, "", line)
  while (match(line, /"[^"]*"/)) {
    words = words " " substr(line, RSTART + 1, RLENGTH - 2)
    line = substr(line, RSTART + RLENGTH)
  }
  gsub(/<!--/, "", words)
  return words
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
  has_stops = folder ~ /^(base|document|picture|curves|formats|import|trace|solve|raster|lint|export|options|capi|cli)$/
  has_scenes = room ~ /^(gather|gather\/kernels|gpu|formats\/orzan|export\/glb)$/
  looks_are_checked = FILENAME ~ /^src\// && !(inner_path(FILENAME) in is_flag_itself)
  charges_are_checked = FILENAME ~ /^src\// && !(inner_path(FILENAME) in is_estimate)
  if (!is_table && folder != "" && !(folder in is_folder)) {
    complain(folder " is not in scripts/folder-order.txt")
  }
}

is_table {
  if ($0 ~ /^#/ || NF == 0) next
  name = uses = $0
  sub(/( \(.*\))?:.*/, "", name)
  sub(/^[^:]*:/, "", uses)
  is_folder[name] = 1
  count = split(uses, used)
  for (i = 1; i <= count; ++i) may_use[name, used[i]] = 1
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

# Only the command knows its options: it adds them to the library's messages.
folder != "" && folder != "cli" && /"/ &&
    words_for_people($0) ~ /--[a-z]|sfumato (init|render|lint|convert|info|compare|watch|edit) / {
  complain("the library may not speak of the command")
}

# In angle brackets one of our headers would escape the check of the folder order.
folder != "" && /^[ \t]*#[ \t]*include[ \t]*<sfumato\// {
  complain("a header of the library is included by quotes")
}

/^[ \t]*(inline )?namespace [a-z_:]+ \{/ {
  name = $0
  sub(/^.*namespace /, "", name)
  sub(/ .*/, "", name)
  check_namespace(name)
}

# Every file of an embedder reads large headers. The headers listed here cost 38,000 lines.
is_public && /^[ \t]*#[ \t]*include[ \t]*</ &&
    !(FILENAME ~ /\.h$/ && /<std(def|int)\.h>/) &&
    !/<(cassert|cstddef|cstdint|optional|span|string|string_view|type_traits|utility|variant|vector)>/ {
  complain("a public header may not include" substr($0, index($0, "include") + 7))
}

core && /^[ \t]*#[ \t]*include[ \t]*<(thread|filesystem|iostream|fstream|regex|future|mutex|shared_mutex|condition_variable|execution)>/ {
  complain("the core may not use" substr($0, index($0, "include") + 7))
}

# Only base/no_throw.hpp turns exceptions of the allocator into a status.
core && FILENAME != "src/base/no_throw.hpp" {
  code = code_of($0)
  if (code ~ /(^|[^A-Za-z0-9_])(throw|try|catch)([^A-Za-z0-9_]|$)/) {
    complain("the core may not throw or catch")
  }
}

folder != "" && /[Ss]top|[Ss]cene/ {
  code = code_of($0)
  check_stop_declaration(code " ")
  while (match(code, /[A-Za-z_][A-Za-z0-9_]*/)) {
    name = substr(code, RSTART, RLENGTH)
    code = substr(code, RSTART + RLENGTH)
    if (name ~ /[Ss]top|[Ss]cene/) check_words(name)
  }
}

looks_are_checked {
  check_looks(code_of($0))
}

charges_are_checked {
  check_charge(code_of($0))
}

END {
  finish_file()
  exit broken
}
