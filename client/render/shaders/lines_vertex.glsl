// The mesh's lines and points, in one colour.

layout(location = 0) in vec3 a_position;
uniform float u_point_px;
void main() {
  gl_Position = u_world_to_clip * vec4(a_position, 1.0);
  gl_PointSize = u_point_px;
}
