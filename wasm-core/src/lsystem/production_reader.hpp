// One production: `left < predecessor > right : {before} condition {after} --> successor : weight`.
#pragma once

#include "lsystem/token_reader.hpp"

namespace panicle::lsystem {

class ProductionReader : public TokenReader {
 public:
  using TokenReader::TokenReader;

 protected:
  // The one from `at_` up to `end_`, whose arrow stands at `arrow_`. Its errors are said of what it is for.
  bool production(Purpose purpose);

 private:
  bool is_label();
  bool is_value(std::size_t at) const;
  std::uint32_t times_named(std::string_view name);
  bool predecessor(ProductionTree& production);
  bool neighbours(std::size_t end, char side, std::vector<NeighbourTree>& neighbours, std::vector<Named>& beside);
  bool different(const std::vector<Named>& formals);
  bool condition(ProductionTree& production);
  bool block(std::vector<AssignmentTree>& assignments);

  Names words_;                       // all that stands in the text
  std::vector<std::uint32_t> times_;  // how often each word does
};

}  // namespace panicle::lsystem
