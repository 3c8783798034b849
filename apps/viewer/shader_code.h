#pragma once

#include <cstdint>
#include <span>

/// The renderer's shaders as SPIR-V, compiled from shaders/ at build time.
namespace honeycomb::Viewer::ShaderCode {

std::span<const std::uint32_t> shadowVertex();
std::span<const std::uint32_t> cellsVertex();
std::span<const std::uint32_t> cellsFragment();
std::span<const std::uint32_t> linesVertex();
std::span<const std::uint32_t> linesFragment();
std::span<const std::uint32_t> backdropVertex();
std::span<const std::uint32_t> backdropFragment();

}  // namespace honeycomb::Viewer::ShaderCode
