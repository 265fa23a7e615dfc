// A small bunch for the stages of the natural procedure: a rachis, a twig on it, and pedicels on the twig.
#pragma once

#include <glm/geometric.hpp>
#include <vector>

#include "models/bunch/natural/flowers.hpp"
#include "models/bunch/natural/hanging.hpp"

namespace panicle::tests {

inline bunch::Internode stem(std::int32_t parent, bunch::Kind kind, const glm::vec3& start, const glm::vec3& end,
                             bool joint = false) {
  return {{parent, 0, start, end, 1, 1}, kind, bunch::State::grown, -1, joint};
}

inline bunch::Flower flower_on(std::int32_t parent, const glm::vec3& heading, std::uint32_t id = 0) {
  bunch::Flower flower;
  flower.parent = parent;
  flower.heading = heading;
  flower.id = id;
  flower.address = id + 1;
  return flower;
}

// 0 rachis, 1 twig, 2 and 3 pedicels, 4 a thorn on the twig; flowers on 2 and 3.
struct Twig {
  std::vector<bunch::Internode> internodes{stem(-1, bunch::Kind::rachis, {0, 0, 0}, {0, -50, 0}),
                                           stem(0, bunch::Kind::end, {0, -50, 0}, {20, -50, 0}),
                                           stem(1, bunch::Kind::pedicel, {20, -50, 0}, {30, -50, 0}),
                                           stem(1, bunch::Kind::pedicel, {20, -50, 0}, {20, -60, 0}),
                                           stem(1, bunch::Kind::axis, {20, -50, 0}, {20, -45, 0})};
  std::vector<bunch::Flower> flowers{flower_on(2, {1, 0, 0}, 0), flower_on(3, {0, -1, 0}, 1)};
};

}  // namespace panicle::tests
