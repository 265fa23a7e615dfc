// How much of the sky a point of a plant sees, weighted by the cosine to its normal, as a byte: 255 all of it, 0 none.
//
// The sky is the whole sphere of directions, as bright everywhere; a point sees the half before its normal. The nearest
// balls are evaluated one by one: a ball wholly above a point's horizon hides sin²α · cos γ of its sky exactly (α:
// apparent radius, γ: angle to the normal), one that sets hides a parabola that meets this smoothly, and visible shares
// are multiplied. All other bodies are summed up about a receiver's centre as constant and cosine, the first two bands
// of Σ sin²α · max(0, cos γ) (Ramamoorthi & Hanrahan 2001); the visible share is e^−sum.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "foundation/lanes.hpp"
#include "spatial/point_grid.hpp"

namespace panicle {

// A body that hides sky: a ball, or a disc of the same radius.
struct SkyBody {
  glm::vec3 centre{0};
  float square = 0;          // of the radius
  glm::vec3 facing{0};       // unit, of a disc: seen edge-on it hides nothing; 0: a ball
  std::int32_t owner = -1;   // it hides nothing from its owner,
  std::int32_t parent = -1;  // nor from its owner's parent, nor from others with the same parent; −1: none
};

// A body, or a piece of one, that is small compared with its distance to others.
struct SkyReceiver {
  glm::vec3 centre{0};
  float extent = 0;         // from the centre to its farthest point
  std::int32_t owner = -1;  // its number, and its parent's; −1: none
  std::int32_t parent = -1;
};

// The pose of a shared mesh: v → centre + scale · (side · x + up · y + front · z); unit vectors at right angles.
struct SkyFrame {
  glm::vec3 centre{0}, side{1, 0, 0}, up{0, 1, 0}, front{0, 0, 1};
  float scale = 1;
};

class Sky {
 public:
  // The most balls that are evaluated one by one. Twelve of a size can touch one; eight are within a hundredth of as
  // good.
  static constexpr std::size_t nearest = 8;

  // `specks` are bodies that each hide a little and are never evaluated one by one: pieces of stems, of leaves. Bodies
  // that are not finite are left out. Balls count up to six radii of the largest from a receiver's centre, specks up to
  // five: sums over farther bodies, most of them hidden behind nearer ones, would leave too little.
  Sky(std::span<const SkyBody> balls, std::span<const SkyBody> specks);

  // Sums up the bodies around a receiver, for the calls of `sample` that follow.
  void set_receiver(const SkyReceiver& receiver);

  // Sets the frame of the receiver's points, until the next receiver.
  void set_frame(const SkyFrame& frame);
  // Computes the sky of points of that receiver: 3 floats each of position and unit normal, as many bytes as there are
  // points.
  void sample(std::span<const float> positions, std::span<const float> normals, std::span<std::uint8_t> sky) const;

 private:
  // Bodies as columns (structure of arrays), by slot of the grid; with three more rows, as padding for reads of four.
  struct BodyTable {
    enum Column : std::size_t { x, y, z, square, radius, facing_x, facing_y, facing_z, round, owner, parent, columns };

    BodyTable(std::span<const SkyBody> bodies, float horizon);
    // The values of a column, one for each body.
    const float* of(Column column) const { return &values[column * stride]; }

    PointGrid grid;
    float largest = 0, reach = 0;
    std::size_t stride = 0;
    std::vector<float> values;  // `round`: 1 for a ball, 0 for a disc; owners as their bits
  };
  struct Near {
    glm::vec3 centre{0};
    float radius = 0;
  };
  struct Vec3x4 {
    Four x, y, z;
  };

  // Sums over bodies around a receiver: the constant, and the vector of the cosine part.
  struct Bands {
    float constant = 0;
    glm::vec3 cosine{0};
  };

  Bands sum(const BodyTable& bodies, const SkyReceiver& receiver, bool look);
  void insert_nearest(std::uint32_t slot, float weight);
  void load_nearest(const glm::vec3& centre);
  Four unoccluded(const Vec3x4& place, const Vec3x4& normal) const;

  BodyTable balls_, specks_;
  std::array<std::uint32_t, nearest> slots_{};  // of the balls looked at, and how large each looks: the largest first
  std::array<float, nearest> weights_{};
  std::array<Near, nearest> near_{};
  std::size_t count_ = 0;
  Bands far_balls_, far_specks_;
};

}  // namespace panicle
