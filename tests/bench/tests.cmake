honeycomb_test(bench_tests
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/comparison_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/meshes_test.cpp
  LIBRARIES honeycomb::bench_kit)
