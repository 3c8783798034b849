# The subcommand that needs the renderer.
target_sources(honeycomb_cli PRIVATE
  play.cpp
  play/backend_choice.cpp
  play/backend_loader.cpp
  play/clock.cpp
  play/comparison.cpp
  play/device_levels.cpp
  play/headless.cpp
  play/history.cpp
  play/host_poses.cpp
  play/key_commands.cpp
  play/live_options.cpp
  play/options.cpp
  play/orbit.cpp
  play/player.cpp
  play/rehearsal.cpp
  play/stage.cpp
  play/surface.cpp
  play/surface_loader.cpp
  play/video_pipe.cpp)
target_link_libraries(honeycomb_cli PUBLIC honeycomb::viewer)

# The window: GLFW and Dear ImGui, whose Vulkan backend is compiled here, since the one in Debian's libimgui.a is linked to
# a loader of its own. Debian ships the source among the examples.
find_package(glfw3 3.3 QUIET)
find_library(HONEYCOMB_IMGUI imgui)
find_path(HONEYCOMB_IMGUI_HEADERS imgui.h PATH_SUFFIXES imgui)
find_file(HONEYCOMB_IMGUI_VULKAN imgui_impl_vulkan.cpp
  PATHS ${HONEYCOMB_IMGUI_HEADERS}/backends /usr/share/doc/libimgui-dev/examples/backends NO_DEFAULT_PATH)
set(window_found OFF)
if(glfw3_FOUND AND HONEYCOMB_IMGUI AND HONEYCOMB_IMGUI_HEADERS AND HONEYCOMB_IMGUI_VULKAN)
  set(window_found ON)
endif()
option(HONEYCOMB_WINDOW "Build the window of honeycomb play" ${window_found})

if(HONEYCOMB_WINDOW)
  if(NOT window_found)
    message(FATAL_ERROR "HONEYCOMB_WINDOW needs libglfw3-dev and libimgui-dev (with its examples' backends)")
  endif()
  add_library(honeycomb_imgui_vulkan OBJECT ${HONEYCOMB_IMGUI_VULKAN})
  target_compile_definitions(honeycomb_imgui_vulkan PUBLIC IMGUI_IMPL_VULKAN_NO_PROTOTYPES)
  target_include_directories(honeycomb_imgui_vulkan SYSTEM PUBLIC
    ${HONEYCOMB_IMGUI_HEADERS} ${HONEYCOMB_IMGUI_HEADERS}/backends)
  set_target_properties(honeycomb_imgui_vulkan PROPERTIES UNITY_BUILD OFF)
  target_sources(honeycomb_cli PRIVATE
    play/window/calls.cpp
    play/window/imgui_vulkan.cpp
    play/window/input.cpp
    play/window/interface.cpp
    play/window/options_panel.cpp
    play/window/panel.cpp
    play/window/play_in_window.cpp
    play/window/screen.cpp
    play/window/swapchain.cpp
    play/window/window.cpp
    $<TARGET_OBJECTS:honeycomb_imgui_vulkan>)
  target_compile_definitions(honeycomb_cli PRIVATE IMGUI_IMPL_VULKAN_NO_PROTOTYPES HONEYCOMB_WINDOW)
  target_include_directories(honeycomb_cli SYSTEM PRIVATE
    ${HONEYCOMB_IMGUI_HEADERS} ${HONEYCOMB_IMGUI_HEADERS}/backends)
  target_link_libraries(honeycomb_cli PRIVATE ${HONEYCOMB_IMGUI} glfw stb)
else()
  target_sources(honeycomb_cli PRIVATE play/window_absent.cpp)
endif()
