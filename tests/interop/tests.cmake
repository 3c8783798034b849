honeycomb_test(interop_tests
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/open_subdiv_test.cpp
  LIBRARIES honeycomb::test_support honeycomb::interop honeycomb::far honeycomb::osd)
