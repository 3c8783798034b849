# `honeycomb play`: what it is made of, and the built program drawing pictures.
honeycomb_test(play_test
  LABELS vulkan
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/backend_choice_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/clock_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/headless_errors_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/headless_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/history_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/look_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/orbit_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/pictures.cpp
    ${CMAKE_CURRENT_LIST_DIR}/player_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/video_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../viewer/cube.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../vulkan/lsan_suppressions.cpp
  LIBRARIES honeycomb::cli cli_test_support PNG::PNG nlohmann_json::nlohmann_json)
add_dependencies(play_test honeycomb)

# The window under Xvfb, by keys and a mouse of xdotool's. Drivers and X libraries leak: not under sanitizers.
if(HONEYCOMB_WINDOW AND NOT HONEYCOMB_SANITIZE)
  honeycomb_test(window_test
    SOURCES
      ${CMAKE_CURRENT_LIST_DIR}/display.cpp
      ${CMAKE_CURRENT_LIST_DIR}/pictures.cpp
      ${CMAKE_CURRENT_LIST_DIR}/window_test.cpp
    LIBRARIES cli_test_support PNG::PNG)
  add_dependencies(window_test honeycomb)
endif()
