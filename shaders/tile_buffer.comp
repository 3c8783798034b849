#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
// Tiles whose points are kept in a slice of a buffer.
#include "tile_slices.glsl"
