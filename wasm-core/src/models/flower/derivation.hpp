// Derives a generalized map from a flower's program, with a record of how each volume's numbers are computed.
//
// A step visits all volumes that exist when it begins, in the order in which they were made. Every production applies
// whose predecessor and condition match; of several that grow on one face the last listed wins, and a face that is not
// free is skipped. Then faces that are adjacent by now are glued. A module is a grammar of its own, with its own step:
// it runs to its end after the volume that calls it has grown (thesis, section 2.2.2).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generalized_map/frame.hpp"
#include "generalized_map/map.hpp"
#include "models/flower/evaluation.hpp"

namespace panicle::flower {

// How a volume was made: enough to compute its numbers again. A split adds another record of the remaining volume.
struct Record {
  enum class Kind : std::uint8_t { axiom, grown, rest, part };
  Kind kind = Kind::axiom;
  bool inherits = false;   // has the numbers of the volume that it grew from, since it has the same label
  std::uint16_t side = 0;  // the side that it grew on, 0 for O and E
  Rank rank;               // of its volume
  std::uint32_t volume = 0;
  std::uint32_t before = invalid;  // the record of the volume that it grew from
  std::uint32_t source = 0;        // number of the growth or split in the program
  std::uint32_t label = 0;         // the label that it was made with
  std::uint32_t instance = 0;      // the instance that it belongs to
  std::uint32_t maker = 0;    // the instance whose production made it: another one for the first volume of a module
  std::uint32_t step = 0;     // of the maker
  std::uint64_t address = 0;  // address of its random values
};

// A call of a module; the first is the text itself.
struct Instance {
  std::uint32_t grammar = 0;
  std::uint32_t depth = 0;
  std::uint64_t address = 0;
};

struct Derived {
  explicit Derived(std::uint32_t darts) : map(darts) {}

  generalized_map::Map map;
  std::vector<Record> records;           // each after those that it refers to
  std::vector<VolumeValues> values;      // of each record
  std::vector<std::uint32_t> record_of;  // by volume, its last
  std::vector<Instance> instances;
  std::vector<std::string> notes;
  bool whole = true;  // no limit ended its growth

  std::uint64_t bytes() const;  // memory that it holds
  // The shape of each volume, for the embedding.
  std::vector<generalized_map::Shape> shapes() const;
};

// Derives a flower. Errors: evaluation, bad_input, limit.
Result<Derived> derive(const Program& program, const Given& given, const Limits& limits = {});

// The values of the records of a map with other given values, where no order, face, condition or number of steps
// depends on them (Variable::rebuilds). Errors: evaluation, bad_input, limit.
Result<std::vector<VolumeValues>> reworked(const Program& program, const Given& given, const Derived& derived,
                                           const Limits& limits = {});

// Whether two texts grow the same map from the same given values, with the same notes.
bool same_map(const Program& program, const Program& other);

// Whether other given values change the map, and not only its vertices' places; true where it is unknown or where an
// evaluation fails.
bool rebuilds(const Program& program, const Given& before, const Given& now, const Limits& limits = {});

}  // namespace panicle::flower
