# The C API: a program in C99 on the shared library, calling every function; the numbers against the C++ API's.
if(NOT CMAKE_C_COMPILER)
  string(REGEX REPLACE "clang\\+\\+" "clang" c_compiler "${CMAKE_CXX_COMPILER}")
  string(REGEX REPLACE "g\\+\\+" "gcc" c_compiler "${c_compiler}")
  string(REGEX REPLACE "c\\+\\+" "cc" c_compiler "${c_compiler}")
  if(EXISTS "${c_compiler}")
    set(CMAKE_C_COMPILER "${c_compiler}" CACHE FILEPATH "C compiler: the C++ compiler's own")
  endif()
endif()
enable_language(C)

set(c99 -std=c99 -Wall -Wextra -pedantic -Werror)
set(capi_sources c_api_test.c evaluation.c files.c meshes.c tables.c)
list(TRANSFORM capi_sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/)

add_executable(c_api_test ${capi_sources})
set_target_properties(c_api_test PROPERTIES UNITY_BUILD OFF)
target_compile_options(c_api_test PRIVATE ${c99})
target_link_libraries(c_api_test PRIVATE honeycomb::c honeycomb_sanitize m)
if(HONEYCOMB_SANITIZE)
  set_target_properties(c_api_test PROPERTIES LINKER_LANGUAGE CXX)  # the library needs the sanitizers' run-time for C++
endif()
add_dependencies(tests_all c_api_test)
add_test(NAME c_api_test COMMAND c_api_test ${CMAKE_CURRENT_BINARY_DIR})
set(capi_programs $<TARGET_FILE:c_api_test>)
if(HONEYCOMB_VULKAN)
  add_executable(c_vulkan_test
    ${CMAKE_CURRENT_LIST_DIR}/c_vulkan_test.c
    ${CMAKE_CURRENT_LIST_DIR}/engine_c.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../vulkan/engine.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../vulkan/lsan_suppressions.cpp)
  set_target_properties(c_vulkan_test PROPERTIES UNITY_BUILD OFF)
  target_compile_options(c_vulkan_test PRIVATE $<$<COMPILE_LANGUAGE:C>:${c99}>)
  target_include_directories(c_vulkan_test SYSTEM PRIVATE ${HONEYCOMB_VULKAN_INCLUDE})
  target_link_libraries(c_vulkan_test PRIVATE honeycomb::c honeycomb_compile honeycomb_sanitize ${CMAKE_DL_LIBS})
  add_dependencies(tests_all c_vulkan_test)
  add_dependencies(tests_vulkan c_vulkan_test)
  add_test(NAME c_vulkan_test COMMAND c_vulkan_test ${CMAKE_CURRENT_BINARY_DIR})
  set_tests_properties(c_vulkan_test PROPERTIES LABELS vulkan)
  list(APPEND capi_programs $<TARGET_FILE:c_vulkan_test>)
else()
  target_sources(c_api_test PRIVATE ${CMAKE_CURRENT_LIST_DIR}/vulkan_absent.c)
  target_compile_definitions(c_api_test PRIVATE HONEYCOMB_WITHOUT_VULKAN)
endif()

# No function of the library that the programs don't call, and none beside those of the headers.
get_target_property(capi_headers honeycomb_c HEADER_SET)
add_test(NAME c_api_exports COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} -DLIBRARY=$<TARGET_FILE:honeycomb_c>
  "-DPROGRAMS=${capi_programs}" "-DHEADERS=${capi_headers}"
  -P ${CMAKE_CURRENT_LIST_DIR}/exports.cmake)

# The headers and the program by every C compiler there is, as C99, C11 and C++.
find_program(HONEYCOMB_GCC gcc)
find_program(HONEYCOMB_CLANG clang-14)
foreach(compiler IN ITEMS HONEYCOMB_GCC HONEYCOMB_CLANG)
  if(${compiler})
    add_test(NAME c_api_c99.${compiler} COMMAND ${${compiler}} ${c99} -fsyntax-only
      -I${PROJECT_SOURCE_DIR}/capi/include ${capi_sources})
    foreach(language IN ITEMS "c -std=c11" "c++ -std=c++11")
      string(REGEX REPLACE ".*=" "" standard "${language}")
      separate_arguments(language)
      add_test(NAME c_api_header.${standard}.${compiler} COMMAND ${${compiler}} -x ${language} -Wall -Wextra -pedantic -Werror
        -fsyntax-only ${capi_headers})
    endforeach()
  endif()
endforeach()

honeycomb_test(capi_same_as_cpp_test
  LABELS threads
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/same_as_cpp_test.cpp
  LIBRARIES honeycomb::test_support honeycomb::c_static honeycomb::osd)
