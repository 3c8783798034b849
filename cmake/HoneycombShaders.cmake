# honeycomb_shaders(TARGET files...): compiles GLSL under shaders/ to SPIR-V at build time and embeds it in the target.
# The shader circulant.comp becomes the header "shaders/circulant.comp.h" with `const uint32_t kCirculantComp[]`; include
# it inside an anonymous namespace, after <cstdint>. Files that a shader includes are dependencies.
find_program(HONEYCOMB_GLSLANG glslangValidator REQUIRED)

function(honeycomb_shaders target)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/generated)
  set(headers)
  foreach(shader IN LISTS ARGN)
    set(source ${PROJECT_SOURCE_DIR}/shaders/${shader})
    set(header ${folder}/shaders/${shader}.h)
    string(REGEX REPLACE "[._]" ";" words "${shader}")
    set(name k)
    foreach(word IN LISTS words)
      string(SUBSTRING "${word}" 0 1 initial)
      string(SUBSTRING "${word}" 1 -1 rest)
      string(TOUPPER "${initial}" initial)
      string(APPEND name "${initial}${rest}")
    endforeach()
    add_custom_command(
      OUTPUT ${header}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}/shaders
      COMMAND ${HONEYCOMB_GLSLANG} --quiet --target-env vulkan1.2 --depfile ${header}.d --vn ${name} -o ${header} ${source}
      DEPENDS ${source}
      DEPFILE ${header}.d
      COMMENT "Compiling ${shader}"
      VERBATIM)
    list(APPEND headers ${header})
  endforeach()
  target_sources(${target} PRIVATE ${headers})
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
