// From tubes to the arrays of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/stem_rings.hpp"
#include "geometry/tubes.hpp"

namespace panicle {

// Writes tubes one after the other. Arrays get a few elements too many at first, since all is written four at a time.
class TubeWriter {
 public:
  // Makes room in `stem`, which must outlive the writer, for `rings` rings in `tubes` tubes.
  TubeWriter(StemMesh& stem, std::uint32_t sides, std::uint64_t rings, std::uint64_t tubes);

  // Appends a tube, its positions scaled.
  void write(const Tube& tube, float scale);
  // Gives back what was too many. Call it last.
  void finish();

  std::uint32_t vertices() const { return vertices_; }
  std::uint32_t indices() const { return indices_; }

  static std::uint64_t vertices_for(std::uint32_t sides, std::uint64_t rings, std::uint64_t tubes) {
    return rings * (sides + 1) + tubes * 2;
  }

 private:
  void write_pole(const glm::vec3& position, const glm::vec3& normal, const Ring& ring);
  void write_ring(const Tube& tube, const Ring& ring, float scale);
  void write_ellipse(float* out, const glm::vec3& centre, const glm::vec3& right, const glm::vec3& forward) const;
  void write_normals(const Tube& tube, const Ring& ring, float* out) const;
  void write_triangles(std::uint32_t first_pole, std::uint32_t rings);

  StemMesh& stem_;
  const std::uint32_t sides_;
  std::uint32_t vertices_ = 0, indices_ = 0;
  std::uint32_t padded_;  // sides, rounded up to a multiple of four
  std::vector<float> cosine_, sine_;
  std::vector<float> cosine_thrice_, sine_thrice_;  // each for x, y and z
  std::vector<float> u_;                            // u and 0 for each vertex of a ring
  std::vector<std::uint32_t> band_;  // indices between a ring and the next, the ring's first vertex being 0
};

}  // namespace panicle
