# Many frames, after which memory is what it was. ctest plays some thousands; ./check --full 100,000.
# soak_program(NAME FRAMES LIBRARIES..)
function(soak_program name frames)
  honeycomb_program(${name} soak/soak.cpp soak/${name}.cpp)
  target_link_libraries(${name} PRIVATE honeycomb::test_support ${ARGN})
  add_dependencies(tests_all ${name})
  add_test(NAME ${name} COMMAND ${name} ${frames})
  set_tests_properties(${name} PROPERTIES TIMEOUT 300)
endfunction()

soak_program(soak_threads 5000 honeycomb::osd)
if(HONEYCOMB_VULKAN)
  soak_program(soak_vulkan 2000 honeycomb::osd_vulkan)
endif()
