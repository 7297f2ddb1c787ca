# sfumato_embed(FOLDER FUNCTION FILE...): compiles text files into the library of src/FOLDER. FUNCTION of
# src/FOLDER/embedded.hpp returns the text of a file by its name, without its folder.
function(sfumato_embed folder function)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/${folder}_${function}.cpp)
  string(REPLACE ";" "|" paths "${ARGN}")
  add_custom_command(OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DFUNCTION=${function} "-DPATHS=${paths}" -DOUTPUT=${generated}
            -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake VERBATIM)
  target_sources(sfumato_${folder} PRIVATE ${generated})
endfunction()
