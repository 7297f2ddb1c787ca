# sfumato_embed(TARGET FOLDER FILE...): compiles text files of FOLDER into TARGET, as
# embedded_file() of src/display/embedded.hpp, by the names given here.
function(sfumato_embed target folder)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/embed_${target}.cpp)
  set(paths)
  foreach(file ${ARGN})
    list(APPEND paths ${folder}/${file})
  endforeach()
  string(REPLACE ";" "|" names "${ARGN}")
  add_custom_command(OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} "-DNAMES=${names}" -DOUTPUT=${generated}
            -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${paths} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake VERBATIM)
  target_sources(${target} PRIVATE ${generated})
endfunction()
