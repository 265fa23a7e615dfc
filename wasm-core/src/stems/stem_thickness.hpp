// The thickness of a stem along one axis.
#pragma once

#include <cstdint>
#include <span>

#include "stems/stem_axes.hpp"

namespace panicle {

// A cross-section: an ellipse, elongated in the plane of branch and parent where a branch leaves its parent, else a
// circle.
struct Section {
  float wide = 0;    // half-width in that plane
  float narrow = 0;  // half-width across it
  float lean = 0;    // 0: at right angles to the branch … 1: its width lies along the parent
  float blend = 0;   // share of the parent's normals in those of the branch, so that no edge shows between them
};

// How an axis begins.
enum class Foot : std::uint8_t {
  spread,  // into its parent, or wider in the open
  plain,   // as thick as it is
  inside,  // no wider than its parent as long as it is within that
};

// How thickness runs along an axis (Stems).
struct ThicknessForm {
  bool jointed = true, tapering = false;
  Foot foot = Foot::spread;
};

// The radius along an axis. It is interpolated smoothly from node to node, for tapering stems without a halt there
// (Fritsch & Carlson 1980: never beyond the radii of both nodes), and is, for jointed ones, a little less between them.
// A branch spreads into its parent, within whose surface it begins; its end widens or narrows by StemEnd.
class Thickness {
 public:
  Thickness(std::span<const Node> nodes, const Origin& origin, const StemEnd& end, const ThicknessForm& form);

  // Moves on to the segment that ends at node i: 1, 2, …
  void enter(std::size_t i);
  // The cross-section at the fraction `t` of that segment.
  Section at(float t) const;

 private:
  float taper_at(std::size_t node) const;
  float end_factor(float from_end) const;
  Section collar(float radius, float from_start, float from_end) const;

  std::span<const Node> nodes_;
  Origin origin_;
  StemEnd end_;
  ThicknessForm form_;
  float length_ = 0;                         // of the whole axis
  float per_emergence_ = 0, emergence_ = 0;  // how far from its start a branch leaves its parent's surface
  float per_end_radius_ = 0;
  float from_start_ = 0, step_ = 0;                 // of the segment
  float radius_ = 0, gain_ = 0;                     // at its start, and how much more at its end
  float taper_ = 0, next_taper_ = 0;                // by which radius changes at its start and end, over all of it
  float per_swelling_ = 0, per_next_swelling_ = 0;  // its length over the extents of its nodes
};

}  // namespace panicle
