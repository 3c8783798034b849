# An installation that was moved after it was made, and those who build with it alone: the examples, each a project of its
# own, by CMake and by pkg-config.
set(moved ${CMAKE_CURRENT_BINARY_DIR}/package/moved)
set(script ${CMAKE_CURRENT_SOURCE_DIR}/package)
set(assets ${moved}/${CMAKE_INSTALL_DATADIR}/honeycomb)

# package_test(NAME command...): after the installation; nobody waits for it.
function(package_test name)
  add_test(NAME ${name} COMMAND ${ARGN})
  set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED installation TIMEOUT 300)
endfunction()

# example_test(NAME expected arguments...): configures, builds and runs examples/NAME, which must print what is expected.
function(example_test name expected)
  package_test(example_${name} ${CMAKE_CTEST_COMMAND} --build-and-test
    ${PROJECT_SOURCE_DIR}/examples/${name} ${CMAKE_CURRENT_BINARY_DIR}/package/${name}
    --build-generator ${CMAKE_GENERATOR} --build-noclean
    --build-options -DCMAKE_PREFIX_PATH=${moved} -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
                    "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Werror" "-DCMAKE_C_FLAGS=-std=c99 -Wall -Wextra -Wpedantic -Werror"
    --test-command ./${name} ${ARGN})
  set_tests_properties(example_${name} PROPERTIES PASS_REGULAR_EXPRESSION "${expected}"
                                                  FAIL_REGULAR_EXPRESSION "VUID|SYNC-HAZARD|NOT the CPU's")
endfunction()

add_test(NAME package_install COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DMOVED=${moved}
                                                       -P ${script}/install.cmake)
set_tests_properties(package_install PROPERTIES FIXTURES_SETUP installation)

package_test(package_headers ${CMAKE_COMMAND} -DMOVED=${moved} -DCOMPILER=${CMAKE_CXX_COMPILER} -P ${script}/headers.cmake)
package_test(package_pkg_config ${script}/pkg_config.sh ${moved} ${moved}/${CMAKE_INSTALL_LIBDIR}/pkgconfig
             ${PROJECT_SOURCE_DIR}/examples/cpu_playback/main.cpp ${CMAKE_CXX_COMPILER})
set_tests_properties(package_pkg_config PROPERTIES PASS_REGULAR_EXPRESSION "72 frames, .* ms each")
if(TARGET honeycomb_python)
  get_target_property(interpreter honeycomb_python HONEYCOMB_INTERPRETER)
endif()
package_test(package_debian ${script}/debian.sh ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/package/debian
             ${CMAKE_INSTALL_DATADIR} ${interpreter})

package_test(package_pkg_config_c ${script}/pkg_config_c.sh ${moved} ${moved}/${CMAKE_INSTALL_LIBDIR}
             ${PROJECT_SOURCE_DIR}/examples/c_playback/main.c)
set_tests_properties(package_pkg_config_c PROPERTIES PASS_REGULAR_EXPRESSION "frame 2: checksum")
example_test(c_playback "4608 vertices.*frame 2: checksum")
set(table ${CMAKE_CURRENT_BINARY_DIR}/package/creature.hct)
package_test(package_table_build ${moved}/bin/honeycomb table build ${assets}/creature.obj ${table} --levels 2 --tiles)
set_tests_properties(package_table_build PROPERTIES FIXTURES_SETUP table)
example_test(c_table "72 frames of 9666 vertices and 19328 triangles.*last frame: from .-2.36 0.02 -1.15" ${table} ${assets}/creature.pc2)
set_tests_properties(example_c_table PROPERTIES FIXTURES_REQUIRED "installation;table")
example_test(cpu_playback "72 frames, .* ms each" ${assets}/creature.obj ${assets}/creature.pc2 2)
if(TARGET honeycomb::osd_vulkan)
  example_test(vulkan_app "frame 2: 648 points, checksum [0-9a-f]+, the same as the CPU's")
  # The layer is asked for by its name, as an app's developer would; where it isn't installed the loader goes on without.
  set_tests_properties(example_vulkan_app PROPERTIES LABELS vulkan ENVIRONMENT VK_LOADER_LAYERS_ENABLE=*validation*)
endif()
if(TARGET honeycomb::interop)
  example_test(opensubdiv_migration "Honeycomb frame 3: 216 vertices")
endif()
if(TARGET honeycomb_python)
  set(playback ${PROJECT_SOURCE_DIR}/examples/python_playback/playback.py)
  set(python ${CMAKE_COMMAND} -E env PYTHONPATH=${moved}/${HONEYCOMB_PYTHON_FOLDER} ${interpreter} -B)
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/package/python_playback)
  # With matplotlib, where it is, and without.
  package_test(example_python_playback ${python} ${playback} ${assets}/creature.obj ${assets}/creature.pc2)
  package_test(example_python_playback_obj ${python} ${script}/playback_without_matplotlib.py ${playback}
               ${assets}/creature.obj ${assets}/creature.pc2 1)
  set_tests_properties(example_python_playback example_python_playback_obj PROPERTIES
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/package/python_playback)
  set_tests_properties(example_python_playback PROPERTIES
    PASS_REGULAR_EXPRESSION "72 frames, .* ms each, coordinates from .*playback.(png|obj)")
  set_tests_properties(example_python_playback_obj PROPERTIES PASS_REGULAR_EXPRESSION "3222 vertices and 1613 faces")
endif()
