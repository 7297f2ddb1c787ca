# sfumato_embed(TARGET FUNCTION FILE...): compiles text files into TARGET. FUNCTION of src/display/embedded.hpp
# returns the text of a file by its name, without its folder.
function(sfumato_embed target function)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  string(REPLACE ";" "|" paths "${ARGN}")
  add_custom_command(OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} "-DPATHS=${paths}" -DFUNCTION=${function} -DOUTPUT=${generated}
            -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake VERBATIM)
  target_sources(${target} PRIVATE ${generated})
endfunction()
