# Every installed header, found through the installation alone.
file(GLOB_RECURSE headers RELATIVE ${MOVED}/include ${MOVED}/include/honeycomb/*.h)
set(lines "")
foreach(header IN LISTS headers)
  string(APPEND lines "#include <${header}>\n")
endforeach()
file(WRITE ${MOVED}.headers.cpp "${lines}int main() {}\n")
execute_process(COMMAND ${COMPILER} -std=c++20 -Wall -Wextra -Wpedantic -Werror -fsyntax-only
                        -I${MOVED}/include -I${MOVED}/include/honeycomb ${MOVED}.headers.cpp COMMAND_ERROR_IS_FATAL ANY)
