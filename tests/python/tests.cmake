# The Python module, installed by pip where nothing else is, and tested from there by the interpreter it was built for.
if(NOT TARGET honeycomb_python)
  return()
endif()
get_target_property(python_interpreter honeycomb_python HONEYCOMB_INTERPRETER)
get_target_property(python_project honeycomb_python HONEYCOMB_PROJECT)
execute_process(COMMAND ${python_interpreter} -c "import setuptools, numpy, pip, wheel" RESULT_VARIABLE lacking ERROR_QUIET)
if(lacking)
  message(STATUS "${python_interpreter} lacks numpy, pip, setuptools or wheel: no tests of the Python module")
  return()
endif()

set(python_site ${CMAKE_CURRENT_BINARY_DIR}/python/site)
add_dependencies(tests_all honeycomb_python)
add_test(NAME python_install COMMAND ${python_interpreter} ${CMAKE_CURRENT_LIST_DIR}/install.py ${python_project} ${python_site})
set_tests_properties(python_install PROPERTIES FIXTURES_SETUP python_site TIMEOUT 300)
add_test(NAME python_test COMMAND ${python_interpreter} -B -m unittest discover -s ${CMAKE_CURRENT_LIST_DIR} -p *_test.py)
set_tests_properties(python_test PROPERTIES FIXTURES_REQUIRED python_site TIMEOUT 300
  ENVIRONMENT "PYTHONPATH=${python_site};HONEYCOMB_ROOT=${PROJECT_SOURCE_DIR};HONEYCOMB_PROGRAM=$<TARGET_FILE:honeycomb>")
