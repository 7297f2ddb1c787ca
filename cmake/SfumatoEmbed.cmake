# sfumato_embed(TARGET FOLDER FILE...): compiles text files of FOLDER into TARGET, available by the names
# given here from embedded_file() of src/display/embedded.hpp. NAME=PATH is a file of another folder; PATH
# is relative to the project.
function(sfumato_embed target folder)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/embed_${target}.cpp)
  set(paths)
  set(names)
  foreach(file ${ARGN})
    if(file MATCHES "^(.*)=(.*)$")
      set(path ${PROJECT_SOURCE_DIR}/${CMAKE_MATCH_2})
      set(file ${CMAKE_MATCH_1})
    else()
      set(path ${folder}/${file})
    endif()
    list(APPEND paths ${path})
    list(APPEND names ${file}=${path})
  endforeach()
  string(REPLACE ";" "|" names "${names}")
  add_custom_command(OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} "-DNAMES=${names}" -DOUTPUT=${generated}
            -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${paths} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake VERBATIM)
  target_sources(${target} PRIVATE ${generated})
endfunction()
