// A flower's program → a generalized map that has grown, and how each volume's numbers came about.
//
// All that stood when a step began is looked at, in the order in which it was made. Every production whose predecessor
// and condition fit applies; of several that grow on one face the last listed wins, and a face that is taken is passed
// over. Then faces are glued that have come to be adjacent. A module is a grammar of its own, with its own step: it is
// run to its end when what it grows from has grown (thesis, section 2.2.2).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generalized_map/frame.hpp"
#include "generalized_map/map.hpp"
#include "models/flower/evaluation.hpp"

namespace panicle::flower {

// How a volume came about: enough to work out its numbers anew. A split leaves one more of the volume that is left.
struct Record {
  enum class Kind : std::uint8_t { axiom, grown, rest, part };
  Kind kind = Kind::axiom;
  bool inherits = false;   // the numbers of what it grew from: it has its name
  std::uint16_t side = 0;  // that it grew on, 0 of O and E
  Rank rank;               // of its volume
  std::uint32_t volume = 0;
  std::uint32_t before = invalid;  // the record of what it grew from
  std::uint32_t source = 0;       // which growth or split of the program
  std::uint32_t label = 0;        // that it was made with
  std::uint32_t instance = 0;     // that it belongs to
  std::uint32_t maker = 0;        // the instance whose production made it: another one of what a module begins with
  std::uint32_t step = 0;         // of that one
  std::uint64_t address = 0;      // for luck
};

// A module in its place; the first is the text itself.
struct Instance {
  std::uint32_t grammar = 0;
  std::uint32_t depth = 0;
  std::uint64_t address = 0;
};

struct Derived {
  explicit Derived(std::uint32_t darts) : map(darts) {}

  generalized_map::Map map;
  std::vector<Record> records;           // each after those that it refers to
  std::vector<VolumeValues> values;      // of each
  std::vector<std::uint32_t> record_of;  // by volume, its last
  std::vector<Instance> instances;
  std::vector<std::string> notes;
  bool whole = true;  // no limit ended its growth

  std::uint64_t bytes() const;  // that it holds
  // What the embedding places: of each volume.
  std::vector<generalized_map::Shape> shapes() const;
};

// Errors: evaluation, bad_input, limit.
Result<Derived> derive(const Program& program, const Given& given, const Limits& limits = {});

// The same map with other numbers: for given values that no order, face, condition or number of steps depends on
// (Variable::rebuilds). Errors: evaluation, bad_input, limit.
Result<std::vector<VolumeValues>> reworked(const Program& program, const Given& given, const Derived& derived,
                                           const Limits& limits = {});

// Whether two texts grow the same map from the same that is given, with the same words to it.
bool same_map(const Program& program, const Program& other);

// Whether what has been given changes the map, and not only where its corners are: where it cannot be known, and where
// something cannot be worked out.
bool rebuilds(const Program& program, const Given& before, const Given& now, const Limits& limits = {});

}  // namespace panicle::flower
