# `honeycomb play`: what it is made of, and the built program drawing pictures.
honeycomb_test(play_test
  LABELS vulkan
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/backend_choice_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/headless_errors_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/headless_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/look_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/orbit_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/pictures.cpp
    ${CMAKE_CURRENT_LIST_DIR}/video_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../viewer/cube.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../vulkan/lsan_suppressions.cpp
  LIBRARIES honeycomb::cli cli_test_support PNG::PNG nlohmann_json::nlohmann_json)
add_dependencies(play_test honeycomb)
