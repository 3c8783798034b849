find_package(nlohmann_json 3.11 REQUIRED)

add_library(cli_test_support OBJECT
  ${CMAKE_CURRENT_LIST_DIR}/run_program.cpp
  ${CMAKE_CURRENT_LIST_DIR}/workplace.cpp)
target_link_libraries(cli_test_support PUBLIC honeycomb_compile honeycomb_sanitize fmt::fmt
                                       PRIVATE honeycomb_warnings GTest::gtest GTest::gmock)
# Loaded into the program, which has the sanitizers.
add_library(cli_signal_at_write MODULE ${CMAKE_CURRENT_LIST_DIR}/signal_at_write.cpp)
target_link_libraries(cli_signal_at_write PRIVATE honeycomb_compile honeycomb_warnings)
# Its functions take the place of the C library's.
set_target_properties(cli_signal_at_write PROPERTIES CXX_VISIBILITY_PRESET default)
target_compile_definitions(cli_test_support PRIVATE HONEYCOMB_PROGRAM="$<TARGET_FILE:honeycomb>"
                                                    HONEYCOMB_SIGNAL_AT_WRITE="$<TARGET_FILE:cli_signal_at_write>"
                                                    HONEYCOMB_MPIRUN="${MPIEXEC_EXECUTABLE}")

# The program's leaks are its own: what drivers leave behind is passed over.
if(HONEYCOMB_VULKAN AND HONEYCOMB_SANITIZE)
  target_sources(honeycomb PRIVATE ${CMAKE_CURRENT_LIST_DIR}/../vulkan/lsan_suppressions.cpp)
endif()

# The built program, run on real files.
honeycomb_test(cli_test
  SHARDS 4
  TWINS "RefineTest.SerialSimdAndTbbGiveTheSameFile:SchemeTest.FastNormalsAreTheSameOnSerialAndTbb*"
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/animated_input_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/bad_cache_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/bad_mesh_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/bad_option_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/bad_output_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/bad_scheme_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/bench_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/console_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/convert_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/info_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/primvars_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/refine_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/scheme_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/table_test.cpp
  LIBRARIES honeycomb::cli cli_test_support nlohmann_json::nlohmann_json)
add_dependencies(cli_test honeycomb cli_signal_at_write)
if(TARGET assimp::assimp)
  target_sources(cli_test PRIVATE ${CMAKE_CURRENT_LIST_DIR}/scene_input_test.cpp)
endif()

# A bake has frames in flight on all threads.
honeycomb_test(cli_bake_test
  LABELS threads
  SHARDS 2
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/bake_inputs_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/bake_resume_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/bake_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/bake_tiles_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../vulkan/lsan_suppressions.cpp
  LIBRARIES honeycomb::cli cli_test_support nlohmann_json::nlohmann_json)
add_dependencies(cli_bake_test honeycomb cli_signal_at_write)

if(HONEYCOMB_VULKAN)
  honeycomb_test(cli_vulkan_test
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/vulkan_test.cpp
    LIBRARIES cli_test_support nlohmann_json::nlohmann_json)
  add_dependencies(cli_vulkan_test honeycomb)
endif()

# Four processes on this machine.
if(TARGET honeycomb_mpi AND MPIEXEC_EXECUTABLE)
  honeycomb_test(cli_mpi_test
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/mpi_test.cpp
    LIBRARIES cli_test_support nlohmann_json::nlohmann_json)
  add_dependencies(cli_mpi_test honeycomb cli_signal_at_write)
endif()
