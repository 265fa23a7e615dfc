// How thick a stem is along one axis.
#pragma once

#include <cstdint>
#include <span>

#include "geometry/stem_axes.hpp"

namespace panicle {

// How an axis ends: where it was cut or has nothing more to bear, under its berry, or shrivelled.
enum class End : std::uint8_t { stub, receptacle, withered };

// The radius passes smoothly from node to node. Nodes swell a little; a branch spreads towards its bearer, within
// whose surface it begins; a receptacle widens, a withered tip narrows.
class Thickness {
 public:
  Thickness(std::span<const Node> nodes, const Origin& origin, End end);

  // At the fraction `t` of the internode that ends at node i; `from_start` is the distance of node i − 1 from the
  // first.
  float at(std::size_t i, float t, float from_start) const;

 private:
  float at_end(float from_end) const;
  float at_start(float radius, float from_start) const;

  std::span<const Node> nodes_;
  Origin origin_;
  End end_;
  float length_ = 0;     // of the whole axis
  float emergence_ = 0;  // how far from its start a branch leaves its bearer's surface
};

}  // namespace panicle
