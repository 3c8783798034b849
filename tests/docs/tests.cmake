# README.md and docs/: links, options, every block of sh and python run in a scratch folder, every block of cpp compiled and
# run.
find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_Interpreter_FOUND OR HONEYCOMB_SANITIZE)
  return()
endif()

# The sources are written as CMake runs, which it does again when a page changes.
set(docs_code ${CMAKE_CURRENT_BINARY_DIR}/docs_code)
file(GLOB_RECURSE docs_pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/README.md ${docs_pages} ${CMAKE_CURRENT_LIST_DIR}/extract_code.py ${CMAKE_CURRENT_LIST_DIR}/markdown.py)
set(docs_python ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${Python3_EXECUTABLE})
execute_process(COMMAND ${docs_python} ${CMAKE_CURRENT_LIST_DIR}/extract_code.py ${PROJECT_SOURCE_DIR} ${docs_code}
                COMMAND_ERROR_IS_FATAL ANY)

honeycomb_test(docs_code_test
  SOURCES ${docs_code}/fragments.cpp
  LIBRARIES honeycomb::osd)
# Fragments show what there is, and leave it at that.
target_compile_options(docs_code_test PRIVATE -Wno-unused -Wno-shadow)

file(GLOB docs_programs ${docs_code}/program_*.cpp)
foreach(source IN LISTS docs_programs)
  cmake_path(GET source STEM program)
  honeycomb_program(docs_${program} ${source})
  target_link_libraries(docs_${program} PRIVATE honeycomb::osd honeycomb::io)
  add_test(NAME docs_${program} COMMAND docs_${program} WORKING_DIRECTORY ${docs_code})
  add_dependencies(tests_all docs_${program})
endforeach()

# The pages speak of a build with everything in it.
if(HONEYCOMB_APPS AND HONEYCOMB_VULKAN AND TARGET honeycomb::interop AND TARGET assimp::assimp AND TARGET honeycomb_mpi
   AND TARGET honeycomb_python)
  get_target_property(interpreter honeycomb_python HONEYCOMB_INTERPRETER)
  add_test(NAME docs_test COMMAND ${interpreter} -B ${CMAKE_CURRENT_LIST_DIR}/docs_test.py
                                  ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR} $<TARGET_FILE:honeycomb>)
endif()
