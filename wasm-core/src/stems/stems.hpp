// The input of tubes: segments, and data about them that only their model has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "stems/segment.hpp"

namespace panicle {

// The shape of a stem's last two radii, as shares of its radius at the end: by default a stub, cut or without children.
struct StemEnd {
  float body = 1;       // of the whole axis
  float tip = 1;        // where it ends, from two radii before
  float flare = 0;      // widening below an organ at its tip
  float height = 0.5f;  // of the rounded end
};

// Segments with, for each, the group it belongs to and the end of an axis that ends with it. Views: the data must
// outlive them. Without `groups` all are of group 0, without `ends` all end as stubs.
struct Stems {
  std::span<const Segment> segments;  // parents first
  std::span<const std::int32_t> groups = {};
  std::span<const StemEnd> ends = {};
  bool jointed = true;  // whether they swell where segments meet, as shoots do at their nodes
  // The cosine of the bend from which on an only child continues with a corner and a round joint, and not in a curve.
  float corner = -2;
  bool tapering = false;  // whether thickness runs on through nodes, as wood's does; else it halts at each

  // The group of a segment; 0 without groups.
  std::int32_t group_of(std::size_t segment) const { return groups.empty() ? 0 : groups[segment]; }
  // The form of a segment's end; a plain one without ends.
  StemEnd end_of(std::size_t segment) const { return ends.empty() ? StemEnd{} : ends[segment]; }
};

}  // namespace panicle
