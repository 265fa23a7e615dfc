#include "models/bunch/natural/flowers.hpp"

#include <algorithm>

#include "models/bunch/berry_ids.hpp"

namespace panicle::bunch {
namespace {

constexpr float least_strength = 0.001f;

// Per internode: how many organs lie between the root and it.
std::vector<std::int32_t> depths_of(std::span<const Internode> internodes) {
  std::vector<std::int32_t> depths;
  depths.reserve(internodes.size());
  for (const Internode& one : internodes)
    depths.push_back(one.parent < 0 ? 0 : depths[static_cast<std::size_t>(one.parent)] + (one.joint ? 0 : 1));
  return depths;
}

// Per internode: how many organs on the way to it belong to an axis that continues beyond an end structure.
std::vector<std::int32_t> onwards_of(std::span<const Internode> internodes) {
  std::vector<std::int32_t> onwards;
  onwards.reserve(internodes.size());
  for (const Internode& one : internodes) {
    const auto parent = static_cast<std::size_t>(one.parent);
    const std::int32_t before = one.parent < 0 ? 0 : onwards[parent];
    const bool goes_on = one.kind == Kind::axis && !one.joint &&
                         (before > 0 || (one.parent >= 0 && internodes[parent].kind == Kind::end));
    onwards.push_back(before + (goes_on ? 1 : 0));
  }
  return onwards;
}

}  // namespace

// The first internode of the organ to which `internode` belongs: an organ is drawn as a chain of internodes, of which
// all but the first are joints.
std::size_t beginning_of(std::span<const Internode> internodes, std::size_t internode) {
  while (internodes[internode].joint) internode = static_cast<std::size_t>(internodes[internode].parent);
  return internode;
}

// Makes a flower of each ball that the text draws, with its place in the hierarchy of axes. Balls from the index
// `second_from` on are of the second bunch.
std::vector<Flower> flowers_of(std::span<const Internode> internodes, std::span<const Ball> balls,
                               std::size_t second_from) {
  std::vector<std::uint64_t> addresses;
  addresses.reserve(balls.size());
  for (const Ball& ball : balls) addresses.push_back(ball.address);
  addresses = own_addresses(addresses);
  const std::vector<std::uint32_t> ids = berry_ids(addresses, second_from);
  const std::vector<std::int32_t> depths = depths_of(internodes);
  const std::vector<std::int32_t> onwards = onwards_of(internodes);
  std::vector<std::int32_t> flowers_on(internodes.size(), 0);
  std::vector<Flower> flowers;
  flowers.reserve(balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const auto parent = static_cast<std::size_t>(balls[i].segment);
    const std::int32_t foot = internodes[beginning_of(internodes, parent)].parent;
    Flower flower;
    flower.parent = balls[i].segment;
    flower.id = ids[i];
    flower.bunch = i < second_from ? 0 : 1;
    flower.address = addresses[i];
    flower.module = i < second_from ? balls[i].module : no_module;
    flower.heading = balls[i].heading;
    flower.axis = internodes[parent].axis;
    flower.depth = depths[parent];
    flower.onward = onwards[parent];
    if (foot >= 0) flower.place = flowers_on[static_cast<std::size_t>(foot)]++;
    flower.strength = std::clamp(balls[i].radius, least_strength, 1.0f);
    flowers.push_back(flower);
  }
  return flowers;
}

// The mean number of flowers on an end structure, the smallest group of flowers; 0 where there is none.
float flowers_per_end(std::span<const Internode> internodes, std::span<const Flower> flowers) {
  const auto ends = std::count_if(internodes.begin(), internodes.end(),
                                  [](const Internode& one) { return one.kind == Kind::end && !one.joint; });
  const auto flowers_on = std::count_if(flowers.begin(), flowers.end(), [&](const Flower& flower) {
    const std::int32_t foot = internodes[beginning_of(internodes, static_cast<std::size_t>(flower.parent))].parent;
    return foot >= 0 && internodes[static_cast<std::size_t>(foot)].kind == Kind::end;
  });
  return ends == 0 ? 0 : static_cast<float>(flowers_on) / static_cast<float>(ends);
}

}  // namespace panicle::bunch
