// One production: `left < predecessor > right : {before} condition {after} --> successor : weight`.
#pragma once

#include "lsystem/syntax/module_reader.hpp"

namespace panicle::lsystem {

class ProductionReader : public ModuleReader {
 public:
  using ModuleReader::ModuleReader;

 protected:
  // Reads the production from `at_` up to `end_`, whose arrow is at `arrow_`. Error messages depend on its purpose.
  bool production(Purpose purpose);
  // Whether formal parameters are at most as many as a module may have, and have different names.
  bool are_valid(const std::vector<Named>& formals);

 private:
  bool is_label();
  bool is_value(std::string_view name);
  std::uint32_t times_named(std::string_view name);
  void index_words();
  bool predecessor(ProductionTree& production);
  bool neighbours(std::size_t end, char side, std::vector<NeighbourTree>& neighbours, std::vector<Named>& beside);
  bool condition(ProductionTree& production);
  bool block(std::vector<AssignmentTree>& assignments);

  // Of the whole text, filled when the first production may begin with a label:
  Names words_;                       // all tokens
  std::vector<std::uint32_t> times_;  // how often each word occurs
  Names declared_;                    // the names that directives declare, as in #define NAME
};

}  // namespace panicle::lsystem
