# Installs the build of folder BUILD somewhere and moves it to MOVED.
set(first ${MOVED}.first)
file(REMOVE_RECURSE ${first} ${MOVED})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${first} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${first} ${MOVED})
# Files that say where they were made would be wrong now.
file(GLOB_RECURSE texts ${MOVED}/*.cmake ${MOVED}/*.pc ${MOVED}/*.h)
foreach(text IN LISTS texts)
  file(STRINGS ${text} lines REGEX "${first}|${BUILD}")
  if(lines)
    message(FATAL_ERROR "${text} names a folder of the build: ${lines}")
  endif()
endforeach()
