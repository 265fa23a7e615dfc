// The mesh that crosses the border: flat arrays, counter-clockwise triangles, unit normals.
#pragma once

#include <cstdint>
#include <vector>

namespace panicle {

struct Mesh {
  std::vector<float> positions;        // 3 × vertices
  std::vector<float> normals;          // 3 × vertices
  std::vector<float> uvs;              // 2 × vertices
  std::vector<std::uint32_t> indices;  // 3 × triangles
};

}  // namespace panicle
