honeycomb_test(bench_tests
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/comparison_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/meshes_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../vulkan/lsan_suppressions.cpp
  LIBRARIES honeycomb::bench_kit)

find_package(Python3 COMPONENTS Interpreter)
if(Python3_Interpreter_FOUND AND HONEYCOMB_APPS)
  add_test(NAME bench_report_test COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/report_test.py
                                          $<TARGET_FILE:honeycomb> ${PROJECT_SOURCE_DIR}/bench/report.py)
  set_tests_properties(bench_report_test PROPERTIES ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
  add_dependencies(tests_all honeycomb)
endif()
