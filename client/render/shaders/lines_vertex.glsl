// The mesh's lines and points, in one colour.

layout(location = 0) in vec3 a_position;
uniform float u_point_px;
void main() {
  gl_Position = u_world_to_clip * vec4(a_position, 1.0);
#ifdef GL_ES
  // Without an offset of lines: a little nearer than the surface that they lie on.
  gl_Position.z -= 0.00004 * gl_Position.w;
#endif
  gl_PointSize = u_point_px;
}
