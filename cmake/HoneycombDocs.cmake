# The target `docs`: the reference of the public headers, which are those that get installed, as HTML in
# docs/html of the build folder. It fails where a header leaves something undescribed.
find_package(Doxygen QUIET)
find_package(Python3 COMPONENTS Interpreter QUIET)
if(NOT DOXYGEN_FOUND OR NOT Python3_Interpreter_FOUND)
  return()
endif()

set(reference_headers "")
foreach(library IN ITEMS far osd chain io osd_vulkan interop)
  if(TARGET honeycomb_${library})
    get_target_property(headers honeycomb_${library} HEADER_SET)
    list(APPEND reference_headers ${headers})
  endif()
endforeach()
if(TARGET honeycomb_c)
  get_target_property(headers honeycomb_c HEADER_SET)
  list(APPEND reference_headers ${headers})
endif()
set(doxygen_input ${reference_headers})
list(TRANSFORM doxygen_input REPLACE "(.+)" "\"\\1\"")
list(JOIN doxygen_input " " doxygen_input)
configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${PROJECT_BINARY_DIR}/docs/Doxyfile @ONLY)

add_custom_target(docs
  COMMAND ${DOXYGEN_EXECUTABLE} ${PROJECT_BINARY_DIR}/docs/Doxyfile
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/reference_warnings.py ${PROJECT_BINARY_DIR}/docs/warnings.txt
  SOURCES ${reference_headers}
  COMMENT "Reference of the public headers: ${PROJECT_BINARY_DIR}/docs/html/index.html"
  VERBATIM)
