honeycomb_test(osd_tests
  SHARDS 8
  TWINS "*/1.*"
  LABELS threads
  ALONE "Differential*:Simd.*:RowTables*:TileLimits*UnderEveryScheme:TileLimits*TooLarge*:TileNormals*UnderEveryScheme:TileNormals*TooLarge*:TileNormals*CostLinear*:Tiles*UnderEveryScheme:Tiles*TooLarge*"
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/buffer_errors_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/differential_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/evaluators_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/every_machine_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/row_tables_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/simd_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/tile_limits_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/tile_normals_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/tile_streams_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/tiles_test.cpp
  LIBRARIES honeycomb::test_support honeycomb::far honeycomb::osd honeycomb::io hwy::hwy)

if(HONEYCOMB_SANITIZE STREQUAL "thread")
  honeycomb_program(seeded_race ${CMAKE_CURRENT_LIST_DIR}/seeded_race.cpp)
  add_dependencies(tests_threads seeded_race)
  target_link_libraries(seeded_race PRIVATE honeycomb::far)
  add_dependencies(tests_threads seeded_race)
  add_test(NAME ThreadSanitizer.ReportsASeededRace COMMAND seeded_race)
  set_tests_properties(ThreadSanitizer.ReportsASeededRace PROPERTIES LABELS threads
                                                                     PASS_REGULAR_EXPRESSION "data race")
endif()
