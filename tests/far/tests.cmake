set(honeycomb_far_tests
  array_test.cpp
  bounds_test.cpp
  bricks_test.cpp
  charts_test.cpp
  circulant_form_test.cpp
  closed_forms_test.cpp
  conversions_test.cpp
  counts_test.cpp
  creases_half_box_test.cpp
  creases_random_test.cpp
  creases_test.cpp
  defects_test.cpp
  face_varying_large_faces_test.cpp
  face_varying_test.cpp
  geometry_test.cpp
  golden_files_test.cpp
  golden_half_edges_test.cpp
  golden_test.cpp
  half_box_clamped_limits_test.cpp
  half_box_clamped_test.cpp
  half_box_large_clamped_test.cpp
  half_box_test.cpp
  inverse_dual_test.cpp
  large_faces_creases_test.cpp
  large_faces_test.cpp
  limits_test.cpp
  links_test.cpp
  natural_configuration_test.cpp
  options_test.cpp
  pair_triangles_test.cpp
  patch_large_faces_test.cpp
  patch_stencils_test.cpp
  patch_table_test.cpp
  reference_test.cpp
  schemes_test.cpp
  spatial_order_test.cpp
  split_non_manifold_test.cpp
  stencil_table_test.cpp
  stencil_test.cpp
  tables_test.cpp
  tile_join_test.cpp
  topology_test.cpp)
list(TRANSFORM honeycomb_far_tests PREPEND ${CMAKE_CURRENT_LIST_DIR}/)

# The tests' own shapes, random meshes, comparison and reference implementation.
honeycomb_library(test_support STATIC
  ${CMAKE_CURRENT_LIST_DIR}/../support/clamped_reference.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/converted.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/creased.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/golden.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/golden_chain.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/honeycombs.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/manifold_check.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/mesh_compare.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/mesh_edit.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/patch_surfaces.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/poly_mesh.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/random_mesh.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/random_refinements.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/random_tables.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/reference_zip.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/refined.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/scheme_list.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/sha256.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/shapes.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/table_rows.cpp)
target_link_libraries(honeycomb_test_support PUBLIC honeycomb::far honeycomb::osd)
target_compile_definitions(honeycomb_test_support PRIVATE HONEYCOMB_TEST_DATA="${CMAKE_CURRENT_LIST_DIR}/../golden")
# The tests' own refinements and their damaged, random and golden meshes: half of what tests take under sanitizers.
if(HONEYCOMB_SANITIZE)
  target_compile_options(honeycomb_test_support PRIVATE -O1)
  set_target_properties(honeycomb_test_support PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)
endif()

honeycomb_test(far_tests
  SHARDS 8
  TWINS "Stencils.ArePositive*:Stencils.StayIn*:Stencils.Commute*:ZipAgainstReference.DropOn*:Counts.EulersCharacteristic*"
  SOURCES ${honeycomb_far_tests}
  LIBRARIES honeycomb::test_support honeycomb::far honeycomb::osd honeycomb::io)

# Meshes large enough for every parallel loop to be cut: what the thread sanitizer has to see of far.
honeycomb_test(far_thread_tests
  LABELS threads
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/determinism_test.cpp ${CMAKE_CURRENT_LIST_DIR}/parallel_test.cpp
          ${CMAKE_CURRENT_LIST_DIR}/patch_threads_test.cpp
  LIBRARIES honeycomb::test_support honeycomb::far honeycomb::osd)
