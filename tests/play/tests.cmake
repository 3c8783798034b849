# `honeycomb play`: what it is made of, and the built program drawing pictures.
honeycomb_test(play_test
  LABELS vulkan
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/backend_choice_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/backend_loader_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/clock_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/headless_errors_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/headless_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/history_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/look_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/orbit_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/pictures.cpp
    ${CMAKE_CURRENT_LIST_DIR}/player_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/surface_loader_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/video_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../viewer/cube.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../vulkan/lsan_suppressions.cpp
  LIBRARIES honeycomb::cli cli_test_support PNG::PNG nlohmann_json::nlohmann_json)
add_dependencies(play_test honeycomb)

# The window under Xvfb, by keys and a mouse of xdotool's. Drivers and X libraries leak: not under sanitizers.
if(HONEYCOMB_WINDOW AND NOT HONEYCOMB_SANITIZE)
  # A Vulkan layer is a library and a file that says so.
  set(lost_device_folder ${CMAKE_CURRENT_BINARY_DIR}/lost_device)
  add_library(lost_device_layer MODULE ${CMAKE_CURRENT_LIST_DIR}/lost_device_layer.cpp)
  set_target_properties(lost_device_layer PROPERTIES CXX_VISIBILITY_PRESET default)
  target_link_libraries(lost_device_layer PRIVATE honeycomb_compile honeycomb_warnings)
  file(GENERATE OUTPUT ${lost_device_folder}/lost_device.json CONTENT "{
  \"file_format_version\": \"1.1.2\",
  \"layer\": {
    \"name\": \"VK_LAYER_lost_device\", \"type\": \"GLOBAL\", \"library_path\": \"$<TARGET_FILE:lost_device_layer>\",
    \"api_version\": \"1.3.0\", \"implementation_version\": \"1\", \"description\": \"Loses devices when it is told to\",
    \"functions\": {
      \"vkGetInstanceProcAddr\": \"loseDeviceGetInstanceProcAddr\",
      \"vkGetDeviceProcAddr\": \"loseDeviceGetDeviceProcAddr\"
    }
  }
}
")
  find_library(HONEYCOMB_XCB xcb REQUIRED)
  honeycomb_test(window_test
    SOURCES
      ${CMAKE_CURRENT_LIST_DIR}/display.cpp
      ${CMAKE_CURRENT_LIST_DIR}/file_drop.cpp
      ${CMAKE_CURRENT_LIST_DIR}/pictures.cpp
      ${CMAKE_CURRENT_LIST_DIR}/window_test.cpp
    LIBRARIES cli_test_support PNG::PNG ${HONEYCOMB_XCB})
  target_compile_definitions(window_test PRIVATE HONEYCOMB_LAYER_FOLDER="${lost_device_folder}")
  add_dependencies(window_test honeycomb lost_device_layer)
endif()
