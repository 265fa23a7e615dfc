#include "models/particles/ribs.hpp"

#include <glm/geometric.hpp>

namespace panicle::particles {

// The base of the ribs as a foot, the point of the ribs nearest to p.
Ribs::Foot Ribs::at_base(const glm::vec3& p) const { return {0, 0, places[0], glm::distance(p, places[0])}; }

// The point of all pieces that is nearest to p.
Ribs::Foot Ribs::nearest(const glm::vec3& p) const {
  return nearest_of(places.size() - 1, [](std::size_t k) { return k + 1; }, p);
}

// The point of some pieces that is nearest to p.
Ribs::Foot Ribs::nearest(const glm::vec3& p, std::span<const std::uint32_t> pieces) const {
  return nearest_of(pieces.size(), [&](std::size_t k) { return std::size_t{pieces[k]}; }, p);
}

// The foot on the nearest of `count` pieces, or at the base. Piece k runs from place `piece(k)` to the next place.
template <class Piece>
Ribs::Foot Ribs::nearest_of(std::size_t count, const Piece& piece, const glm::vec3& p) const {
  const glm::vec3 base = p - places[0];
  std::size_t found = 0;
  float best = glm::dot(base, base);
  for (std::size_t k = 0; k < count; ++k) {
    const float square = square_to(piece(k), p);
    if (!(square < best)) continue;
    best = square;
    found = piece(k);
  }
  return found > 0 ? foot_on(found, p) : at_base(p);
}

// The point `length` below a foot on the way to the base; the base if the way is shorter.
glm::vec3 Ribs::down(const Foot& from, float length) const {
  glm::vec3 place = from.place;
  for (std::size_t at = from.at; at > 0; at = static_cast<std::size_t>(next[at])) {
    const glm::vec3& end = places[static_cast<std::size_t>(next[at])];
    const float piece = glm::distance(place, end);
    if (length <= piece) return piece > 0 ? place + (length / piece) * (end - place) : end;
    length -= piece;
    place = end;
  }
  return place;
}

// Points along all ribs, at most `spacing` apart.
std::vector<glm::vec3> Ribs::sampled(float spacing) const {
  std::vector<glm::vec3> all{places[0]};
  for (std::size_t i = 1; i < places.size(); ++i) {
    const glm::vec3& end = places[static_cast<std::size_t>(next[i])];
    const auto count = static_cast<std::int32_t>(glm::distance(places[i], end) / spacing) + 1;
    for (std::int32_t k = 0; k < count; ++k)
      all.push_back(places[i] + (end - places[i]) * (static_cast<float>(k) / static_cast<float>(count)));
  }
  return all;
}

// The length of the way from a foot down to the base.
float Ribs::length_below(const Foot& from) const {
  float length = 0;
  glm::vec3 place = from.place;
  for (std::size_t at = from.at; at > 0; at = static_cast<std::size_t>(next[at])) {
    const glm::vec3& end = places[static_cast<std::size_t>(next[at])];
    length += glm::distance(place, end);
    place = end;
  }
  return length;
}

}  // namespace panicle::particles
