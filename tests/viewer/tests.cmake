honeycomb_test(viewer_tests
  LABELS vulkan
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/../../apps/demo/contest.cpp
    ${CMAKE_CURRENT_LIST_DIR}/camera_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/cell_colours_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/contact_sheet_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/contest_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/cube.cpp
    ${CMAKE_CURRENT_LIST_DIR}/painter_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/renderer_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../vulkan/lsan_suppressions.cpp
  LIBRARIES honeycomb_vulkan_test_support honeycomb::viewer honeycomb::osd honeycomb::io PNG::PNG fmt::fmt)
