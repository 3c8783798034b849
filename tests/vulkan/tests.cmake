# On the validation preset (HONEYCOMB_VULKAN_VALIDATION=1 in the environment) every Vulkan test runs under the validation
# layer and must not cause a message.
add_library(honeycomb_vulkan_test_support STATIC
  ${CMAKE_CURRENT_LIST_DIR}/engine.cpp
  ${CMAKE_CURRENT_LIST_DIR}/reference.cpp
  ${CMAKE_CURRENT_LIST_DIR}/runs.cpp
  ${CMAKE_CURRENT_LIST_DIR}/spy.cpp)
target_link_libraries(honeycomb_vulkan_test_support PUBLIC honeycomb::osd_vulkan honeycomb::test_support
                                                            GTest::gtest PRIVATE honeycomb_warnings)

# One program: each of its files would take longer to start compiling than to compile. Under the address sanitizer pages are
# crossed with limits lowered: 144 MB of random tables take most of a minute there.
set(vulkan_tests
  batches_test.cpp
  callers_device_test.cpp
  context_test.cpp
  device_validation_test.cpp
  evaluator_test.cpp
  faults_test.cpp
  frames_faults_test.cpp
  frames_test.cpp
  kernel_files_test.cpp
  level_normals_test.cpp
  limits_test.cpp
  lsan_suppressions.cpp
  memory_pool_test.cpp
  paging_test.cpp
  pipeline_cache_test.cpp
  precise_test.cpp
  pruned_code_test.cpp
  refinement_test.cpp
  session_test.cpp
  sharing_test.cpp
  staging_test.cpp
  synchronization_test.cpp
  table_file_test.cpp
  tile_frames_test.cpp
  tile_normals_test.cpp
  tiles_test.cpp
  timing_test.cpp
  topology_test.cpp)
list(TRANSFORM vulkan_tests PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
string(JOIN ":" vulkan_twins
  PagingTest.LevelsPastTheDevicesOwnLimit*
  TilesTest.OfPointsOfAnyLengthAndStride
  TilesTest.OfFacesWithAnyNumberOfSides
  *TileNormalsTest*/Fast
  *FaultsTest.EachCallThatFailsIsAnErrorAndLeavesNothingBehind/OutOfDeviceMemory)
honeycomb_test(vulkan_tests
  LABELS vulkan
  SHARDS 12
  TWINS "${vulkan_twins}"
  SOURCES ${vulkan_tests}
  LIBRARIES honeycomb_vulkan_test_support honeycomb::osd_vulkan honeycomb::io honeycomb::test_support)
if(HONEYCOMB_KERNEL_RELOAD)
  target_compile_definitions(vulkan_tests PRIVATE HONEYCOMB_KERNEL_RELOAD)
endif()

# Apart: it takes the place of operator new.
honeycomb_test(vulkan_host_memory_test
  LABELS vulkan
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/host_memory_test.cpp ${CMAKE_CURRENT_LIST_DIR}/lsan_suppressions.cpp
  LIBRARIES honeycomb_vulkan_test_support honeycomb::osd_vulkan)
