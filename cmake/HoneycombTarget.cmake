# One place for what every target of the project is compiled with.

# No contraction: each operation is rounded, so that all evaluators give the same bits.
add_library(honeycomb_compile INTERFACE)
target_compile_features(honeycomb_compile INTERFACE cxx_std_20)
target_compile_options(honeycomb_compile INTERFACE -ffp-contract=off)
target_include_directories(honeycomb_compile INTERFACE ${PROJECT_SOURCE_DIR})
# gcc looks for memory it can use again from 128 MB on, a tenth of its time where several sources are compiled as one.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(honeycomb_compile INTERFACE --param=ggc-min-heapsize=524288)
endif()

# Static libraries end in shared ones (the C library, other people's modules), of whose symbols nobody else should see any;
# shared ones show the names of the project and nothing of what they are made with (cmake/exported.map).
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT BUILD_SHARED_LIBS)
  set(CMAKE_CXX_VISIBILITY_PRESET hidden)
  set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
endif()

add_library(honeycomb_warnings INTERFACE)
target_compile_options(honeycomb_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
# With the thread sanitizer gcc 12 warns falsely of the storage of tl::expected; every other build has warnings as errors.
if(HONEYCOMB_SANITIZE MATCHES "thread")
  target_compile_options(honeycomb_warnings INTERFACE -Wno-error)
endif()

add_library(honeycomb_sanitize INTERFACE)
if(HONEYCOMB_SANITIZE)
  target_compile_options(honeycomb_sanitize INTERFACE -fsanitize=${HONEYCOMB_SANITIZE} -fno-sanitize-recover=all
                                                      -fno-omit-frame-pointer)
  if(HONEYCOMB_SANITIZE MATCHES "address.*undefined")
    # The address sanitizer sees these as well, as far as memory is touched; checked twice they are a quarter of the build,
    # and the overflow of pointers three quarters of clang's on vector code.
    target_compile_options(honeycomb_sanitize INTERFACE -fno-sanitize=null,object-size,vptr,pointer-overflow)
    # What undefined behaviour is told by holds 700,000 addresses, which a program that may lie anywhere finds out whenever it
    # starts: a sixth of the command line's start.
    target_link_options(honeycomb_sanitize INTERFACE $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-no-pie>)
  endif()
  target_link_options(honeycomb_sanitize INTERFACE -fsanitize=${HONEYCOMB_SANITIZE})
  # LLVM's linker takes a quarter of the time that GNU's takes for programs with these.
  find_program(HONEYCOMB_LLD NAMES ld.lld-14 ld.lld)
  if(HONEYCOMB_LLD AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_link_options(honeycomb_sanitize INTERFACE --ld-path=${HONEYCOMB_LLD})
  endif()
  target_compile_definitions(honeycomb_sanitize INTERFACE HONEYCOMB_SANITIZED)  # gcc and clang each say so in their own way
endif()

# The standard headers that nearly every source includes, parsed once; what a source uses it includes all the same.
# Targets with optimisation flags of their own can't share them.
add_library(honeycomb_headers STATIC ${PROJECT_SOURCE_DIR}/cmake/headers.cpp)
target_link_libraries(honeycomb_headers PRIVATE honeycomb_compile honeycomb_sanitize honeycomb_warnings)
target_precompile_headers(honeycomb_headers PRIVATE
  <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <numeric> <span> <string> <string_view> <vector>
  <tl/expected.hpp>)

# honeycomb_library(NAME sources...): the library honeycomb_NAME and its alias honeycomb::NAME. How the project compiles
# is no business of who uses an installed one.
function(honeycomb_library name)
  add_library(honeycomb_${name} ${ARGN})
  add_library(honeycomb::${name} ALIAS honeycomb_${name})
  target_link_libraries(honeycomb_${name} PUBLIC $<BUILD_INTERFACE:honeycomb_compile> $<BUILD_INTERFACE:honeycomb_sanitize>
                                          PRIVATE $<BUILD_INTERFACE:honeycomb_warnings>)
  target_precompile_headers(honeycomb_${name} REUSE_FROM honeycomb_headers)
endfunction()

# honeycomb_program(NAME sources...)
function(honeycomb_program name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE honeycomb_compile honeycomb_sanitize honeycomb_warnings)
endfunction()

# honeycomb_compile_apart(TARGET regex): sources of the target, called in its folder, that every preset compiles one by one.
# All but debug compile several sources at a time (CMAKE_UNITY_BUILD), which costs up to 40 % less: the names
# in the anonymous namespaces of a target must differ. What stays apart: files that implement one pattern under the same
# names, and those that Highway compiles once for each set of instructions.
function(honeycomb_compile_apart target regex)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "${regex}")
  set_source_files_properties(${sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
