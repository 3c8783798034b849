# On the validation preset (HONEYCOMB_VULKAN_VALIDATION=1 in the environment) every Vulkan test runs under the validation
# layer and must not cause a message.
set(HONEYCOMB_VULKAN_TESTS
  context_test batches_test limits_test paging_test evaluator_test session_test staging_test synchronization_test
  precise_test memory_pool_test faults_test
  callers_device_test sharing_test host_memory_test device_validation_test
  frames_test frames_faults_test timing_test pipeline_cache_test kernel_files_test
  pruned_code_test)

add_library(honeycomb_vulkan_test_support STATIC
  ${CMAKE_CURRENT_LIST_DIR}/engine.cpp
  ${CMAKE_CURRENT_LIST_DIR}/reference.cpp
  ${CMAKE_CURRENT_LIST_DIR}/runs.cpp
  ${CMAKE_CURRENT_LIST_DIR}/spy.cpp)
target_link_libraries(honeycomb_vulkan_test_support PUBLIC honeycomb::osd_vulkan honeycomb::test_support
                                                            GTest::gtest PRIVATE honeycomb_warnings)

# Under the address sanitizer pages are crossed with limits lowered: 144 MB of random tables take most of a minute there.
foreach(name IN LISTS HONEYCOMB_VULKAN_TESTS)
  honeycomb_test(vulkan_${name}
    LABELS vulkan
    TWINS "PagingTest.LevelsPastTheDevicesOwnLimit"
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/${name}.cpp ${CMAKE_CURRENT_LIST_DIR}/lsan_suppressions.cpp
    LIBRARIES honeycomb_vulkan_test_support honeycomb::osd_vulkan)
endforeach()

if(HONEYCOMB_KERNEL_RELOAD)
  target_compile_definitions(vulkan_kernel_files_test PRIVATE HONEYCOMB_KERNEL_RELOAD)
endif()

# The evaluator on what far makes; with the meshes of far's own tests.
honeycomb_test(vulkan_refinement_test
  LABELS vulkan
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/refinement_test.cpp ${CMAKE_CURRENT_LIST_DIR}/lsan_suppressions.cpp
  LIBRARIES honeycomb_vulkan_test_support honeycomb::osd_vulkan honeycomb::test_support)
honeycomb_test(vulkan_level_normals_test
  LABELS vulkan
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/level_normals_test.cpp ${CMAKE_CURRENT_LIST_DIR}/lsan_suppressions.cpp
  LIBRARIES honeycomb_vulkan_test_support honeycomb::osd_vulkan honeycomb::test_support)
foreach(name IN ITEMS tiles_test tile_normals_test tile_frames_test)
  honeycomb_test(vulkan_${name}
    LABELS vulkan
    SHARDS 4
    TWINS "TilesTest.OfPointsOfAnyLengthAndStride:TilesTest.OfFacesWithAnyNumberOfSides:*/Fast"
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/${name}.cpp ${CMAKE_CURRENT_LIST_DIR}/lsan_suppressions.cpp
    LIBRARIES honeycomb_vulkan_test_support honeycomb::osd_vulkan honeycomb::test_support)
endforeach()
honeycomb_test(vulkan_topology_test
  LABELS vulkan
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/topology_test.cpp ${CMAKE_CURRENT_LIST_DIR}/lsan_suppressions.cpp
  LIBRARIES honeycomb_vulkan_test_support honeycomb::osd_vulkan honeycomb::test_support)
honeycomb_test(vulkan_table_file_test
  LABELS vulkan
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/table_file_test.cpp ${CMAKE_CURRENT_LIST_DIR}/lsan_suppressions.cpp
  LIBRARIES honeycomb_vulkan_test_support honeycomb::osd_vulkan honeycomb::io honeycomb::test_support)
