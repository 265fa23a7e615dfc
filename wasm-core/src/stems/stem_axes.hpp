// Finds the axes of a plant's segments: continuations from segment to segment, and the smooth line through the nodes of
// each axis.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "stems/stems.hpp"

namespace panicle {

// A node that an axis passes through.
struct Node {
  glm::vec3 position{0};
  glm::vec3 tangent{0};      // unit
  float radius = 0;          // of the stem here
  float length = 0;          // straight distance from the node before, 0 at the first
  std::int32_t segment = 0;  // that ends here (of the first node: that begins here)
};

// The stem that an axis comes out of.
struct Origin {
  bool attached = false;   // otherwise it begins in the open
  bool passing = false;    // the parent goes on beyond
  bool corner = false;     // it meets another there, end to end (Stems::corner)
  glm::vec3 direction{0};  // of the parent, unit
  float radius = 0;        // of the parent
  std::uint32_t node = 0;  // of the parent's axis at which it comes out: an index of StemAxes::nodes
};

// A run of segments that one tube covers, as a range of StemAxes::nodes. At least two nodes.
struct StemAxis {
  std::int32_t group = 0;  // that it belongs to (Stems::groups)
  std::uint32_t first = 0, count = 0;
  Origin origin;
  bool to_corner = false;  // whether another goes on from it at a corner
};

struct StemAxes {
  std::vector<Node> nodes;
  std::vector<StemAxis> axes;  // by group, ascending; within a group in the order of their first segments
  float finest = 0;            // no length below this is worth a ring: positions would round together
};

// Continues each segment by the child that bends least, if that belongs to the same group and bends less than 50° (an
// only child: 100°). Segments too short to see are skipped, ones that are not finite left out.
StemAxes find_stem_axes(const Stems& stems);

}  // namespace panicle
