honeycomb_test(io_tests
  SOURCES
    io/frame_names_test.cpp
    io/glb_writer_test.cpp
    io/mapped_file_test.cpp
    io/mdd_reader_test.cpp
    io/mdd_writer_test.cpp
    io/mesh_sequence_test.cpp
    io/obj_corners_test.cpp
    io/obj_errors_test.cpp
    io/obj_points_test.cpp
    io/obj_reader_test.cpp
    io/obj_round_trip_test.cpp
    io/obj_tags_test.cpp
    io/obj_writer_test.cpp
    io/output_file_test.cpp
    io/pc2_writer_test.cpp
    io/ply_reader_test.cpp
    io/ply_writer_test.cpp
    io/png_test.cpp
    io/resampled_frames_test.cpp
    io/text_cursor_test.cpp
    io/triangulate_test.cpp
  LIBRARIES honeycomb::io PNG::PNG nlohmann_json::nlohmann_json)

# Frames are written by threads.
honeycomb_test(io_unfinished_frames_test
  LABELS threads
  SOURCES io/unfinished_frames_test.cpp
  LIBRARIES honeycomb::io)

# One reader is shared by threads.
honeycomb_test(io_pc2_reader_test
  LABELS threads
  SOURCES io/pc2_reader_test.cpp
  LIBRARIES honeycomb::io)

if(TARGET assimp::assimp)
  # Frames of one clip are asked for by many threads.
  honeycomb_test(io_scene_tests
    LABELS threads
    SOURCES
      io/scene/assimp_models_test.cpp
      io/scene/interpolation_test.cpp
      io/scene/lsan_suppressions.cpp
      io/scene/scene_test.cpp
      io/scene/trial_test.cpp
      io/scene/weld_test.cpp
    LIBRARIES honeycomb::io nlohmann_json::nlohmann_json)
endif()

# Proofs are parallel, and made once for all threads.
honeycomb_test(io_table_tests
  LABELS threads
  SHARDS 2
  SOURCES
    io/table_fault_test.cpp
    io/table_file_test.cpp
  LIBRARIES honeycomb::io honeycomb::osd honeycomb::test_support)
