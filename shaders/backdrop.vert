#version 450

layout(location = 0) out vec2 ndc;

// One triangle that covers the picture.
void main() {
  ndc = vec2(gl_VertexIndex == 1 ? 3 : -1, gl_VertexIndex == 2 ? 3 : -1);
  gl_Position = vec4(ndc, 1, 1);
}
