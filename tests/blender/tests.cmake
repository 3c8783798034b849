# The add-on in Blender, where it is installed (./setup --full) and runs on the Python that the module was built for.
find_program(HONEYCOMB_BLENDER blender)
if(NOT HONEYCOMB_BLENDER OR NOT TARGET honeycomb_python)
  return()
endif()
get_target_property(interpreter_version honeycomb_python HONEYCOMB_INTERPRETER_VERSION)
execute_process(COMMAND ${HONEYCOMB_BLENDER} -b --factory-startup --python-expr
                        "import sys, numpy\nprint('Blender on Python %d.%d' % sys.version_info[:2])"
                OUTPUT_VARIABLE blender_says ERROR_QUIET)
if(NOT blender_says MATCHES "Blender on Python ${interpreter_version}\n")
  message(STATUS "${HONEYCOMB_BLENDER} doesn't run on Python ${interpreter_version} with numpy: no test of the add-on")
  return()
endif()
add_test(NAME blender_addon_test COMMAND ${HONEYCOMB_BLENDER} -b --factory-startup --python-exit-code 1
  --python ${CMAKE_CURRENT_LIST_DIR}/addon_test.py -- ${PROJECT_BINARY_DIR}/python ${PROJECT_SOURCE_DIR})
set_tests_properties(blender_addon_test PROPERTIES TIMEOUT 300 ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
